// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/meshing/PairMerge.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace toile::meshing {
namespace {

std::size_t at(int i) {
    return static_cast<std::size_t>(i);
}

/// Angles within 45–140°, as the range of their cosines.
constexpr double mostCosine = 0.5 * std::numbers::sqrt2, leastCosine = -0.766044443118978;

struct Candidate {
    int deviation;       ///< cosine of the angle farthest from a right one, without sign [1e-6]: whole, so that draws
                         ///< are draws
    std::uint64_t place; ///< decides draws, alike for a piece and its mirror image
    int a, b;
    friend auto operator<=>(const Candidate&, const Candidate&) = default;
};

/// Both triangles at a side as a quadrilateral.
void judge(const CellMesh& mesh, int side, std::vector<Candidate>& candidates) {
    const TriangleSides& sides = mesh.strip.sides;
    const int twin = sides.twinOf(side), a = side / 3, b = twin / 3;
    if (mesh.triangles[at(a)].region != mesh.triangles[at(b)].region) return;
    const int low = sides.startOf(side), high = sides.endOf(side);
    const auto position = [&](int vertex) { return mesh.position[at(mesh.layer.stripNodes[at(vertex)])]; };
    const std::array<Vec2, 4> quad{position(low), position(sides.apexOf(twin)), position(high),
                                   position(sides.apexOf(side))};
    std::array<Vec2, 4> way; // from corner to corner
    for (std::size_t i = 0; i < 4; ++i) {
        const Vec2 along = quad[(i + 1) % 4] - quad[i];
        way[i] = along / std::sqrt(squaredLength(along));
    }
    double worst = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        const Vec2 back = way[(i + 3) % 4] * -1.0;
        const double cosine = dot(way[i], back);
        if (cosine > mostCosine || cosine < leastCosine || cross(way[i], back) <= 0) return;
        worst = std::max(worst, std::abs(cosine));
    }
    const std::uint64_t place =
        std::min(mortonCode(mesh.strip.points[at(low)]), mortonCode(mesh.strip.points[at(high)]));
    candidates.push_back({static_cast<int>(std::lround(worst * 1e6)), place, std::min(a, b), std::max(a, b)});
}

} // namespace

void mergePairs(CellMesh& mesh) {
    for (Triangle& triangle : mesh.triangles) triangle.mergedWith = -1;
    std::vector<Candidate> candidates;
    for (int side = 0; side < static_cast<int>(mesh.strip.sides.start.size()); ++side)
        if (mesh.strip.sides.twinOf(side) > side) judge(mesh, side, candidates);
    std::sort(candidates.begin(), candidates.end());
    for (const Candidate& pair : candidates) {
        Triangle &a = mesh.triangles[at(pair.a)], &b = mesh.triangles[at(pair.b)];
        if (a.mergedWith >= 0 || b.mergedWith >= 0) continue;
        a.mergedWith = pair.b;
        b.mergedWith = pair.a;
    }
}

} // namespace toile::meshing
