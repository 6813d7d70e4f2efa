// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/body/Measuring.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace toile::body {
namespace {

constexpr double bicepsShare = 0.27; ///< of the way from shoulder joint to wrist, where the mannequin's is taken
constexpr double neckAbove = 0.030;  ///< the middle of nape and pit of the neck [m]
constexpr double thighBelow = 0.030; ///< the crotch [m]
constexpr double underBustShare = 0.078 / 1.68; ///< below the bust, of the height
constexpr double neckLean = 0.27;               ///< forward [rad]

/// A tape's plane, under the name of what it measures.
struct Tape {
    const char* name;
    double Measurements::*girth;
    Plane plane;
};

const std::vector<Vec3>* lineOf(const Body& body, Limb limb) {
    const LimbAxis* axis = axisOf(body, limb);
    return axis ? &axis->points : nullptr;
}

/// Where a line that runs down passes a height; beyond its ends straight above or below them.
Vec3 atHeight(const std::vector<Vec3>& line, double y) {
    for (std::size_t i = 0; i + 1 < line.size(); ++i)
        if ((line[i].y - y) * (line[i + 1].y - y) <= 0 && line[i].y != line[i + 1].y)
            return lerp(line[i], line[i + 1], (y - line[i].y) / (line[i + 1].y - line[i].y));
    const Vec3 end = y > line.front().y ? line.front() : line.back();
    return {end.x, y, end.z};
}

/// Square to the arm, a share of the way along its line from the joint to the wrist.
Plane acrossArm(const std::vector<Vec3>& line, const Vec3& wrist, double share) {
    const auto end = std::ranges::min_element(line, {}, [&](const Vec3& p) { return distance(p, wrist); });
    double whole = 0;
    for (auto p = line.begin(); p != end; ++p) whole += distance(*p, *(p + 1));
    double left = share * whole;
    for (auto p = line.begin(); p != end; ++p) {
        const double step = distance(*p, *(p + 1));
        if (left <= step) return {lerp(*p, *(p + 1), left / step), normalized(*(p + 1) - *p)};
        left -= step;
    }
    return {*end, normalized(*end - *(end - 1))};
}

/// From shoulder point to wrist along a bent arm: longer than straight as its middle line is.
double armLength(const std::vector<Vec3>& line, const Landmarks& at) {
    double along = distance(at.acromionLeft, at.wristLeft);
    const auto end = std::ranges::min_element(line, {}, [&](const Vec3& p) { return distance(p, at.wristLeft); });
    double bent = 0;
    for (auto p = line.begin(); p != end; ++p) bent += distance(*p, *(p + 1));
    return along * bent / distance(line.front(), *end);
}

void takeLengths(Measurements& m, const Body& body, const std::vector<Vec3>& arm) {
    const Landmarks& at = body.landmarks;
    const Vec3 shoulder = at.acromionLeft - at.neckLeft, hanging = at.wristLeft - arm.front();
    m.shoulderWidth = distance(at.acromionLeft, at.acromionRight);
    m.shoulderSlope = std::atan2(-shoulder.y, std::abs(shoulder.x));
    m.napeToWaist = at.nape.y - at.waist.y;
    m.bustHeight = distance(at.neckLeft, at.bustLeft);
    m.arm = armLength(arm, at);
    m.insideLeg = at.crotch.y - geometry::boundsOf(body.mesh.vertices).low.y;
    m.armAngle = std::atan2(-hanging.y, std::hypot(hanging.x, hanging.z));
}

Result<void> take(Measurements& m, const Body& body, const Tape& tape) {
    const auto loop = sectionRound(body.mesh, tape.plane);
    if (!loop)
        return fail(ErrorCode::invalidInput, fmt::format("No tape goes round its {}.", tape.name),
                    {.object = body.name});
    m.*tape.girth = tapeGirth(*loop);
    return {};
}

} // namespace

std::optional<Plane> acrossTrunk(const Body& body, double height) {
    const auto* torso = lineOf(body, Limb::torso);
    return torso ? std::optional(Plane{atHeight(*torso, height)}) : std::nullopt;
}

Result<Measurements> measurementsOf(const Body& body) {
    const auto *torso = lineOf(body, Limb::torso), *arm = lineOf(body, Limb::leftArm),
               *leg = lineOf(body, Limb::leftLeg);
    if (!torso || !arm || !leg)
        return fail(ErrorCode::invalidInput, "The body has no limbs that could be measured.", {.object = body.name});
    const Landmarks& at = body.landmarks;
    const geometry::Box3 bounds = geometry::boundsOf(body.mesh.vertices);
    Measurements m;
    m.height = bounds.high.y - bounds.low.y;
    takeLengths(m, body, *arm);
    const auto trunk = [&](double height) { return *acrossTrunk(body, height); };
    const Vec3 up{0, std::cos(neckLean), std::sin(neckLean)};
    Tape tapes[] = {
        {"bust", &Measurements::bust, trunk(at.bustLeft.y)},
        {"underBust", &Measurements::underBust, trunk(at.bustLeft.y - underBustShare * m.height)},
        {"waist", &Measurements::waist, trunk(at.waist.y)},
        {"hip", &Measurements::hip, trunk(at.hip.y)},
        {"neck", &Measurements::neck, {lerp(at.nape, at.frontNeck, 0.5) + neckAbove * up, up}},
        {"biceps", &Measurements::biceps, acrossArm(*arm, at.wristLeft, bicepsShare)},
        {"wrist", &Measurements::wrist, acrossArm(*arm, at.wristLeft, 1)},
        {"thigh", &Measurements::thigh, Plane{atHeight(*leg, at.crotch.y - thighBelow)}},
    };
    for (const Tape& tape : tapes)
        if (auto taken = take(m, body, tape); !taken) return tl::unexpected(taken.error());
    Tape& underBust = tapes[1];
    underBust.plane.origin.y -= 0.15 * std::max(m.bust - m.underBust - 0.12, 0.0); // lower for a full bust
    if (auto taken = take(m, body, underBust); !taken) return tl::unexpected(taken.error());
    return m;
}

} // namespace toile::body
