// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/pattern/Pattern.h"

#include <string>
#include <vector>

namespace toile::samples {

/// One edge of an outline as it is drawn, with the trade names of the edge and of the corner it starts from.
struct Stroke {
    std::string vertex, edge;
    geometry::Curve curve;
};

[[nodiscard]] Stroke line(std::string vertex, std::string edge, Vec2 from, Vec2 to);
/// handle1 and handle2 are measured from the curve's own ends [m].
[[nodiscard]] Stroke cubic(std::string vertex, std::string edge, Vec2 from, Vec2 handle1, Vec2 handle2, Vec2 to);
/// bulge as in geometry::ArcShape.
[[nodiscard]] Stroke arc(std::string vertex, std::string edge, Vec2 from, double bulge, Vec2 to);

/// A closed contour; ids are "PIECE.NAME", so that corners and edges are found by their trade names.
[[nodiscard]] pattern::Contour contourOf(const std::string& piece, const std::vector<Stroke>& strokes);

/// From half of a symmetric piece, drawn on x ≥ 0 from the bottom centre to the top centre, the whole outline.
/// Names get the suffix of their side; the corners on the centre line keep theirs, topCentre is the upper one's.
[[nodiscard]] std::vector<Stroke> wholeFromHalf(const std::vector<Stroke>& half, const std::string& topCentre,
                                                const std::string& suffixPositive, const std::string& suffixNegative);

/// Corner names, counter-clockwise from (left, bottom): bottom-left, …; edges bottom, right, top, left.
[[nodiscard]] std::vector<Stroke> rectangle(Vec2 low, Vec2 high);

[[nodiscard]] pattern::EdgeId edgeId(const std::string& piece, const std::string& name);
[[nodiscard]] pattern::VertexId vertexId(const std::string& piece, const std::string& name);

} // namespace toile::samples
