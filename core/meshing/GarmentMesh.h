// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Result.h"
#include "core/meshing/MeshInput.h"

#include <array>
#include <vector>

namespace toile::meshing {

/// x = Σ weight · x(master); weights sum to 1. Chains are resolved: masters are never slaves.
struct SlaveNode {
    int node = 0;
    std::vector<std::pair<int, double>> masters;
    friend bool operator==(const SlaveNode&, const SlaveNode&) = default;
};

/// A grain-parallel rectangle; corners (−weft,−warp), (+weft,−warp), (+weft,+warp), (−weft,+warp).
struct Rectangle {
    std::array<int, 4> nodes{};
    int region = -1; ///< index into PieceInput::regions; −1 = the main region
    friend bool operator==(const Rectangle&, const Rectangle&) = default;
};

/// Counter-clockwise. Triangles of one merged quad name each other.
struct Triangle {
    std::array<int, 3> nodes{};
    int region = -1;
    int mergedWith = -1; ///< index of the other triangle; −1 = none
    friend bool operator==(const Triangle&, const Triangle&) = default;
};

/// A node on a boundary edge.
struct EdgeNode {
    int node = 0;
    double fraction = 0; ///< of the edge's arc length
    friend bool operator==(const EdgeNode&, const EdgeNode&) = default;
};

/// The nodes of one boundary edge from its start to its end, both included. Where many unsewn straight edges much
/// shorter than the spacing follow one another smoothly (a digitised outline), most of their ends are no nodes; such
/// an edge lists the nodes before and behind it.
using EdgeNodes = std::vector<EdgeNode>;

struct PieceMesh {
    std::vector<Vec2> nodes;    ///< in the piece's coordinates [m]
    std::vector<Vec2> material; ///< u weft, v warp [m]: the piece turned so that warp is +y
    std::vector<Rectangle> rectangles;
    std::vector<Triangle> triangles;
    std::vector<SlaveNode> slaves;
    std::vector<std::vector<EdgeNodes>> loops; ///< [loop][edge]; loop 0 = outline
    std::vector<std::vector<int>> folds;       ///< the nodes along each fold, from its first end to its last
    std::vector<std::array<int, 3>> display;   ///< triangles over all nodes without cracks at region joints
    friend bool operator==(const PieceMesh&, const PieceMesh&) = default;
};

struct NodeRef {
    int piece = 0, node = 0;
    friend auto operator<=>(const NodeRef&, const NodeRef&) = default;
};

/// The nodes that are sewn together, first pair at the start of the seam.
struct SeamNodes {
    std::vector<std::array<NodeRef, 2>> pairs;
    friend bool operator==(const SeamNodes&, const SeamNodes&) = default;
};

struct RegionReport {
    std::string label;
    double spacing = 0; ///< used [m]
    int ratio = 1;      ///< u = ε_m / spacing
    int cells = 0;
    double displacement = 0; ///< Hausdorff distance of the final border to the painted one [m]
    double areaChange = 0;   ///< [m²]
    friend bool operator==(const RegionReport&, const RegionReport&) = default;
};

struct FoldReport {
    std::string label;
    int nodes = 0;
    double length = 0;    ///< through the nodes [m]
    double deviation = 0; ///< of the drawn line from the line through the nodes [m]
    friend bool operator==(const FoldReport&, const FoldReport&) = default;
};

/// Quality of one piece; see docs/meshing.md.
struct PieceReport {
    std::string label;
    double spacing = 0;                                                  ///< ε_m of the piece, 0 = of several [m]
    int nodes = 0, slaves = 0, quads = 0, triangles = 0, rectangles = 0; ///< of the displayed mesh
    double rectangleFraction = 0;
    double minimumAngle = 0, maximumAngle = 0, inputMinimumAngle = 0; ///< [rad]
    std::array<int, 181> angles{}; ///< corners of displayed elements by angle in whole degrees, rounded down
    double maximumAspect = 0;
    double neighbourSizeRatio = 0; ///< largest ratio of √area of displayed triangles that share a side [–]
    double sideLength = 0;         ///< of the sides of all displayed elements [m]
    double grainAlignment = 0;     ///< the share of it within 2° of warp or weft [–]
    double areaRelativeError = 0;
    double boundaryDeviation = 0; ///< [m]
    int invertedCells = 0, missingBoundaryNodes = 0, nonManifoldEdges = 0;
    double seconds = 0; ///< of meshing, without the measuring for this report
    std::size_t bytes = 0;
    std::vector<RegionReport> regions;
    std::vector<FoldReport> folds;
    friend bool operator==(const PieceReport&, const PieceReport&) = default;
};

/// The angle that this part [–] of all corners lies below, in whole degrees.
[[nodiscard]] int angleBelow(const PieceReport& report, double part);

struct SeamReport {
    std::string label;
    int countA = 0, countB = 0;                ///< sewing points of each side
    double lengthA = 0, lengthB = 0, ease = 0; ///< ease as declared [m]
    double largestSpacingMismatch = 0;         ///< largest |a − b| / max(a, b) of two sewn stretches [–]
    friend bool operator==(const SeamReport&, const SeamReport&) = default;
};

/// The three conditions of Liu 2002 for two edges that are sewn: equal lengths, equal numbers of sewing points, equal
/// unit lengths.
struct SewnAlike {
    bool length = false; ///< but for the declared ease, within max(1 mm, 0.3 %)
    bool count = false;
    bool unit =
        false; ///< every two sewn stretches differ by no more than the lengths of both sides, and 2 % for chords
};

[[nodiscard]] SewnAlike sewnAlike(const SeamReport& seam);

struct MeshReport {
    std::vector<PieceReport> pieces;
    PieceReport total;
    std::vector<SeamReport> seams;
    std::vector<Warning> warnings;
    friend bool operator==(const MeshReport&, const MeshReport&) = default;
};

/// The meshes of all pieces and how they are sewn.
struct GarmentMesh {
    std::vector<PieceMesh> pieces;
    std::vector<SeamNodes> seams;
    MeshReport report;
    friend bool operator==(const GarmentMesh&, const GarmentMesh&) = default;
};

struct MeshSettings {
    bool judged = true; ///< measure angles, areas and topology for the report; a preview only needs the counts
};

/// Meshes all pieces, seams first. Errors name piece, edge and point.
[[nodiscard]] Result<GarmentMesh> meshGarment(const MeshInput& input, const MeshSettings& settings = {});

} // namespace toile::meshing
