// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/Curve.h"
#include "core/geometry/Polygon.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace toile::meshing {

using geometry::Curve;
using geometry::Polygon;

/// How scan lines are chosen (docs/meshing.md).
enum class LineRule {
    regular,  ///< ours: a regular grid whose lines lie on the longest grain-parallel edges
    features, ///< lines through corners, notches, region corners and seam ends
    paper,    ///< Liu 2002, literally: a line through every authored vertex
};

/// What becomes of a region's painted border.
enum class RegionBorder {
    snap,  ///< the nearest edges of main cells, as the paper does
    exact, ///< its straight grain-parallel parts become grid lines
};

struct BoundaryEdge {
    Curve curve;
    std::vector<double> notches; ///< fractions of the arc length, rising, in [0, 1]
    std::string label;           ///< the user's name, for messages
    friend bool operator==(const BoundaryEdge&, const BoundaryEdge&) = default;
};

/// A closed chain of edges: each starts where the one before ends.
using BoundaryLoop = std::vector<BoundaryEdge>;

struct RegionInput {
    std::string label;
    Polygon outline;
    std::vector<Polygon> holes;
    int refinement = 1; ///< m ≥ 0: spacing ε_m / 2^m
    friend bool operator==(const RegionInput&, const RegionInput&) = default;
};

/// A place on the border.
struct FoldEndInput {
    int loop = 0, edge = 0;
    double fraction = 0; ///< of the edge's arc length
    friend bool operator==(const FoldEndInput&, const FoldEndInput&) = default;
};

/// A line inside a piece, from border to border, that the mesh has nodes and sides along.
struct FoldInput {
    std::string label;
    std::vector<Vec2> points; ///< the first and the last where the ends are
    std::array<FoldEndInput, 2> ends;
    friend bool operator==(const FoldInput&, const FoldInput&) = default;
};

struct PieceInput {
    std::string label;
    BoundaryLoop outline;            ///< counter-clockwise
    std::vector<BoundaryLoop> holes; ///< clockwise
    double grain = 0;                ///< direction of warp from +y, counter-clockwise [rad]
    double spacing = 0.02;           ///< ε_m [m]
    std::vector<RegionInput> regions;
    std::vector<FoldInput> folds;
    LineRule rule = LineRule::regular;
    RegionBorder border = RegionBorder::snap;
    bool mirrored = false; ///< mesh the mirror image (x ↦ −x of the grain frame) and reflect back, so that a pair of
                           ///< pieces gets a mirror pair of meshes
    friend bool operator==(const PieceInput&, const PieceInput&) = default;
};

/// A stretch of a boundary edge, from < to along the loop's direction; reversed = walked from `to` to `from`.
struct SeamPartInput {
    int piece = 0;
    int loop = 0; ///< 0 = outline, 1 … = holes
    int edge = 0;
    double from = 0, to = 1; ///< fractions of the arc length
    bool reversed = false;
};

struct SeamSectionInput {
    double ease = 0;                   ///< wanted length A − length B [m]
    std::optional<double> gatherRatio; ///< wanted length A / length B
};

struct SeamInput {
    std::string label;
    std::array<std::vector<SeamPartInput>, 2> sides;
    std::vector<SeamSectionInput> sections; ///< empty = none declared
};

/// Everything the mesher needs to know; metres. Whoever knows patterns builds it.
struct MeshInput {
    std::vector<PieceInput> pieces;
    std::vector<SeamInput> seams;
};

} // namespace toile::meshing
