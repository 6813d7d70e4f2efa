// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/body/MannequinFit.h"

#include "core/body/MeshSection.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace toile::body {

namespace {

/// How far from a point inside to the skin [m].
double distanceToSkin(const MannequinShape& shape, const Vec3& inside, const Vec3& direction) {
    double low = 0, high = 0;
    for (int n = 0; n < 400; ++n) {
        const double d = shape.distance(inside + direction * high);
        if (d >= 0) break;
        low = high;
        high += std::clamp(-0.5 * d, 0.001, 0.02);
    }
    double below = shape.distance(inside + direction * low), above = shape.distance(inside + direction * high);
    for (int n = 0; n < 6 && above - below > 1e-12; ++n) { // regula falsi, halved where it stalls
        const double middle = n % 3 == 2 ? (low + high) / 2 : low + (high - low) * below / (below - above);
        const double d = shape.distance(inside + direction * middle);
        (d < 0 ? low : high) = middle;
        (d < 0 ? below : above) = d;
    }
    return above - below > 1e-12 ? low + (high - low) * below / (below - above) : high;
}

Vec3 skinFrom(const MannequinShape& shape, const Vec3& inside, const Vec3& direction) {
    return inside + direction * distanceToSkin(shape, inside, direction);
}

Vec3 bustPoint(const MannequinShape& shape) {
    return skinFrom(shape, shape.breast.frame.origin, shape.breast.frame.axisZ);
}

/// Lowest point of the trunk in the plane of symmetry.
Vec3 crotchOf(const MannequinShape& shape) {
    Vec3 lowest{0, 1e9, 0};
    for (int n = -8; n <= 8; ++n) {
        const double z = -0.005 + 0.006 * n;
        const Vec3 inside{0, shape.levels.pelvis, z};
        if (shape.distance(inside) >= 0) continue;
        const Vec3 skin = skinFrom(shape, inside, {0, -1, 0});
        if (skin.y < lowest.y) lowest = skin;
    }
    return lowest;
}

Vec3 mirroredX(const Vec3& p) {
    return {-p.x, p.y, p.z};
}

Vec3 onNeckAxis(const MannequinShape& shape, double height) {
    const Transform& neck = shape.neckFrame;
    return neck.origin + neck.axisY * ((height - neck.origin.y) / neck.axisY.y);
}

Vec3 torsoMiddle(const MannequinShape& shape, double height) {
    const Vec3 middle = shape.torso.middle(height);
    return {0, height, middle.z};
}

} // namespace

Girths askedGirths(const Measurements& m) {
    return {m.bust, m.underBust, m.waist, m.hip, m.neck, m.biceps, m.wrist, m.thigh};
}

TapePlane tapePlane(const MannequinShape& shape, GirthName name) {
    const Vec3 up{0, 1, 0}, side{1, 0, 0};
    const Transform& arm = shape.armFrame;
    const auto level = [&](double height) { return TapePlane{torsoMiddle(shape, height), up, side}; };
    switch (name) {
    case GirthName::bust: return level(bustPoint(shape).y);
    case GirthName::underBust: return level(shape.levels.underBust);
    case GirthName::waist: return level(shape.levels.waist);
    case GirthName::hip: return level(shape.levels.hip);
    case GirthName::neck: return {shape.neckFrame.point({0, shape.neckAt, 0}), shape.neckFrame.axisY, side};
    case GirthName::biceps: return {shape.arm.middle(shape.bicepsAt), arm.axisY, arm.axisZ};
    case GirthName::wrist: return {shape.arm.middle(shape.wristAt), arm.axisY, arm.axisZ};
    case GirthName::thigh: break;
    }
    return {shape.leg.middle(shape.levels.thigh), up, side};
}

double tapeGirth(const MannequinShape& shape, const TapePlane& plane) {
    const Vec3 other = cross(plane.normal, plane.across);
    const int rays = 96;
    std::vector<Vec2> points;
    for (int n = 0; n < rays; ++n) {
        const double angle = 2 * std::numbers::pi * n / rays;
        const Vec2 towards{std::cos(angle), std::sin(angle)};
        points.push_back(towards * distanceToSkin(shape, plane.origin, plane.across * towards.x + other * towards.y));
    }
    const double chordsTooShort = 1 - std::pow(std::numbers::pi / rays, 2) / 6;
    return perimeter(convexHull(points)) / chordsTooShort;
}

