// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/Layouts.h"

#include "core/base/Contracts.h"
#include "core/study/EachPiece.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace toile::study {
namespace {

using pattern::Pattern;

double leastSpacing(const Pattern& pattern) {
    double least = std::numeric_limits<double>::infinity();
    for (const auto& piece : pattern.pieces) least = std::min(least, piece->spacing);
    return least;
}

simulation::Scene withPattern(simulation::Scene scene, Pattern pattern) {
    scene.pattern = std::move(pattern);
    return scene;
}

/// Every region moved along the length of its piece to the farther end.
Pattern movedAway(const Pattern& pattern) {
    return eachPiece(pattern, [](pattern::Piece& piece) {
        std::vector<Vec2> corners;
        for (const auto& vertex : piece.outline.vertices) corners.push_back(vertex.position);
        const geometry::Box2 extent = geometry::boundsOf(corners);
        const Vec2 size = extent.high - extent.low;
        const auto along = [&](Vec2 v) { return size.y >= size.x ? Vec2{0, v.y} : Vec2{v.x, 0}; };
        const auto within = [&](Vec2 p) {
            return Vec2{std::clamp(p.x, extent.low.x, extent.high.x), std::clamp(p.y, extent.low.y, extent.high.y)};
        };
        for (auto& region : piece.regions) {
            for (Vec2& point : region.outline) point = within(point); // what lies beyond the piece would come in
            const geometry::Box2 own = geometry::boundsOf(region.outline);
            const Vec2 down = along(extent.low - own.low), up = along(extent.high - own.high);
            const Vec2 way = length(down) >= length(up) ? down : up;
            for (Vec2& point : region.outline) point += way;
            for (geometry::Polygon& hole : region.holes)
                for (Vec2& point : hole) point += way;
        }
    });
}

} // namespace

std::string_view nameOf(LayoutKind kind) {
    switch (kind) {
    case LayoutKind::coarse: return "uniform coarse";
    case LayoutKind::regions: return "regions";
    case LayoutKind::paper: return "regions, the paper's rule";
    case LayoutKind::elsewhere: return "regions in a wrong place";
    case LayoutKind::asManyPoints: return "uniform, as many particles";
    case LayoutKind::fine: break;
    }
    return "uniform fine";
}

bool isUniform(LayoutKind kind) {
    return kind == LayoutKind::coarse || kind == LayoutKind::asManyPoints || kind == LayoutKind::fine;
}

std::optional<double> finestSpacing(const Pattern& pattern) {
    std::optional<double> finest;
    for (const auto& piece : pattern.pieces)
        for (const auto& region : piece->regions)
            if (region.refinement > 0)
                finest = std::min(finest.value_or(std::numeric_limits<double>::infinity()),
                                  std::ldexp(piece->spacing, -region.refinement));
    return finest;
}

Layout uniformLayout(const simulation::Scene& scene, LayoutKind kind, double spacing) {
    return {kind, withPattern(scene, uniformCoarser(scene.pattern, spacing / leastSpacing(scene.pattern))), spacing};
}

Layout layoutOf(const simulation::Scene& scene, LayoutKind kind) {
    const auto finest = finestSpacing(scene.pattern);
    expects(finest && kind != LayoutKind::asManyPoints, "a layout that regions alone decide");
    const double main = leastSpacing(scene.pattern);
    const auto byPapersRule = [](pattern::Piece& piece) { piece.rule = pattern::LineRule::paper; };
    switch (kind) {
    case LayoutKind::coarse: return uniformLayout(scene, kind, main);
    case LayoutKind::paper: return {kind, withPattern(scene, eachPiece(scene.pattern, byPapersRule)), *finest};
    case LayoutKind::elsewhere: return {kind, withPattern(scene, movedAway(scene.pattern)), *finest};
    case LayoutKind::fine: return uniformLayout(scene, kind, *finest);
    case LayoutKind::regions:
    case LayoutKind::asManyPoints: break;
    }
    return {kind, scene, *finest};
}

Layout asManyPoints(const simulation::Scene& scene, int coarse, int regions) {
    const double spacing = leastSpacing(scene.pattern) * std::sqrt(static_cast<double>(coarse) / regions);
    return uniformLayout(scene, LayoutKind::asManyPoints, spacing);
}

} // namespace toile::study
