// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/BodyImport.h"

#include "core/body/Mannequin.h"
#include "core/io/BodyFile.h"

namespace toile::io {

Result<body::Body> readBody(const std::filesystem::path& path, const BodyImportSettings& settings,
                            std::vector<Warning>* warnings) {
    auto file = readBodyFile(path, settings, warnings);
    if (!file) return tl::unexpected(file.error());
    if (file->body) return std::move(*file->body);
    if (!settings.isHuman) return body::Body{path.stem().string(), std::move(file->mesh), {}, {}};
    auto body = body::recognizedBody(path.stem().string(), std::move(file->mesh));
    if (!body && body.error().place.file.empty()) body.error().place.file = path.string();
    return body;
}

} // namespace toile::io
