// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/batch/Opening.h"

#include "core/document/DocumentEdits.h"
#include "core/io/BodyImport.h"
#include "core/io/DocumentFile.h"
#include "core/simulation/Arrange.h"

namespace toile::batch {

Result<OpenedScene> openScene(const document::Document& document, const std::filesystem::path& documentFile,
                              const std::filesystem::path& otherAvatar) {
    OpenedScene opened;
    std::optional<Shared<body::Body>> own;
    if (!document.avatarFile.empty()) {
        opened.avatar = io::fileNamedBy(documentFile, document.avatarFile).string();
        auto body = io::readBody(opened.avatar, {}, &opened.warnings);
        if (!body) return tl::unexpected(body.error());
        own = Shared<body::Body>(std::move(*body));
    }
    if (otherAvatar.empty()) {
        opened.scene = document::sceneOf(document, own);
        return opened;
    }
    opened.avatar = otherAvatar.string();
    auto other = io::readBody(otherAvatar, {}, &opened.warnings);
    if (!other) return tl::unexpected(other.error());
    document::Document rearranged = document;
    if (own) rearranged.pattern = simulation::arrangedOn(document.pattern, **own, *other);
    opened.scene = document::sceneOf(rearranged, Shared<body::Body>(std::move(*other)));
    return opened;
}

} // namespace toile::batch
