// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/body/Mannequin.h"

#include "core/body/IsoSurface.h"
#include "core/body/MannequinFit.h"
#include "core/body/MeshSection.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <numbers>
#include <optional>

namespace toile::body {

namespace {

constexpr double girthTolerance = 0.002; // well inside the 5 mm that we promise [m]
constexpr std::array<const char*, girthCount> girthNames{"bust", "underBust", "waist", "hip",
                                                         "neck", "biceps",    "wrist", "thigh"};

std::optional<Error> firstImpossible(const Measurements& m, double edge) {
    struct Range {
        const char* name;
        double value, low, high; // [m], angles [rad]
        bool isAngle = false;
    };
    const double h = m.height;
    const Range ranges[] = {{"height", h, 1.30, 2.20},
                            {"bust", m.bust, 0.60, 1.50},
                            {"underBust", m.underBust, 0.55, m.bust},
                            {"waist", m.waist, 0.48, 1.45},
                            {"hip", m.hip, 0.65, 1.60},
                            {"neck", m.neck, 0.26, 0.52},
                            {"biceps", m.biceps, 0.18, 0.50},
                            {"wrist", m.wrist, 0.11, 0.25},
                            {"thigh", m.thigh, 0.36, std::min(0.95, 0.63 * m.hip)},
                            {"shoulderWidth", m.shoulderWidth, 0.28, 0.52},
                            {"shoulderSlope", m.shoulderSlope, 0.15, 0.60, true},
                            {"napeToWaist", m.napeToWaist, 0.18 * h, 0.31 * h},
                            {"bustHeight", m.bustHeight, 0.12 * h, 0.22 * h},
                            {"arm", m.arm, 0.28 * h, 0.42 * h},
                            {"insideLeg", m.insideLeg, 0.38 * h, 0.53 * h},
                            {"armAngle", m.armAngle, 0.00, 1.10, true},
                            {"edge", edge, 0.003, 0.015}};
    const Range* const wrong =
        std::ranges::find_if(ranges, [](const Range& r) { return !(r.value >= r.low && r.value <= r.high); });
    if (wrong == std::end(ranges)) return std::nullopt;
    const double unit = wrong->isAngle ? std::numbers::pi / 180 : 0.001;
    constexpr double hair = 1e-6; // of a division by the unit
    return Error{ErrorCode::invalidInput,
                 fmt::format("It must lie between {:g} and {:g} {} for this body, but is {:g}.",
                             std::ceil(10 * wrong->low / unit - hair) / 10, // what is said to be possible is
                             std::floor(10 * wrong->high / unit + hair) / 10, wrong->isAngle ? "degrees" : "mm",
                             wrong->value / unit),
                 {.path = wrong->name}};
}

/// Each measurement may be possible by itself and levels still lie in the wrong order.
std::optional<Error> firstCrossed(const Measurements& m) {
    constexpr double least = 0.005; // between a level and the next [m]
    const Levels y = levelsOf(m);
    struct Order {
        const char* name;
        double gap; ///< [m]
        const char* why;
    };
    const Order orders[] = {
        {"insideLeg", y.waist - y.crotch, "The crotch would lie above the waist."},
        {"underBust", y.underBust - y.waist,
         "It is too much less than the bust: the breast would reach below the waist."},
        {"bustHeight", y.acromion - y.bust, "The bust would lie above the shoulders."},
        {"shoulderSlope", y.sideNeck - 0.014 - y.acromion, "The shoulders would end above the neck."}};
    const Order* const wrong = std::ranges::find_if(orders, [](const Order& o) { return !(o.gap >= least); });
    if (wrong == std::end(orders)) return std::nullopt;
    return Error{ErrorCode::invalidInput, wrong->why, {.path = wrong->name}};
}

std::vector<Girth> measuredGirths(const geometry::TriangleMesh& mesh, const MannequinShape& shape,
                                  const Girths& asked) {
    std::vector<Girth> girths;
    for (int g = 0; g < girthCount; ++g) {
        const auto name = static_cast<GirthName>(g);
        const TapePlane plane = tapePlane(shape, name);
        const auto loop = sectionRound(mesh, {plane.origin, plane.normal});
        const bool alongArm = name == GirthName::biceps || name == GirthName::wrist;
        const double level = name == GirthName::neck ? shape.neckAt
                             : alongArm              ? dot(plane.origin - shape.armFrame.origin, shape.armFrame.axisY)
                                                     : plane.origin.y;
        girths.push_back({girthNames[static_cast<std::size_t>(g)], asked[static_cast<std::size_t>(g)],
                          loop ? tapeGirth(*loop) : 0, loop ? perimeter(*loop) : 0, level});
    }
    return girths;
}

std::vector<LimbAxis> axesOf(const MannequinShape& shape) {
    const Levels& y = shape.levels;
    const auto mirrored = [](std::vector<Vec3> points) {
        for (Vec3& p : points) p.x = -p.x;
        return points;
    };
    const auto trunk = [&](double height) { return Vec3{0, height, shape.torso.middle(height).z}; };
    const Transform& neck = shape.neckFrame;
    const double headZ = shape.head.middle(y.crown - 0.1).z;
    const std::vector<Vec3> arm{shape.armFrame.origin, shape.arm.middle(shape.bicepsAt),
                                shape.arm.middle(shape.wristAt),
                                shape.arm.middle(shape.wristAt) + shape.armFrame.axisY * 0.30};
    const Vec3 ankle = shape.leg.middle(y.ankle);
    const std::vector<Vec3> leg{shape.leg.middle(y.crotch + 0.02),
                                shape.leg.middle(y.thigh),
                                shape.leg.middle(y.knee),
                                ankle,
                                {ankle.x, -0.10, ankle.z}};
    return {{Limb::neck,
             {trunk(y.acromion - 0.06),
              neck.origin,
              neck.point({0, 0.10, 0}),
              {0, y.chin + 0.08, headZ},
              {0, y.crown + 0.10, headZ}}},
            {Limb::torso,
             {neck.origin,
              trunk(y.acromion - 0.06),
              trunk(y.bust),
              trunk(y.underBust),
              trunk(y.waist),
              trunk(y.hip),
              trunk(y.crotch + 0.03),
              {0, y.crotch - 0.45, trunk(y.crotch + 0.03).z}}},
            {Limb::leftArm, arm},
            {Limb::rightArm, mirrored(arm)},
            {Limb::leftLeg, leg},
            {Limb::rightLeg, mirrored(leg)}};
}

/// Down or up onto the floor: the lowest vertex gets y = 0 exactly.
void standOnFloor(Body& body) {
    const Vec3 down{0, geometry::boundsOf(body.mesh.vertices).low.y, 0};
    for (Vec3& p : body.mesh.vertices) p -= down;
    Landmarks& l = body.landmarks;
    for (Vec3* p :
         {&l.nape, &l.frontNeck, &l.neckLeft, &l.neckRight, &l.acromionLeft, &l.acromionRight, &l.bustLeft,
          &l.bustRight, &l.waist, &l.hip, &l.crotch, &l.wristLeft, &l.wristRight, &l.ankleLeft, &l.ankleRight})
        *p -= down;
    for (LimbAxis& axis : body.axes)
        for (Vec3& p : axis.points) p -= down;
}

/// Of the girths the one farthest from what was asked.
const Girth& worstOf(const std::vector<Girth>& girths) {
    return *std::ranges::max_element(girths, {}, [](const Girth& g) { return std::abs(g.hull - g.asked); });
}

} // namespace

Result<Mannequin> makeMannequin(const Measurements& m, double edge) {
    if (auto impossible = firstImpossible(m, edge)) return tl::unexpected(*impossible);
    if (auto crossed = firstCrossed(m)) return tl::unexpected(*crossed);
    const Girths asked = askedGirths(m);
    Girths aims = asked;
    ShapeFactors factors;
    std::vector<Girth> girths;
    for (int round = 0; round < 3; ++round) {
        factors = fitted(m, aims, factors);
        const MannequinShape shape = mannequinShape(m, factors);
        const Vec3 seed{0, shape.levels.waist, shape.torso.middle(shape.levels.waist).z};
        auto mesh = isoSurface([&](const Vec3& p) { return shape.distance(p); }, seed, {.spacing = edge});
        if (!mesh) return tl::unexpected(mesh.error());
        girths = measuredGirths(*mesh, shape, asked);
        if (std::abs(worstOf(girths).hull - worstOf(girths).asked) <= girthTolerance) {
            Body body{"mannequin", std::move(*mesh), landmarksOf(shape, m), axesOf(shape)};
            standOnFloor(body);
            return Mannequin{std::move(body), m, std::move(girths)};
        }
        for (std::size_t g = 0; g < girthCount; ++g)
            aims[g] += asked[g] - girths[g].hull; // flat faces cut the curves short
    }
    const Girth& worst = worstOf(girths);
    return fail(ErrorCode::notConverged,
                fmt::format("A girth of {:.1f} mm was not reached (closest {:.1f} mm); it does not go with the other "
                            "measurements.",
                            1000 * worst.asked, 1000 * worst.hull),
                {.path = worst.name});
}

} // namespace toile::body
