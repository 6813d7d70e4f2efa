// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/BackNeck.h"

#include "core/geometry/TriangleMesh.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <set>

namespace toile::simulation {
namespace {

using Line = std::vector<std::array<int, 2>>; ///< pieces of a line, particle to particle

Line closedLine(const Opening& rim) {
    Line line;
    for (std::size_t i = 0; i < rim.size(); ++i) line.push_back({rim[i], rim[(i + 1) % rim.size()]});
    return line;
}

/// The pieces none of whose points is farther from the rim than a collar is high.
std::set<int> bandsOn(const Opening& rim, std::span<const std::array<int, 3>> triangles, std::span<const int> piece,
                      std::span<const Vec3> positions) {
    constexpr double collar = 0.08; // [m]; a shirt's yoke is higher
    const auto isNear = [&](int particle) {
        return std::ranges::any_of(
            rim, [&](int other) { return geometry::distance(positions[particle], positions[other]) < collar; });
    };
    std::set<int> bands(piece.begin(), piece.end());
    for (std::size_t t = 0; t < piece.size(); ++t)
        if (bands.contains(piece[t]) && !std::ranges::all_of(triangles[t], isNear)) bands.erase(piece[t]);
    return bands;
}

/// The edges between these pieces and all others.
Line seamsUnder(const std::set<int>& bands, std::span<const std::array<int, 3>> triangles, std::span<const int> piece) {
    std::map<std::array<int, 2>, std::array<bool, 2>> beside; // an edge has a triangle of another piece, of a band
    for (std::size_t t = 0; t < piece.size(); ++t)
        for (std::size_t i = 0; i < 3; ++i) {
            const auto [low, high] = std::minmax(triangles[t][i], triangles[t][(i + 1) % 3]);
            beside[{low, high}][bands.contains(piece[t])] = true;
        }
    Line seams;
    for (const auto& [edge, has] : beside)
        if (has[0] && has[1]) seams.push_back(edge);
    return seams;
}

/// Where a line passes x = 0 behind the plane z = middle, or comes nearest to it.
std::optional<Vec3> backPointOf(const Line& line, std::span<const Vec3> positions, double middle) {
    std::optional<Vec3> best;
    for (const auto& [from, to] : line) {
        const Vec3 &p = positions[from], &q = positions[to];
        const double t = p.x == q.x ? 0 : std::clamp(p.x / (p.x - q.x), 0.0, 1.0);
        const Vec3 at = lerp(p, q, t);
        if (at.z <= middle && (!best || std::abs(at.x) < std::abs(best->x))) best = at;
    }
    return best;
}

} // namespace

BackNeck backNeckOf(const Opening& rim, std::span<const std::array<int, 3>> triangles, std::span<const int> piece,
                    std::span<const Vec3> positions, const body::Landmarks& marks) {
    std::vector<Vec3> points;
    for (const int particle : rim) points.push_back(positions[particle]);
    const geometry::Box3 bounds = geometry::boundsOf(points);
    const double middle = 0.5 * (bounds.low.z + bounds.high.z), width = bounds.high.x - bounds.low.x;
    BackNeck result{.napeDistance = std::numeric_limits<double>::infinity()};
    for (const Line& line :
         {closedLine(rim), seamsUnder(bandsOn(rim, triangles, piece, positions), triangles, piece)}) {
        const auto back = backPointOf(line, positions, middle);
        if (!back || geometry::distance(*back, marks.nape) >= result.napeDistance) continue;
        result.napeDistance = geometry::distance(*back, marks.nape);
        result.below = back->y < marks.nape.y;
    }
    result.widerBy = std::max(0.0, 0.5 * (width - (marks.neckLeft.x - marks.neckRight.x)));
    return result;
}

} // namespace toile::simulation
