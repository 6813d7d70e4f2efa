// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/BodyFile.h"

namespace toile::io {

Result<geometry::TriangleMesh> readBodyMesh(const std::filesystem::path& path, const BodyImportSettings& settings,
                                            std::vector<Warning>* warnings) {
    auto file = readBodyFile(path, settings, warnings);
    if (!file) return tl::unexpected(file.error());
    return file->body ? std::move(file->body->mesh) : std::move(file->mesh);
}

} // namespace toile::io
