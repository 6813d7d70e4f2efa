// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Result.h"
#include "core/body/Landmarks.h"
#include "core/io/BodySize.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

namespace toile::io {

struct BodyImportSettings {
    std::optional<LengthUnit> unit;          ///< of the file; none = judged by the height of the body
    bool isHuman = true;                     ///< false: a table, a cylinder; its size is not judged
    std::uint64_t largestFile = 500'000'000; ///< [bytes]
    double patience = 60;                    ///< for the reader of a foreign format [s]
    double weldDistance = 1e-5;              ///< vertices nearer than this are one [m]
};

/// The surface of a body in metres, y up, welded: every vertex of the surface once. Reads GLB, glTF, OBJ, STL, PLY,
/// DAE and FBX. What was assumed is added to the warnings.
[[nodiscard]] Result<geometry::TriangleMesh> readBodyMesh(const std::filesystem::path& path,
                                                          const BodyImportSettings& settings = {},
                                                          std::vector<Warning>* warnings = nullptr);

/// The same with landmarks and limb axes: those that writeBody put into the file, else those recognised in the shape;
/// none for what is not human.
[[nodiscard]] Result<body::Body> readBody(const std::filesystem::path& path, const BodyImportSettings& settings = {},
                                          std::vector<Warning>* warnings = nullptr);

/// Writes a body as GLB, with name, landmarks and limb axes in `asset.extras.toile.body` (docs/formats/body.md).
/// Reading it gives the same landmarks and axes; positions of the mesh are rounded to floats.
[[nodiscard]] Result<void> writeBody(const std::filesystem::path& path, const body::Body& body);

} // namespace toile::io
