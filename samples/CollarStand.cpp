// SPDX-License-Identifier: GPL-3.0-or-later
#include "samples/CollarStand.h"

#include "samples/Placing.h"
#include "samples/Strokes.h"
#include "samples/Waistband.h"

#include <algorithm>
#include <numbers>

namespace toile::samples {
namespace {

using namespace pattern;

Piece draftLeft(const Fabric& fabric, const HalfNeckline& neckline, const CollarStandSettings& s) {
    Piece stand = pieceNamed("stand-left", "Collar stand left", fabric, s.spacing);
    const Vec2 end{-neckline.extension, 0}, back{neckline.length, 0}, up{0, s.height};
    stand.outline = contourOf(
        "stand-left", {line("end-bottom", "bottom", end, back), line("back-bottom", "back", back, back + up),
                       line("back-top", "top", back + up, up), line("centre-top", "top-extension", up, end + up),
                       line("end-top", "end", end + up, end)});
    stand.grain = std::numbers::pi / 2;
    stand.interfacing = Interfacing{};
    return stand;
}

} // namespace

CollarStand draftCollarStand(const Fabric& fabric, const body::Body& body, const HalfNeckline& neckline,
                             const CollarStandSettings& s) {
    constexpr double above = 0.05;     // the shoulders: clear of fronts and back
    constexpr double overLeft = 0.008; // [m]
    const double bottom = body.landmarks.neckLeft.y + above;
    const Ring ring = ringRound(body, bottom, bottom + s.height, 0.006);
    const double radius = std::max(ring.radius, neckline.length / std::numbers::pi);
    const auto standing = [&](double r) {
        return Placement{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, bottom, ring.centre.z + r}}, Curl{{0, 1}, r}};
    };
    CollarStand stand{draftLeft(fabric, neckline, s), {}};
    stand.left.placement = standing(radius);
    stand.right = mirrorPiece("stand-right", "Collar stand right", stand.left);
    stand.right.interfacing = stand.left.interfacing;
    stand.right.placement = mirrored(standing(radius + overLeft));
    stand.right.layer = 1;
    return stand;
}

Seam collarStandSeam(const CollarStand& stand) {
    return seam("stand centre back", {along(stand.left, "back")}, {along(stand.right, "back")});
}

} // namespace toile::samples
