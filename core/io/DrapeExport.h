// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Result.h"
#include "core/simulation/Frame.h"

#include <filesystem>
#include <span>
#include <string>

namespace toile::io {

/// Writes a drape in the format that the path's extension names; the old file stays until the new one is whole.
///
/// | .glb | one node and mesh per piece; normals, flat pattern as texture coordinates, both sides drawn |
/// | .obj | one group per piece; quads where the mesh has them; flat pattern as `vt` |
/// | .ply | binary; normals, flat pattern as s and t, the number of the piece with each face |
/// | .stl | binary; triangles only |
///
/// Lengths are metres throughout, y up; texture coordinates are metres of the flat pattern, u weft, v warp.
/// positions: of the topology's vertices [m].
[[nodiscard]] Result<void> writeDrape(const std::filesystem::path& path, const simulation::FrameTopology& topology,
                                      std::span<const Vec3> positions);

// The same as bytes. The positions are finite and as many as the topology has vertices.
[[nodiscard]] std::string drapeGlb(const simulation::FrameTopology& topology, std::span<const Vec3> positions);
[[nodiscard]] std::string drapeObj(const simulation::FrameTopology& topology, std::span<const Vec3> positions);
[[nodiscard]] std::string drapePly(const simulation::FrameTopology& topology, std::span<const Vec3> positions);
[[nodiscard]] std::string drapeStl(const simulation::FrameTopology& topology, std::span<const Vec3> positions);

} // namespace toile::io
