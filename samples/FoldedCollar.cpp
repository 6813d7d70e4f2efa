// SPDX-License-Identifier: GPL-3.0-or-later
#include "samples/FoldedCollar.h"

#include "samples/Placing.h"
#include "samples/Strokes.h"
#include "samples/Waistband.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace toile::samples {
namespace {

using namespace pattern;

/// Part of a ring: its seam is the inner arc, y = 0 at the centre back.
Piece draftFlat(const Fabric& fabric, double length, const FoldedCollarSettings& s) {
    Piece collar = pieceNamed("collar", "Collar", fabric, s.spacing);
    const double angle = s.flare / s.height, radius = length / angle;
    const auto at = [&](double side, double outward) {
        const double a = side * angle / 2, r = radius + outward;
        return Vec2{r * std::sin(a), r * std::cos(a) - radius};
    };
    const Vec2 neckLeft = at(-1, 0), neckRight = at(1, 0);
    const Vec2 pointRight = at(1, s.height + s.pointLength), pointLeft = at(-1, s.height + s.pointLength);
    const double bulge = std::tan(angle / 4);
    const Vec2 flat{0.3 * length, 0};
    const double outer = at(0, s.height).y;
    collar.outline = contourOf(
        "collar",
        {arc("neck-left", "neck", neckLeft, -bulge, neckRight), line("neck-right", "end-right", neckRight, pointRight),
         cubic("point-right", "outer-right", pointRight,
               0.35 * length * Vec2{-std::cos(angle / 2), std::sin(angle / 2)} * 0.5, 0.6 * flat, {0, outer}),
         cubic("outer-centre", "outer-left", {0, outer}, -0.6 * flat,
               0.35 * length * Vec2{std::cos(angle / 2), std::sin(angle / 2)} * 0.5, pointLeft),
         line("point-left", "end-left", pointLeft, neckLeft)});
    collar.grain = std::numbers::pi / 2;
    collar.interfacing = Interfacing{};
    return collar;
}

} // namespace

Piece draftFoldedCollar(const Fabric& fabric, const body::Body& body, double length, double top,
                        const FoldedCollarSettings& s) {
    constexpr double overStand = 0.02; // [m]
    Piece collar = draftFlat(fabric, length, s);
    // It is let down over the stand once that is sewn on: what came up from below would take the collar under it.
    const double seam = top + overStand + s.height + s.pointLength;
    const Ring high = ringRound(body, seam - s.height - s.pointLength, seam + s.flare, 0.006);
    const double outside = std::max(high.radius, length / (2 * std::numbers::pi) + overStand);
    const double behind = std::min(high.centre.z - outside, body.landmarks.nape.z - 0.055);
    collar.placement = Placement{{{-1, 0, 0}, {0, -1, 0}, {0, 0, 1}, {0, seam, behind}}, Curl{{0, 1}, -outside}};
    collar.layer = 2;
    return collar;
}

} // namespace toile::samples
