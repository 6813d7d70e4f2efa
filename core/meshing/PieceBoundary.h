// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Arena.h"
#include "core/base/Result.h"
#include "core/meshing/PieceFrame.h"

#include <string>
#include <vector>

namespace toile::meshing {

/// A boundary edge with its arc-length table.
struct EdgeArc {
    geometry::ArcLength arc;
    double length = 0;      ///< [m]
    bool collapsed = false; ///< both ends are one grid point, or it is half of a spike: no border of the piece
};

struct LoopBoundary {
    std::vector<EdgeArc> edges;
    bool backwards = false; ///< in the frame, the piece lies to the right of the edges as given
};

/// A piece that has passed the gate: no later step can fail on its shape.
struct PieceBoundary {
    PieceFrame frame;
    std::vector<LoopBoundary> loops;
    std::vector<std::vector<GridPoint>> contours; ///< flattened; the piece lies to the left
    geometry::Box2 box;                           ///< in the frame [m]
    double area = 0;                              ///< of the flattened piece [m²]
};

/// The words of messages: piece "Back", piece "Back", edge "armhole", …
[[nodiscard]] std::string nameOf(const PieceInput& piece);
[[nodiscard]] std::string nameOf(const PieceInput& piece, int loop, int edge);
/// "(12.3, −4.0) mm"
[[nodiscard]] std::string pointText(Vec2 point);
[[nodiscard]] std::string millimetres(double length);
[[nodiscard]] std::string micrometres(double length);

[[nodiscard]] const BoundaryLoop& loopOf(const PieceInput& piece, int loop);
[[nodiscard]] int loopCount(const PieceInput& piece);

/// Refuses what is no piece of cloth and lays the integer grid. Overwrites the boundary, even if it refuses.
[[nodiscard]] Result<void> checkBoundary(const PieceInput& piece, Arena& arena, PieceBoundary& boundary);

} // namespace toile::meshing
