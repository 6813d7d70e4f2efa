// SPDX-License-Identifier: GPL-3.0-or-later
#include "samples/Sleeve.h"

#include "samples/Measuring.h"

#include <cmath>

namespace toile::samples {
namespace {

/// The seams lean inward by `taper`; the bottom is an arc, hollow as a cone's, that meets both squarely.
struct Tube {
    double taper = 0;      ///< [rad]
    double halfTop = 0;    ///< at the cap's base [m]
    double halfBottom = 0; ///< of the chord [m]
    double bottomY = 0;
};

Tube tubeOf(const SleeveSettings& s, Solver& solver) {
    const auto atTaper = [&](double taper) {
        const double halfTop = s.width / 2 + s.bicepsBelow * std::tan(taper);
        return Tube{taper, halfTop, halfTop - s.underarmLength * std::sin(taper), -s.underarmLength * std::cos(taper)};
    };
    const auto bottomLength = [](const Tube& tube) { return 2 * tube.halfBottom * tube.taper / std::sin(tube.taper); };
    return atTaper(solver.rootOf(
        "taper of the sleeve", [&](double taper) { return bottomLength(atTaper(taper)) - s.bottom; }, 1e-6, 0.5));
}

/// Half a cap from the underarm at (x, 0) to its top, drawn on +x. Square to the seam below, level on top.
geometry::Curve halfCap(double x, double taper, Vec2 top, double hollow) {
    const double width = x - top.x;
    const Vec2 inward{-std::cos(taper), std::sin(taper)};
    return {{x, 0}, top, geometry::CubicShape{Vec2{x, 0} + hollow * width * inward, top + Vec2{0.46 * width, 0}}};
}

constexpr double hollowBack = 0.45, hollowFront = 0.55; // the front is cut deeper, as its armhole is

} // namespace

Result<Sleeve> draftSleeve(const Armholes& armholes, const SleeveSettings& s) {
    Solver solver;
    const Tube tube = tubeOf(s, solver);
    const double half = tube.halfTop;
    const auto backCap = [&](Vec2 top) { return halfCap(half, tube.taper, top, hollowBack); };
    const auto frontCap = [&](Vec2 top) {
        return geometry::mirrored(halfCap(half, tube.taper, {-top.x, top.y}, hollowFront), {0, 0}, {0, 1});
    };
    // The height gives the cap's whole length, the place of its top shares it between front and back.
    const auto topAt = [&](double height) {
        const double x = solver.rootOf(
            "top of the sleeve's cap",
            [&](double offset) {
                return geometry::length(frontCap({offset, height})) - (armholes.front + s.frontEase) -
                       (geometry::length(backCap({offset, height})) - (armholes.back + s.backEase));
            },
            -0.6 * half, 0.6 * half);
        return Vec2{x, height};
    };
    const double height = solver.rootOf(
        "height of the sleeve's cap",
        [&](double h) { return geometry::length(backCap(topAt(h))) - (armholes.back + s.backEase); }, 0.02, 0.25);
    const Vec2 top = topAt(height);
    if (solver.error()) return tl::unexpected(*solver.error());

    const Vec2 bottomFront{-tube.halfBottom, tube.bottomY}, bottomBack{tube.halfBottom, tube.bottomY};
    Sleeve sleeve;
    sleeve.strokes = {
        arc("bottom-front", "bottom", bottomFront, -std::tan(tube.taper / 2), bottomBack),
        line("bottom-back", "seam-back", bottomBack, {half, 0}),
        {"underarm-back", "cap-back", backCap(top)},
        {"cap-top", "cap-front", geometry::reversed(frontCap(top))},
        line("underarm-front", "seam-front", {-half, 0}, bottomFront),
    };
    sleeve.backNotch = armholes.backNotch / (armholes.back + s.backEase);
    sleeve.frontNotch = 1 - armholes.frontNotch / (armholes.front + s.frontEase);
    sleeve.capHeight = top.y;
    sleeve.bottomY = tube.bottomY;
    sleeve.capWidth = 2 * half;
    return sleeve;
}

} // namespace toile::samples
