// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/Vec.h"

#include <array>
#include <span>

namespace toile::collision {

/// Two elements of one surface that have no corner in common: a corner and a triangle, or two edges. Two
/// triangles that move from apart to crossing meet first in such a pair.
struct ElementPair {
    std::array<int, 4> vertices{}; ///< the first element's, then the second's
    int firstCount = 1;            ///< 1: corner and triangle; 2: edge and edge
    friend auto operator<=>(const ElementPair&, const ElementPair&) = default;
};

/// The shortest way from the second element of a pair to the first.
struct Separation {
    std::array<double, 4> weights{}; ///< of the pair's vertices: Σ weight·x is the way; the first element's
                                     ///< sum to 1, the second's to −1
    Vec3 way;                        ///< [m]
    double distance = 0;             ///< its length [m]
};

[[nodiscard]] Separation separationOf(const ElementPair& pair, std::span<const Vec3> positions);

/// How far the two elements are apart along a unit direction that leads from the second to the first [m];
/// negative when no plane across it has them on different sides. Along the shortest way it is the distance,
/// and while it stays positive along one direction the elements cannot meet.
[[nodiscard]] inline double gapAlong(const Vec3& direction, const ElementPair& pair, std::span<const Vec3> positions) {
    double nearest = dot(direction, positions[pair.vertices[0]]);
    double farthest = dot(direction, positions[pair.vertices[3]]);
    for (int i = 1; i < 3; ++i) {
        const double along = dot(direction, positions[pair.vertices[i]]);
        if (i < pair.firstCount) nearest = along < nearest ? along : nearest;
        else farthest = along > farthest ? along : farthest;
    }
    return nearest - farthest;
}

/// Whether the elements of a pair stay farther apart than `least` > 0 [m] while their vertices go straight and evenly
/// from one place to the other: as long as they do along the shortest way of now, then along that of then, and so on.
/// In doubt, as where they come within a hundredth of it, false. Ref: Mirtich 1996 (conservative advancement)
[[nodiscard]] bool stayApart(const ElementPair& pair, std::span<const Vec3> from, std::span<const Vec3> to,
                             double least);

/// Whether the segment (p, q) passes through the triangle (a, b, c), border included, and does not lie in its
/// plane.
[[nodiscard]] bool segmentPierces(const Vec3& p, const Vec3& q, const Vec3& a, const Vec3& b, const Vec3& c);

} // namespace toile::collision
