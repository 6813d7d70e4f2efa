// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/DocumentEdits.h"

#include "core/simulation/SceneCheck.h"

#include <utility>

namespace toile::document {

Result<Document> edited(const Document& document,
                        const std::function<Result<Pattern>(const Pattern&, IdSource&)>& edit) {
    IdSource ids{document.nextId};
    auto pattern = edit(document.pattern, ids);
    if (!pattern) return tl::unexpected<Error>(std::move(pattern).error());
    Document next = document;
    next.pattern = *std::move(pattern);
    next.nextId = ids.next;
    return next;
}

Document withAvatar(const Document& document, std::string file) {
    Document next = document;
    next.avatarFile = std::move(file);
    return next;
}

Result<Document> withScene(const Document& document, const simulation::SceneSettings& scene) {
    if (const auto problems = simulation::checkScene(scene); !problems.empty())
        return fail(ErrorCode::invalidInput, problems.front().text, problems.front().place);
    Document next = document;
    next.scene = scene;
    return next;
}

simulation::Scene sceneOf(const Document& document, std::optional<Shared<body::Body>> body) {
    return {document.pattern, std::move(body), document.scene};
}

} // namespace toile::document
