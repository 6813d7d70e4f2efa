// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Result.h"
#include "core/base/Shared.h"
#include "core/body/Landmarks.h"
#include "core/geometry/Vec.h"
#include "core/simulation/Phase.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace toile::simulation {

/// What of a frame does not change while the document stays the same: shared by all frames of a generation.
/// Vertices are the nodes of all pieces in the order of the pattern, each piece's in one run.
struct FrameTopology {
    struct PieceRange {
        std::string id, name;
        int firstVertex = 0, vertexCount = 0;
        int firstTriangle = 0, triangleCount = 0;
        bool rightSidesOnly = false; ///< of several plies: it shows a right side to either side
    };
    std::vector<PieceRange> pieces;
    std::vector<std::array<int, 3>> triangles;          ///< the right side is counter-clockwise
    std::vector<int> triangleRegion;                    ///< −1 = main region
    std::vector<Vec2> material;                         ///< u weft, v warp of each vertex [m]
    std::vector<std::vector<std::array<int, 2>>> seams; ///< pairs of vertices, by seam of the pattern
    struct PinnedVertex {
        int vertex = 0;
        bool toBody = false; ///< carried along where the body moves
        friend bool operator==(const PinnedVertex&, const PinnedVertex&) = default;
    };
    std::vector<PinnedVertex> pins;            ///< of the pattern
    std::vector<std::array<int, 2>> meshLines; ///< edges of the scan-line mesh, for wireframes
};

/// What statics does with a garment that came to rest (Runner::finishAtRest).
enum class Finish {
    none,
    underWay,
    found,    ///< the garment lies in its equilibrium
    notFound, ///< it lies as near to it as statics came
};

/// A picture of the running simulation: a value for other threads.
struct Frame {
    std::uint64_t generation = 0; ///< of the scene it belongs to
    Shared<FrameTopology> topology;
    std::vector<Vec3> positions;            ///< of the topology's vertices [m]
    std::optional<Shared<body::Body>> body; ///< as it stands now, if not as the scene has it
    bool bodyMoves = false;                 ///< its pose is one on the way
    Phase phase = Phase::sewing;            ///< draping: the garment is put on, and left to itself
    double time = 0;                        ///< simulated [s]
    double framesPerSecond = 0;             ///< simulated frames computed a second
    int particles = 0;
    double largestSeamGap = 0; ///< over seams not merged yet [m]
    double largestSpeed = 0;   ///< [m/s]
    bool atRest = false;
    Finish finish = Finish::none;
    double finishMove = 0;         ///< how far statics moved any vertex [m]
    std::vector<Warning> warnings; ///< of a garment that statics is done with: warningsOf()
    std::string message;           ///< what the user should know, e.g. why it stopped
};

} // namespace toile::simulation
