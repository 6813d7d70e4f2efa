// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/picture/Cavity.h"

#include <algorithm>
#include <cmath>

namespace toile::picture {
namespace {

/// Of the neighbours of a vertex; those inside the surface are met twice each.
struct Ring {
    double sum = 0; ///< of what is asked of each neighbour
    double squaredLengths = 0;
    int count = 0;
};

/// Curvature from how far the mean neighbour lies above the tangent plane; on a sphere of radius R and at a distance s
/// it is s²/(2R).
std::vector<Ring> ringsOf(std::span<const Vec3> positions, std::span<const Vec3> normals,
                          std::span<const geometry::TriangleIndices> triangles) {
    std::vector<Ring> rings(positions.size());
    const auto add = [&](int vertex, int neighbour) {
        const Vec3 there = positions[neighbour] - positions[vertex];
        rings[vertex].sum += dot(there, normals[vertex]);
        rings[vertex].squaredLengths += squaredLength(there);
        ++rings[vertex].count;
    };
    for (const auto& t : triangles)
        for (std::size_t i = 0; i < 3; ++i) {
            add(t[i], t[(i + 1) % 3]);
            add(t[i], t[(i + 2) % 3]);
        }
    return rings;
}

/// Rounds of averaging over the ring, which adds s²/2 to the variance in each direction; coarse places go only part of
/// the way.
void evenOut(std::vector<double>& values, std::vector<Ring>& rings,
             std::span<const geometry::TriangleIndices> triangles) {
    constexpr int mostRounds = 16; // enough for sides of 3.5 mm; a finer mesh is evened out less
    constexpr double variance = 2 * cavityBlur * cavityBlur;
    double lengths = 0, count = 0;
    for (const Ring& ring : rings) {
        lengths += ring.squaredLengths;
        count += ring.count;
    }
    if (!(lengths > 0)) return;
    const int rounds =
        static_cast<int>(std::clamp(std::ceil(variance * count / lengths), 1.0, static_cast<double>(mostRounds)));
    for (int round = 0; round < rounds; ++round) {
        for (Ring& ring : rings) ring.sum = 0;
        for (const auto& [a, b, c] : triangles) {
            rings[a].sum += values[b] + values[c];
            rings[b].sum += values[a] + values[c];
            rings[c].sum += values[a] + values[b];
        }
        for (std::size_t i = 0; i < values.size(); ++i) {
            const Ring& ring = rings[i];
            if (!(ring.squaredLengths > 0)) continue;
            const double part = std::min(1.0, variance * ring.count / (rounds * ring.squaredLengths));
            values[i] += part * (ring.sum / ring.count - values[i]);
        }
    }
}

} // namespace

std::vector<double> cavities(std::span<const Vec3> positions, std::span<const Vec3> normals,
                             std::span<const geometry::TriangleIndices> triangles) {
    std::vector<Ring> rings = ringsOf(positions, normals, triangles);
    std::vector<double> values(positions.size(), 0);
    for (std::size_t i = 0; i < values.size(); ++i)
        if (rings[i].squaredLengths > 0) // a curvature beyond 1/cavityLength counts as much as that
            values[i] = std::clamp(2 * rings[i].sum / rings[i].squaredLengths * cavityLength, -1.0, 1.0);
    evenOut(values, rings, triangles);
    return values;
}

} // namespace toile::picture
