// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/meshing/PolygonOverlap.h"

#include <algorithm>
#include <cmath>

namespace toile::meshing {
namespace {

struct Side {
    Vec2 low, high; ///< low.y < high.y
    bool ofA;

    [[nodiscard]] double xAt(double y) const { return low.x + (high.x - low.x) * (y - low.y) / (high.y - low.y); }
};

void appendSides(const Polygons& polygons, bool ofA, std::pmr::vector<Side>& sides) {
    for (const auto& polygon : polygons)
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            Vec2 p = polygon[i], q = polygon[(i + 1) % polygon.size()];
            if (p.y == q.y) continue;
            if (p.y > q.y) std::swap(p, q);
            sides.push_back({p, q, ofA});
        }
}

/// Where the order of the sides may change: ends and crossings of sides, by height.
std::pmr::vector<double> heightsOf(std::span<const Side> sides, Arena& arena) {
    std::pmr::vector<double> heights(&arena);
    for (std::size_t i = 0; i < sides.size(); ++i) {
        const Side& s = sides[i];
        heights.push_back(s.low.y);
        heights.push_back(s.high.y);
        const auto [left, right] = std::minmax(s.low.x, s.high.x);
        for (std::size_t j = i + 1; j < sides.size(); ++j) {
            const Side& t = sides[j];
            const double y0 = std::max(s.low.y, t.low.y), y1 = std::min(s.high.y, t.high.y);
            if (y0 >= y1 || std::max(t.low.x, t.high.x) < left || std::min(t.low.x, t.high.x) > right) continue;
            const double before = s.xAt(y0) - t.xAt(y0), after = s.xAt(y1) - t.xAt(y1);
            if (before * after < 0) heights.push_back(y0 + (y1 - y0) * before / (before - after));
        }
    }
    std::sort(heights.begin(), heights.end());
    heights.erase(std::unique(heights.begin(), heights.end()), heights.end());
    return heights;
}

/// Length of the common part along a horizontal line; `crossings` is room to work in.
double commonLength(std::span<const Side> active, double y, std::pmr::vector<std::pair<double, bool>>& crossings) {
    crossings.clear();
    for (const Side& side : active) crossings.emplace_back(side.xAt(y), side.ofA);
    std::sort(crossings.begin(), crossings.end());
    bool inA = false, inB = false;
    double length = 0, from = 0;
    for (const auto& [x, ofA] : crossings) {
        if (inA && inB) length += x - from;
        (ofA ? inA : inB) = !(ofA ? inA : inB);
        from = x;
    }
    return length;
}

} // namespace

double overlapArea(const Polygons& a, const Polygons& b, Arena& arena) {
    std::pmr::vector<Side> sides(&arena);
    appendSides(a, true, sides);
    appendSides(b, false, sides);
    std::sort(sides.begin(), sides.end(), [](const Side& s, const Side& t) { return s.low.y < t.low.y; });
    const std::pmr::vector<double> heights = heightsOf(sides, arena);
    std::pmr::vector<Side> active(&arena);
    std::pmr::vector<std::pair<double, bool>> crossings(&arena);
    std::size_t next = 0;
    double area = 0;
    for (std::size_t k = 0; k + 1 < heights.size(); ++k) { // between two heights the length is linear
        while (next < sides.size() && sides[next].low.y <= heights[k]) active.push_back(sides[next++]);
        std::erase_if(active, [&](const Side& side) { return side.high.y <= heights[k]; });
        area += commonLength(active, 0.5 * (heights[k] + heights[k + 1]), crossings) * (heights[k + 1] - heights[k]);
    }
    return area;
}

bool covers(const Polygons& polygons, Vec2 point) {
    bool inside = false;
    for (const auto& polygon : polygons) inside ^= geometry::windingNumber(polygon, point) % 2 != 0;
    return inside;
}

} // namespace toile::meshing
