// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/meshing/PieceBoundary.h"

#include <array>
#include <span>
#include <vector>

namespace toile::meshing {

/// The coordinate that the lines of an axis are set on. Axis 0: lines along the warp, at x; axis 1: along the
/// weft.
constexpr double along(Vec2 point, int axis) {
    return axis == 0 ? point.x : point.y;
}

/// Equal parts, none longer than the spacing.
[[nodiscard]] int partsOf(double distance, double spacing);

/// A straight edge that the lines of one axis cross at right angles, so that they can pass through its nodes.
struct GrainSpan {
    int loop = 0, edge = 0;
    double start = 0, end = 0; ///< coordinates of the edge's ends along the axis, in the frame [m]

    [[nodiscard]] double low() const { return start < end ? start : end; }
    [[nodiscard]] double high() const { return start < end ? end : start; }
    [[nodiscard]] double at(double fraction) const { return start + (end - start) * fraction; }
    [[nodiscard]] double fractionOf(double place) const { return (place - start) / (end - start); }
};

/// The spans of a piece that are no shorter than its spacing.
[[nodiscard]] std::pmr::vector<GrainSpan> grainSpans(const PieceInput& piece, const PieceBoundary& boundary, int axis,
                                                     Arena& arena);

/// Where nodes must lie on the border of a piece: [loop][edge], rising fractions of arc length from 0 to 1.
using PiecePoints = std::pmr::vector<std::pmr::vector<std::pmr::vector<double>>>;

/// A stretch of a span between fixed points, divided into equal parts.
struct GrainStretch {
    double low = 0, high = 0; ///< along the axis, in the frame [m]
    int parts = 1;
    friend bool operator==(const GrainStretch&, const GrainStretch&) = default;
};

/// By axis.
using GrainStretches = std::array<std::pmr::vector<GrainStretch>, 2>;

/// The stretches of a piece's spans that its fixed points, by [loop][edge], make; as many parts as the
/// spacing asks for.
[[nodiscard]] GrainStretches grainStretches(const PieceInput& piece, const PieceBoundary& boundary,
                                            const PiecePoints& fixedPoints, Arena& arena);

/// How many times the lines that the spacing asks for a stretch may have [–]: twice in a band, whose cells
/// are few.
[[nodiscard]] double mostPartsAcross(double extentAcross, double spacing);

/// A coordinate that asks for a main line.
struct LineWish {
    double at = 0;     ///< in the frame [m]
    double weight = 0; ///< length of border that gains by it [m]
};

/// Coordinates of the grain-parallel straight edges and folds that run along the lines of an axis, with their lengths;
/// equal ones are joined, the longest first.
[[nodiscard]] std::pmr::vector<LineWish> grainLines(const PieceInput& piece, const PieceFrame& frame, int axis,
                                                    Arena& arena);

/// Where main lines of an axis are asked for, by the ends of stretches and the edges along the lines; rising.
/// Of two places nearer than half the spacing, that of more border stays.
[[nodiscard]] std::pmr::vector<double> linePlaces(const PieceInput& piece, const PieceFrame& frame, int axis,
                                                  std::span<const GrainStretch> stretches, Arena& arena);

} // namespace toile::meshing
