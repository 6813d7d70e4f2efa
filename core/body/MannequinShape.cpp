// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/body/MannequinShape.h"

#include "core/body/MannequinParts.h"

#include <algorithm>
#include <cmath>

namespace toile::body {

namespace {

constexpr double jointInside = 0.022, jointBelow = 0.056; ///< from the acromion to the shoulder joint [m]

double tallness(const Measurements& m) {
    return m.height / drawn.height;
}

Transform turned(double outward, double upward, const Vec3& origin) {
    const Vec3 z{std::sin(outward) * std::cos(upward), std::sin(upward), std::cos(outward) * std::cos(upward)};
    const Vec3 x = normalized(cross({0, 1, 0}, z));
    return {x, cross(z, x), z, origin};
}

Transform neckFrameOf(const Levels& y) {
    const double lean = 0.27; // of the neck, forward [rad]
    const Vec3 along{0, std::cos(lean), std::sin(lean)};
    return {{1, 0, 0}, along, cross({1, 0, 0}, along), {0, (y.nape + y.frontNeck) / 2, -0.030}};
}

Transform armFrameOf(const Measurements& m, const Levels& y, const ShapeFactors& f, double z) {
    const Vec3 along{std::cos(m.armAngle), -std::sin(m.armAngle), 0};
    const double t = tallness(m), b = m.biceps / drawn.biceps;
    return {cross(along, {0, 0, 1}),
            along,
            {0, 0, 1},
            {m.shoulderWidth / 2 - jointInside * t, y.acromion + f.acromionRise - jointBelow * b, z}};
}

/// Where along the arm the wrist lies, so that acromion to wrist is what was asked.
double wristAlong(const Measurements& m, const Levels& y, const Transform& arm, double forward) {
    const Vec3 acromion{m.shoulderWidth / 2, y.acromion, arm.origin.z};
    const Vec3 d = arm.origin + forward * arm.axisZ - acromion;
    const double half = dot(d, arm.axisY);
    return -half + std::sqrt(std::max(half * half - squaredLength(d) + m.arm * m.arm, 0.0));
}

} // namespace

Levels levelsOf(const Measurements& m) {
    const double t = tallness(m);
    Levels y;
    y.crown = m.height;
    y.chin = m.height - 0.220 * t;
    y.nape = m.height - 0.247 * t;
    y.sideNeck = y.nape - 0.010 * t;
    y.frontNeck = y.nape - 0.052 * t;
    const double neckX = 0.066 * m.neck / drawn.neck;
    y.acromion = y.sideNeck - (m.shoulderWidth / 2 - neckX) * std::tan(m.shoulderSlope);
    y.bust = y.sideNeck - std::sqrt(std::max(m.bustHeight * m.bustHeight - 0.02, 0.02));
    y.underBust = y.bust - 0.078 * t - 0.15 * std::max(m.bust - m.underBust - 0.12, 0.0); // below the breast
    y.waist = y.nape - m.napeToWaist;
    y.crotch = m.insideLeg;
    y.hip = y.crotch + 0.235 * (y.waist - y.crotch);
    y.pelvis = y.crotch + 0.30 * (y.waist - y.crotch);
    y.thigh = y.crotch - 0.03;
    y.knee = 0.595 * m.insideLeg;
    y.ankle = 0.145 * m.insideLeg;
    return y;
}

namespace {

Ellipsoid breastOf(const Levels& y, const Scales& s, double size) {
    const double wide = 0.75 + 0.25 * size, high = 0.85 + 0.15 * size, deep = 0.3 + 0.7 * size, r = s.chest;
    return {turned(0.26, -0.10, {(0.068 + 0.004 * size) * r, y.bust + 0.004, 0.066 * r}),
            {0.064 * r * wide, 0.069 * s.tall * high, 0.054 * r * deep}};
}

Ellipsoid buttockOf(const Levels& y, const Scales& s) {
    const double h = s.hip;
    return {turned(0.25, 0.0, {0.076 * h, y.pelvis + 0.006, -0.056 * h}), {0.080 * h, 0.084 * h, 0.082 * h}};
}

} // namespace

double Ellipsoid::distance(const Vec3& point) const {
    const Vec3 d = point - frame.origin;
    const double away = length(d);
    const double q =
        std::hypot(dot(d, frame.axisX) / radii.x, dot(d, frame.axisY) / radii.y, dot(d, frame.axisZ) / radii.z);
    if (q < 0.05) return -0.95 * std::min({radii.x, radii.y, radii.z});
    return (q - 1) / q * away;
}

MannequinShape mannequinShape(const Measurements& m, const ShapeFactors& f) {
    Levels y = levelsOf(m);
    y.bust += f.bustRise, y.underBust += f.bustRise, y.crotch += f.crotchRise;
    const Scales s = scalesOf(m, f);
    const double shoulderZ = -0.040, ankleX = ankleXOf(s);
    const Transform neck = neckFrameOf(y), arm = armFrameOf(m, y, f, shoulderZ);
    const double wristAt = wristAlong(m, y, arm, 0.012) + f.wristShift, bicepsAt = 0.27 * wristAt;
    const double t = s.tall;
    const Ellipsoid nose{turned(0, 0.35, {0, y.crown - 0.130 * t, 0.093 * t}), {0.011 * t, 0.022 * t, 0.014 * t}};
    return {.levels = y,
            .shoulderZ = shoulderZ,
            .wristAt = wristAt,
            .bicepsAt = bicepsAt,
            .neckAt = 0.030,
            .neckFrame = neck,
            .armFrame = arm,
            .torso = torsoOf(y, s),
            .shoulder = shoulderOf(m, y, f.acromionRise, shoulderZ),
            .neck = neckOf(neck, s),
            .head = headOf(y, s.tall),
            .arm = armOf(arm, s, bicepsAt, wristAt),
            .thumb = thumbOf(arm, wristAt, s),
            .leg = legOf(y, s, ankleX),
            .foot = footOf(ankleX, s.tall),
            .breast = breastOf(y, s, f.breast),
            .buttock = buttockOf(y, s),
            .nose = nose};
}

double MannequinShape::distance(const Vec3& point) const {
    const Vec3 here{std::abs(point.x), point.y, point.z}, there{-here.x, here.y, here.z};
    const auto legAt = [&](const Vec3& p) { return smoothMin(leg.distance(p), foot.distance(p), 0.04); };
    const double legs = smoothMin(legAt(here), legAt(there), 0.008);
    const double breasts = smoothMin(breast.distance(here), breast.distance(there), 0.03);
    const double buttocks = smoothMin(buttock.distance(here), buttock.distance(there), 0.03);
    double trunk = smoothMin(torso.distance(here), shoulder.distance(here), 0.10);
    trunk = smoothMin(trunk, breasts, 0.06);
    trunk = smoothMin(trunk, buttocks, 0.06);
    const double off = std::min(here.x / 0.07, 1.0); // the groin is soft, the crotch is not
    trunk = smoothMin(trunk, legs, 0.02 + 0.09 * off * off * (3 - 2 * off));
    trunk = smoothMin(trunk, smoothMin(arm.distance(here), thumb.distance(here), 0.025), 0.06);
    const double skull = smoothMin(head.distance(here), nose.distance(here), 0.03);
    return smoothMin(trunk, smoothMin(neck.distance(here), skull, 0.03), 0.06);
}

} // namespace toile::body
