// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/meshing/PairMerge.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

namespace toile::meshing {
namespace {

std::size_t at(int i) {
    return static_cast<std::size_t>(i);
}

constexpr double smallestAngle = 45 * std::numbers::pi / 180;
constexpr double largestAngle = 140 * std::numbers::pi / 180;

struct Candidate {
    int deviation;       ///< of the worst angle from a right angle [1e-6 rad]: whole, so that draws are draws
    std::uint64_t place; ///< decides draws, alike for a piece and its mirror image
    int a, b;
    friend auto operator<=>(const Candidate&, const Candidate&) = default;
};

struct SharedSide {
    int low, high, triangle, corner;
};

double angleAt(Vec2 corner, Vec2 next, Vec2 before) {
    const double angle = std::atan2(cross(next - corner, before - corner), dot(next - corner, before - corner));
    return angle < 0 ? angle + 2 * std::numbers::pi : angle;
}

/// Both triangles as a quadrilateral: apex of a, side, apex of b, side.
void judge(const CellMesh& mesh, const SharedSide& s, const SharedSide& t, std::vector<Candidate>& candidates) {
    const Triangle &first = mesh.triangles[at(s.triangle)], &second = mesh.triangles[at(t.triangle)];
    if (first.region != second.region) return;
    const std::array<int, 4> quad{first.nodes[at(s.corner)], first.nodes[at((s.corner + 1) % 3)],
                                  second.nodes[at(t.corner)], first.nodes[at((s.corner + 2) % 3)]};
    double worst = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        const auto point = [&](std::size_t k) { return mesh.position[at(quad[k % 4])]; };
        const double angle = angleAt(point(i), point(i + 1), point(i + 3));
        if (angle < smallestAngle || angle > largestAngle) return;
        worst = std::max(worst, std::abs(angle - std::numbers::pi / 2));
    }
    const std::uint64_t place = std::min(mortonCode(mesh.grid[at(s.low)]), mortonCode(mesh.grid[at(s.high)]));
    candidates.push_back({static_cast<int>(std::lround(worst * 1e6)), place, s.triangle, t.triangle});
}

} // namespace

void mergePairs(CellMesh& mesh) {
    std::vector<SharedSide> sides;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        mesh.triangles[t].mergedWith = -1;
        for (int i = 0; i < 3; ++i) {
            const int p = mesh.triangles[t].nodes[at((i + 1) % 3)], q = mesh.triangles[t].nodes[at((i + 2) % 3)];
            sides.push_back({std::min(p, q), std::max(p, q), static_cast<int>(t), i});
        }
    }
    std::sort(sides.begin(), sides.end(), [](const SharedSide& s, const SharedSide& t) {
        return std::tie(s.low, s.high, s.triangle) < std::tie(t.low, t.high, t.triangle);
    });
    std::vector<Candidate> candidates;
    for (std::size_t k = 0; k + 1 < sides.size(); ++k)
        if (sides[k].low == sides[k + 1].low && sides[k].high == sides[k + 1].high)
            judge(mesh, sides[k], sides[k + 1], candidates);
    std::sort(candidates.begin(), candidates.end());
    for (const Candidate& pair : candidates) {
        Triangle &a = mesh.triangles[at(pair.a)], &b = mesh.triangles[at(pair.b)];
        if (a.mergedWith >= 0 || b.mergedWith >= 0) continue;
        a.mergedWith = pair.b;
        b.mergedWith = pair.a;
    }
}

} // namespace toile::meshing
