// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/io/BodyImport.h"

namespace toile::io {

/// What a file of a body holds: a whole body if we wrote it, else only its surface.
struct BodyFile {
    std::optional<body::Body> body;
    geometry::TriangleMesh mesh; ///< empty when there is a body
};

[[nodiscard]] Result<BodyFile> readBodyFile(const std::filesystem::path& path, const BodyImportSettings& settings,
                                            std::vector<Warning>* warnings);

} // namespace toile::io
