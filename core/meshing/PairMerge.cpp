// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/meshing/PairMerge.h"
#include "core/base/Index.h"

#include <algorithm>
#include <cmath>

namespace toile::meshing {
namespace {

/// Angles within 45–140°: squares of the cosines of both.
constexpr double squaredCosineOfLeast = 0.5, squaredCosineOfMost = 0.586824088833465;

} // namespace

/// Both triangles at a side as a quadrilateral.
void PairMerger::judge(const Strip& strip, int side) {
    const TriangleSides& sides = strip.sides;
    const int twin = sides.twinOf(side);
    if (strip.region[at(side / 3)] != strip.region[at(twin / 3)]) return;
    const int low = sides.startOf(side), high = sides.endOf(side);
    const std::array<int, 4> quad{low, sides.apexOf(twin), high, sides.apexOf(side)};
    std::array<Vec2, 4> way; // from corner to corner
    for (std::size_t i = 0; i < 4; ++i) way[i] = strip.places[at(quad[(i + 1) % 4])] - strip.places[at(quad[i])];
    for (std::size_t i = 0; i < 4; ++i)
        if (cross(way[i], way[(i + 1) % 4]) <= 0) return;
    double worst = 0; // square of a cosine
    for (std::size_t i = 0; i < 4; ++i) {
        const Vec2 out = way[i], back = way[(i + 3) % 4];
        const double cosine = -dot(out, back); // times both lengths
        const double square = cosine * cosine / (squaredLength(out) * squaredLength(back));
        if (square > (cosine > 0 ? squaredCosineOfLeast : squaredCosineOfMost)) return;
        worst = std::max(worst, square);
    }
    candidates_.emplace_back(static_cast<std::uint64_t>(std::sqrt(worst) * 1e6 + 0.5), side);
}

void PairMerger::orderDraws(const Strip& strip) {
    const TriangleSides& sides = strip.sides;
    const auto placeOf = [&](int vertex) { return mortonCode(strip.points[at(vertex)]); };
    forEachDraw(candidates_, [&](std::span<KeyedNode> draw) {
        draws_.clear();
        for (const auto& [deviation, side] : draw) {
            const auto [a, b] = std::minmax({side / 3, sides.twinOf(side) / 3});
            draws_.push_back({std::min(placeOf(sides.startOf(side)), placeOf(sides.endOf(side))), a, b, side});
        }
        std::sort(draws_.begin(), draws_.end());
        for (std::size_t i = 0; i < draw.size(); ++i) draw[i].second = draws_[i].side;
    });
}

void PairMerger::run(Strip& strip) {
    strip.mergedWith.assign(at(strip.sides.triangles()), -1);
    candidates_.clear();
    for (int side = 0; side < static_cast<int>(strip.sides.start.size()); ++side)
        if (strip.sides.twinOf(side) > side) judge(strip, side);
    sortByKey(candidates_, candidatesBuffer_);
    orderDraws(strip);
    for (const auto& [deviation, side] : candidates_) {
        const int a = side / 3, b = strip.sides.twinOf(side) / 3;
        if (strip.mergedWith[at(a)] >= 0 || strip.mergedWith[at(b)] >= 0) continue;
        strip.mergedWith[at(a)] = b;
        strip.mergedWith[at(b)] = a;
    }
}

} // namespace toile::meshing
