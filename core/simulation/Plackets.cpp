// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/Plackets.h"

#include "core/simulation/Openings.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <set>

namespace toile::simulation {
namespace {

using Triangle = std::array<int, 3>;
using Chain = std::vector<int>; ///< particles, as the border runs

constexpr double reach = 0.04; ///< a button sits so near the edge, or nearer [m]

/// Where a tack comes to the border.
struct ChordEnd {
    int position = 0; ///< on the border
    int tack = 0;
};

/// The particles of each piece.
std::vector<std::set<int>> particlesOf(std::span<const Triangle> triangles, std::span<const int> piece) {
    std::vector<std::set<int>> particles;
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        if (piece[t] >= static_cast<int>(particles.size())) particles.resize(piece[t] + 1);
        particles[piece[t]].insert(triangles[t].begin(), triangles[t].end());
    }
    return particles;
}

std::optional<int> nearestOn(const Opening& border, const std::set<int>& ofPiece, const Vec3& place,
                             std::span<const Vec3> positions) {
    std::optional<int> best;
    double least = reach;
    for (std::size_t i = 0; i < border.size(); ++i) {
        if (!ofPiece.contains(border[i])) continue;
        const double far = geometry::distance(positions[border[i]], place);
        if (far > least) continue;
        least = far;
        best = static_cast<int>(i);
    }
    return best;
}

/// In the order in which the border runs through them.
std::vector<ChordEnd> chordEndsOn(const Opening& border, const std::vector<std::set<int>>& particles,
                                  std::span<const Vec3> positions, std::span<const HeldTogether> tacks) {
    std::vector<ChordEnd> ends;
    for (std::size_t k = 0; k < tacks.size(); ++k) {
        const auto at = [&](std::size_t end) {
            return nearestOn(border, particles[tacks[k].piece[end]], tacks[k].place[end], positions);
        };
        const auto a = at(0), b = at(1);
        if (!a || !b || *a == *b) continue;
        ends.push_back({*a, static_cast<int>(k)});
        ends.push_back({*b, static_cast<int>(k)});
    }
    std::ranges::stable_sort(ends, {}, &ChordEnd::position);
    return ends;
}

Chain between(const Opening& border, int from, int to) {
    Chain chain{border[from]};
    for (int i = from; i != to;) chain.push_back(border[i = (i + 1) % static_cast<int>(border.size())]);
    return chain;
}

/// Between a chain and one that runs back beside it.
void fill(const Chain& there, const Chain& back, std::span<const Vec3> positions, std::vector<Triangle>& triangles) {
    std::size_t i = 0, j = back.size() - 1;
    while (i + 1 < there.size() || j > 0) {
        const auto far = [&](int a, int b) { return geometry::distance(positions[a], positions[b]); };
        const bool onThere =
            i + 1 < there.size() && (j == 0 || far(there[i + 1], back[j]) <= far(there[i], back[j - 1]));
        if (onThere) {
            triangles.push_back({there[i + 1], there[i], back[j]});
            ++i;
        } else {
            triangles.push_back({back[j], back[j - 1], there[i]});
            --j;
        }
    }
}

} // namespace

std::vector<Triangle> placketsOf(std::span<const Triangle> triangles, std::span<const int> piece,
                                 std::span<const Vec3> positions, std::span<const HeldTogether> tacks) {
    std::vector<Triangle> plackets;
    if (tacks.size() < 2) return plackets;
    const std::vector<std::set<int>> particles = particlesOf(triangles, piece);
    for (const Opening& border : openingsOf(triangles)) {
        const std::vector<ChordEnd> ends = chordEndsOn(border, particles, positions, tacks);
        const auto next = [&](std::size_t e) { return (e + 1) % ends.size(); };
        for (std::size_t e = 0; e < ends.size(); ++e) // the border from one tack to another …
            for (std::size_t f = 0; f < e; ++f) {     // … and back from that to the first
                const auto [from, to] = std::pair(ends[e], ends[next(e)]);
                if (from.tack == to.tack || ends[f].tack != to.tack || ends[next(f)].tack != from.tack) continue;
                fill(between(border, from.position, to.position),
                     between(border, ends[f].position, ends[next(f)].position), positions, plackets);
            }
    }
    return plackets;
}

} // namespace toile::simulation
