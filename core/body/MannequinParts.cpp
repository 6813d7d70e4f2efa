// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/body/MannequinParts.h"

#include <algorithm>
#include <cmath>

namespace toile::body {

Scales scalesOf(const Measurements& m, const ShapeFactors& f) {
    return {m.height / drawn.height,
            m.underBust / drawn.underBust * f.ribs,
            m.underBust / drawn.underBust * f.ribs * f.chest,
            m.waist / drawn.waist * f.waist,
            m.hip / drawn.hip * f.hip,
            m.thigh / drawn.thigh * f.thigh,
            m.neck / drawn.neck * f.neck,
            m.biceps / drawn.biceps * f.biceps,
            m.wrist / drawn.wrist * f.wrist};
}

namespace {

/// Half-width, front and back as coordinates, about the level's middle.
Section level(double at, double halfWidth, double front, double back, double scale, double power = 2) {
    const double middle = 0.35 * front + 0.65 * back + 0.03; // the widest place lies behind the middle of the depth
    const double z = std::clamp(middle, back + 0.3 * (front - back), front - 0.3 * (front - back));
    return {at, {0, z}, halfWidth * scale, halfWidth * scale, (front - z) * scale, (z - back) * scale, power};
}

} // namespace

SectionTube torsoOf(const Levels& y, const Scales& s) {
    const double belly = (s.waist + s.hip) / 2, chest = s.chest;
    const auto between = [](double a, double b, double t) { return a + (b - a) * t; };
    return {{},
            {level(y.pelvis, 0.176, 0.094, -0.092, s.hip, 2.05),
             level(between(y.pelvis, y.waist, 0.33), 0.160, 0.099, -0.095, between(s.hip, s.waist, 0.25), 2.05),
             level(between(y.pelvis, y.waist, 0.66), 0.145, 0.105, -0.083, belly, 2.05),
             level(y.waist, 0.128, 0.102, -0.073, s.waist, 2.05),
             level(between(y.waist, y.underBust, 0.55), 0.1325, 0.105, -0.086, between(s.waist, s.ribs, 0.5), 2.05),
             level(y.underBust, 0.138, 0.107, -0.099, s.ribs, 2.05), level(y.bust, 0.146, 0.104, -0.113, chest, 2.05),
             level(between(y.bust, y.acromion, 0.42), 0.141, 0.082, -0.117, chest, 2.05),
             level(between(y.bust, y.acromion, 0.75), 0.112, 0.051, -0.104, chest, 2),
             level(y.acromion + 0.002, 0.078, 0.024, -0.093, chest, 2),
             level(y.sideNeck - 0.012, 0.054, 0.000, -0.080, chest, 2)},
            std::max(y.pelvis - y.crotch, 0.02),
            0.03};
}

/// The bar of trapezius, collar bones and shoulder blades from the middle outward; its sections stand in (z,
/// height).
SectionTube shoulderOf(const Measurements& m, const Levels& y, double rise, double z) {
    const double half = m.shoulderWidth / 2, t = m.height / drawn.height;
    const double neckX = 0.062 * m.neck / drawn.neck;
    const auto lineAt = [&](double x) { return y.sideNeck + rise - (x - neckX) * std::tan(m.shoulderSlope); };
    // frame: y along +x, z up, x along +z
    const Transform frame{{0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {0, 0, z}};
    const auto bar = [&](double x, double top, double up, double down, double front, double back) {
        return Section{x, {0, top - up * t}, back * t, front * t, up * t, down * t, 2};
    };
    return {frame,
            {bar(-0.02, lineAt(0.045) - 0.010, 0.04, 0.07, 0.048, 0.044),
             bar(0.30 * half, lineAt(0.30 * half) - 0.012, 0.040, 0.07, 0.052, 0.050),
             bar(0.55 * half, lineAt(0.55 * half) - 0.008, 0.040, 0.06, 0.054, 0.056),
             bar(0.75 * half, lineAt(0.75 * half) - 0.004, 0.040, 0.055, 0.050, 0.052),
             bar(0.92 * half, lineAt(0.92 * half) - 0.001, 0.036, 0.050, 0.040, 0.042)},
            0.02,
            0.030 * t};
}

SectionTube neckOf(const Transform& frame, const Scales& s) {
    const double r = s.neck;
    return {frame,
            {{-0.03, {}, 0.056 * r, 0.056 * r, 0.054 * r, 0.058 * r, 2},
             {0.03, {}, 0.0545 * r, 0.0545 * r, 0.057 * r, 0.058 * r, 2},
             {0.07, {}, 0.0525 * r, 0.0525 * r, 0.057 * r, 0.056 * r, 2},
             {0.13, {}, 0.052 * r, 0.052 * r, 0.052 * r, 0.056 * r, 2}},
            0.03,
            0.03};
}

SectionTube headOf(const Levels& y, double t) {
    const auto ring = [&](double below, double halfWidth, double front, double back, double power) {
        const double z = 0.012;
        return Section{y.crown - below * t,    {0, (front + back) / 2 * t + z}, halfWidth * t, halfWidth * t,
                       (front - back) / 2 * t, (front - back) / 2 * t,          power};
    };
    return {{},
            {ring(0.178, 0.053, 0.084, -0.030, 2), ring(0.138, 0.066, 0.089, -0.080, 2),
             ring(0.095, 0.072, 0.088, -0.095, 2)},
            0.038 * t,
            0.095 * t};
}

/// x of the arm's frame points to its underside.
SectionTube armOf(const Transform& frame, const Scales& s, double biceps, double wrist) {
    const double elbow = 0.52 * wrist;
    const double b = s.biceps, w = s.wrist, e = (b + w) / 2, h = 0.5 * (s.tall + w);
    const auto ring = [](double at, double top, double under, double front, double back, double power, double forward) {
        return Section{at, {0, forward}, top, under, front, back, power};
    };
    return {frame,
            {ring(-0.03, 0.040 * b, 0.052 * b, 0.050 * b, 0.052 * b, 2, 0),
             ring(0.025, 0.0465 * b, 0.051 * b, 0.050 * b, 0.050 * b, 2, 0),
             ring(0.55 * biceps, 0.0465 * b, 0.048 * b, 0.0465 * b, 0.0465 * b, 2, 0),
             ring(biceps, 0.0445 * b, 0.0455 * b, 0.0445 * b, 0.0435 * b, 2, 0),
             ring(elbow - 0.03, 0.038 * e, 0.038 * e, 0.038 * e, 0.037 * e, 2, 0.002),
             ring(elbow + 0.055, 0.036 * e, 0.036 * e, 0.042 * e, 0.040 * e, 2, 0.004),
             ring(0.45 * elbow + 0.55 * wrist + 0.02, 0.029 * e, 0.029 * e, 0.034 * e, 0.033 * e, 2, 0.008),
             ring(wrist, 0.0225 * w, 0.0225 * w, 0.0285 * w, 0.0280 * w, 2.1, 0.012),
             ring(wrist + 0.040 * h, 0.0200 * h, 0.0200 * h, 0.0355 * h, 0.0330 * h, 2.3, 0.013),
             ring(wrist + 0.085 * h, 0.0160 * h, 0.0160 * h, 0.0400 * h, 0.0380 * h, 2.4, 0.013),
             ring(wrist + 0.130 * h, 0.0125 * h, 0.0125 * h, 0.0350 * h, 0.0350 * h, 2.3, 0.012),
             ring(wrist + 0.160 * h, 0.0100 * h, 0.0100 * h, 0.0260 * h, 0.0270 * h, 2.2, 0.010)},
            0.03,
            0.020 * h};
}

SectionTube thumbOf(const Transform& arm, double wrist, const Scales& s) {
    const double h = 0.5 * (s.tall + s.wrist);
    const Vec3 along = normalized(arm.axisY + 0.55 * arm.axisZ + 0.15 * arm.axisX);
    const Vec3 side = normalized(cross(along, arm.axisX));
    const Transform frame{cross(along, side), along, side,
                          arm.origin + (wrist + 0.028 * h) * arm.axisY + 0.020 * h * arm.axisZ};
    const auto ring = [&](double at, double r) { return Section{at * h, {}, r * h, r * h, r * h, r * h, 2}; };
    return {frame, {ring(0, 0.0145), ring(0.03, 0.0135), ring(0.062, 0.0105)}, 0.012 * h, 0.010 * h};
}

namespace {

/// x of the middle of the thigh: flush with the hip outside, and clear of the other leg inside.
double thighXOf(const Scales& s) {
    return std::max(0.177 * s.hip - 0.077 * s.thigh, 0.077 * s.thigh + 0.016);
}

} // namespace

double ankleXOf(const Scales& s) {
    return 0.35 * thighXOf(s) + 0.65 * 0.100;
}

SectionTube legOf(const Levels& y, const Scales& s, double ankleX) {
    const double u = s.thigh, k = 0.5 * (s.thigh + s.tall), l = y.crotch / drawn.insideLeg, t = s.tall;
    const double thighX = thighXOf(s);
    const auto x = [&](double part) { return ankleX + (thighX - ankleX) * part; };
    const auto ring = [](double at, double cx, double cz, double half, double front, double back, double scale) {
        return Section{at, {cx, cz}, half * scale, half * scale, front * scale, back * scale, 2};
    };
    const double top = y.pelvis - y.crotch;
    return {{},
            {ring(0.055 * l, x(0), -0.028, 0.0300, 0.036, 0.038, t),
             ring(0.09 * l, x(0), -0.028, 0.0295, 0.033, 0.036, t),
             ring(0.15 * l, x(0.15), -0.024, 0.0330, 0.034, 0.037, k),
             ring(0.24 * l, x(0.35), -0.018, 0.0450, 0.041, 0.050, k),
             ring(0.325 * l, x(0.50), -0.012, 0.0535, 0.045, 0.061, k),
             ring(0.395 * l, x(0.60), -0.003, 0.0510, 0.048, 0.055, k),
             ring(0.452 * l, x(0.75), 0.006, 0.053, 0.056, 0.054, k),
             ring(0.515 * l, x(0.85), 0.004, 0.0595, 0.066, 0.061, (u + k) / 2),
             ring(0.60 * l, x(0.93), 0.001, 0.072, 0.083, 0.078, u),
             ring(y.crotch - 0.05 * l, x(1), -0.007, 0.0770, 0.090, 0.098, u),
             ring(y.crotch + 0.6 * top, x(1), -0.010, 0.074, 0.084, 0.090, u),
             ring(y.crotch + 1.6 * top, x(0.86), -0.006, 0.070, 0.072, 0.072, u)},
            0.03 * t,
            0.06};
}

/// Along the foot from under the ankle; x of its frame points inward, z up.
SectionTube footOf(double ankleX, double t) {
    const double out = 0.12; // toes turned outward [rad]
    const Transform frame{
        {-std::cos(out), 0, std::sin(out)}, {std::sin(out), 0, std::cos(out)}, {0, 1, 0}, {ankleX, 0, -0.028}};
    const auto ring = [&](double at, double half, double middle, double up, double inward) {
        return Section{at * t, {inward * t, middle * t}, half * t, half * t, up * t, middle * t, 2.5};
    };
    return {frame,
            {ring(-0.044, 0.026, 0.026, 0.026, 0), ring(-0.018, 0.0310, 0.032, 0.040, 0),
             ring(0.030, 0.0320, 0.034, 0.046, 0), ring(0.075, 0.0370, 0.027, 0.034, 0.002),
             ring(0.115, 0.0430, 0.020, 0.023, 0.003), ring(0.142, 0.0425, 0.016, 0.016, 0.004),
             ring(0.162, 0.036, 0.013, 0.012, 0.006)},
            0.020 * t,
            0.018 * t};
}

} // namespace toile::body
