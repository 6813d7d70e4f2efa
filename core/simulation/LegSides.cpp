// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/LegSides.h"

#include "core/simulation/TubePlacing.h"

#include <algorithm>

namespace toile::simulation {
namespace {

/// How far a piece is to be moved along x, to its own side of the body [m].
double wayToItsSide(const pattern::Piece& piece, const Vec3& crotch) {
    constexpr double ofBoth = 0.25; // share of the points
    double leftmost = 0, rightmost = 0;
    int below = 0, left = 0;
    for (const Vec2 point : pointsOn(piece)) {
        const Vec3 p = pattern::placed(*piece.placement, point) - crotch;
        if (p.y > 0) continue;
        leftmost = std::max(leftmost, p.x);
        rightmost = std::min(rightmost, p.x);
        ++below;
        left += p.x > 0;
    }
    if (left < ofBoth * below) return -leftmost;
    return left > (1 - ofBoth) * below ? -rightmost : 0;
}

} // namespace

pattern::Pattern withLegsApart(const pattern::Pattern& pattern, const body::Body& body) {
    pattern::Pattern arranged = pattern;
    for (auto& shared : arranged.pieces) {
        if (!shared->placement) continue;
        const double way = wayToItsSide(pattern::resolved(pattern, *shared), body.landmarks.crotch);
        if (way == 0) continue;
        pattern::Piece piece = *shared;
        piece.placement->transform.origin.x += way;
        shared = std::move(piece);
    }
    return arranged;
}

} // namespace toile::simulation
