// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/picture/RenderScene.h"

#include <array>
#include <cstdint>
#include <vector>

namespace toile::picture {

/// A vertex as the graphics card gets it.
struct SurfaceVertex {
    std::array<float, 3> position{}; ///< [m]
    std::array<float, 3> normal{};   ///< of unit length, of the right side
    float cavity = 0;                ///< how hollow the right side is here, as the sky sees it, −1 … 1 [–]
};

/// Smooth normals and cavities of a surface. Positions that are not finite become the origin, so that a
/// broken simulation can still be looked at. A seam's pairs of vertices that lie in one place are one point of the
/// surface, unless it is folded there by more than 90°.
[[nodiscard]] std::vector<SurfaceVertex>
surfaceVertices(const std::vector<Vec3>& positions, const std::vector<geometry::TriangleIndices>& triangles,
                const std::vector<std::vector<std::array<int, 2>>>& seams = {});

/// Red, green, blue of each triangle of the cloth's right side. The fourth byte is 255, or 160 where it shows a right
/// side to either side; where its piece is selected 96 or 0.
[[nodiscard]] std::vector<std::array<std::uint8_t, 4>> triangleColours(const RenderScene& scene,
                                                                       const simulation::FrameTopology& topology);

/// Lines of one seam: along both sides where neighbours in the seam are joined by an edge of the mesh, and
/// from side to side. Pairs of vertex indices.
struct SeamLines {
    std::vector<std::array<int, 2>> along, across;
};
[[nodiscard]] std::vector<SeamLines> seamLines(const simulation::FrameTopology& topology);

/// The edges round each piece, its holes included, by index of the piece. Pairs of vertex indices.
[[nodiscard]] std::vector<std::vector<std::array<int, 2>>> pieceBorders(const simulation::FrameTopology& topology);

} // namespace toile::picture
