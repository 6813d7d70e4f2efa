// SPDX-License-Identifier: GPL-3.0-or-later
#include "samples/Figures.h"

#include <cmath>

namespace toile::samples {
namespace {

/// Distance of two points in the plane of symmetry.
double sagittalDistance(const Vec3& a, const Vec3& b) {
    return std::hypot(a.y - b.y, a.z - b.z);
}

} // namespace

Figures figuresOf(const body::Measurements& m, const body::Landmarks& at) {
    Figures f;
    f.neckHalfWidth = at.neckLeft.x;
    // Behind, the shoulder slopes backward and takes up nearly half of the way from the side neck point to the nape;
    // before, the cloth goes the whole way down.
    f.backNeckDepth = 0.55 * sagittalDistance(at.neckLeft, at.nape);
    f.frontNeckDepth = sagittalDistance(at.neckLeft, at.frontNeck);
    f.shoulderLength = distance(at.neckLeft, at.acromionLeft);
    f.shoulderSlope = m.shoulderSlope;
    // The folds of the arms lie about 20 mm inside the shoulder points behind and 28 mm before.
    f.acrossBack = m.shoulderWidth - 2 * 0.020;
    f.acrossFront = m.shoulderWidth - 2 * 0.028;
    // Nape and waist lie on a slanting line, but cloth bridges the hollow of the back between blades and seat.
    f.backWaist = f.backNeckDepth + 0.98 * m.napeToWaist;
    f.bustHeight = m.bustHeight;
    f.bustHalfDistance = at.bustLeft.x;
    const double underBustDepth = (m.bust - m.underBust) / 4; // how far the bust stands out from the ribs
    f.frontWaist = m.bustHeight + std::hypot(at.bustLeft.y - at.waist.y, underBustDepth);
    f.waistToHip = at.waist.y - at.hip.y;
    return f;
}

} // namespace toile::samples