Landmarks landmarksOf(const MannequinShape& shape, const Measurements& m) {
    const Levels& y = shape.levels;
    Landmarks l;
    l.nape = skinFrom(shape, onNeckAxis(shape, y.nape), {0, 0, -1});
    l.frontNeck = skinFrom(shape, onNeckAxis(shape, y.frontNeck), {0, 0, 1});
    l.neckLeft = skinFrom(shape, onNeckAxis(shape, y.sideNeck), {1, 0, 0});
    l.acromionLeft = skinFrom(shape, {m.shoulderWidth / 2, shape.armFrame.origin.y - 0.01, shape.shoulderZ}, {0, 1, 0});
    l.bustLeft = bustPoint(shape);
    l.waist = torsoMiddle(shape, y.waist);
    l.hip = torsoMiddle(shape, y.hip);
    l.crotch = crotchOf(shape);
    l.wristLeft = shape.arm.middle(shape.wristAt);
    l.ankleLeft = shape.leg.middle(y.ankle);
    l.neckRight = mirroredX(l.neckLeft);
    l.acromionRight = mirroredX(l.acromionLeft);
    l.bustRight = mirroredX(l.bustLeft);
    l.wristRight = mirroredX(l.wristLeft);
    l.ankleRight = mirroredX(l.ankleLeft);
    return l;
}

namespace {

constexpr double flattest = 0.1, fullest = 3.0; // sizes of the breast that look like one [–]

/// The breast's size moves the bust girth by an unknown amount per unit, found by trying. Where there is less
/// bust than ribs, the chest becomes narrower. Returns how far the girth was off [m].
double fitBreast(const Measurements& m, double aim, ShapeFactors& f) {
    const auto bustWith = [&](double size) {
        ShapeFactors tried = f;
        tried.breast = size;
        const MannequinShape shape = mannequinShape(m, tried);
        return tapeGirth(shape, tapePlane(shape, GirthName::bust));
    };
    const double now = bustWith(f.breast);
    if (f.chest < 1) {
        f.chest = std::min(f.chest * aim / now, 1.0);
        return std::abs(now - aim);
    }
    const double slope = (bustWith(f.breast + 0.05) - now) / 0.05;
    const double wanted = slope > 0.01 ? f.breast + (aim - now) / slope : flattest;
    f.breast = std::clamp(wanted, flattest, fullest);
    if (wanted < flattest) f.chest = std::min(aim / bustWith(flattest), 1.0);
    return std::abs(now - aim);
}

void fitLengths(const Measurements& m, ShapeFactors& f) {
    const MannequinShape shape = mannequinShape(m, f);
    const Landmarks l = landmarksOf(shape, m);
    const double slopeDrop = (l.acromionLeft.x - l.neckLeft.x) * std::tan(m.shoulderSlope);
    f.acromionRise += l.neckLeft.y - slopeDrop - l.acromionLeft.y;
    f.crotchRise += m.insideLeg - l.crotch.y;
    f.bustRise += distance(l.neckLeft, l.bustLeft) - m.bustHeight;
    f.wristShift += m.arm - distance(l.acromionLeft, l.wristLeft);
}

} // namespace

ShapeFactors fitted(const Measurements& m, const Girths& aims, ShapeFactors f) {
    const auto aim = [&](GirthName name) { return aims[static_cast<std::size_t>(name)]; };
    for (int round = 0; round < 16; ++round) {
        fitLengths(m, f);
        double worst = 0;
        const MannequinShape shape = mannequinShape(m, f);
        const auto correct = [&](double& factor, GirthName name) {
            const double girth = tapeGirth(shape, tapePlane(shape, name));
            factor *= std::clamp(aim(name) / girth, 0.7, 1.4);
            worst = std::max(worst, std::abs(girth - aim(name)));
        };
        correct(f.ribs, GirthName::underBust);
        correct(f.waist, GirthName::waist);
        correct(f.hip, GirthName::hip);
        correct(f.neck, GirthName::neck);
        correct(f.biceps, GirthName::biceps);
        correct(f.wrist, GirthName::wrist);
        correct(f.thigh, GirthName::thigh);
        worst = std::max(worst, fitBreast(m, aim(GirthName::bust), f));
        if (round > 1 && worst < 0.0002) break;
    }
    return f;
}

} // namespace toile::body
