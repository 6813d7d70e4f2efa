// SPDX-License-Identifier: GPL-3.0-or-later
#include "samples/Strokes.h"

namespace toile::samples {

using namespace pattern;
using geometry::Curve;

EdgeId edgeId(const std::string& piece, const std::string& name) {
    return EdgeId{piece + "." + name};
}
VertexId vertexId(const std::string& piece, const std::string& name) {
    return VertexId{piece + "." + name};
}

Stroke line(std::string vertex, std::string edge, Vec2 from, Vec2 to) {
    return {std::move(vertex), std::move(edge), {from, to, geometry::LineShape{}}};
}

Stroke cubic(std::string vertex, std::string edge, Vec2 from, Vec2 handle1, Vec2 handle2, Vec2 to) {
    return {std::move(vertex), std::move(edge), {from, to, geometry::CubicShape{from + handle1, to + handle2}}};
}

Stroke arc(std::string vertex, std::string edge, Vec2 from, double bulge, Vec2 to) {
    return {std::move(vertex), std::move(edge), {from, to, geometry::ArcShape{bulge}}};
}

Contour contourOf(const std::string& piece, const std::vector<Stroke>& strokes) {
    Contour contour;
    for (std::size_t i = 0; i < strokes.size(); ++i) {
        const Stroke& stroke = strokes[i];
        expects(distance(stroke.curve.end, strokes[(i + 1) % strokes.size()].curve.start) < 1e-12,
                "each stroke starts where the one before ends");
        contour.vertices.push_back({vertexId(piece, stroke.vertex), stroke.curve.start});
        contour.edges.push_back({edgeId(piece, stroke.edge), stroke.curve.shape, {}});
    }
    return contour;
}

std::vector<Stroke> wholeFromHalf(const std::vector<Stroke>& half, const std::string& topCentre,
                                  const std::string& suffixPositive, const std::string& suffixNegative) {
    std::vector<Stroke> whole;
    for (const Stroke& stroke : half)
        whole.push_back({whole.empty() ? stroke.vertex : stroke.vertex + suffixPositive, stroke.edge + suffixPositive,
                         stroke.curve});
    for (std::size_t i = half.size(); i-- > 0;) {
        const Curve image = geometry::reversed(geometry::mirrored(half[i].curve, {0, 0}, {0, 1}));
        whole.push_back({i + 1 == half.size() ? topCentre : half[i + 1].vertex + suffixNegative,
                         half[i].edge + suffixNegative, image});
    }
    return whole;
}

std::vector<Stroke> rectangle(Vec2 low, Vec2 high) {
    const Vec2 lowRight{high.x, low.y}, highLeft{low.x, high.y};
    return {line("bottom-left", "bottom", low, lowRight), line("bottom-right", "right", lowRight, high),
            line("top-right", "top", high, highLeft), line("top-left", "left", highLeft, low)};
}

} // namespace toile::samples
