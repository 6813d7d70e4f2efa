// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/meshing/PairMerge.h"

#include <algorithm>
#include <cmath>

namespace toile::meshing {
namespace {

std::size_t at(int i) {
    return static_cast<std::size_t>(i);
}

/// Angles within 45–140°: squares of the cosines of both.
constexpr double squaredCosineOfLeast = 0.5, squaredCosineOfMost = 0.586824088833465;

} // namespace

/// Both triangles at a side as a quadrilateral.
void PairMerger::judge(const Strip& strip, int side) {
    const TriangleSides& sides = strip.sides;
    const int twin = sides.twinOf(side), a = side / 3, b = twin / 3;
    if (strip.region[at(a)] != strip.region[at(b)]) return;
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
    const std::uint64_t place = std::min(mortonCode(strip.points[at(low)]), mortonCode(strip.points[at(high)]));
    candidates_.push_back(
        {static_cast<int>(std::lround(std::sqrt(worst) * 1e6)), place, std::min(a, b), std::max(a, b)});
}

void PairMerger::run(Strip& strip) {
    strip.mergedWith.assign(at(strip.sides.triangles()), -1);
    candidates_.clear();
    for (int side = 0; side < static_cast<int>(strip.sides.start.size()); ++side)
        if (strip.sides.twinOf(side) > side) judge(strip, side);
    std::sort(candidates_.begin(), candidates_.end());
    for (const Candidate& pair : candidates_) {
        int &a = strip.mergedWith[at(pair.a)], &b = strip.mergedWith[at(pair.b)];
        if (a >= 0 || b >= 0) continue;
        a = pair.b;
        b = pair.a;
    }
}

} // namespace toile::meshing
