// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/body/Arrangement.h"

#include "core/body/MeshSection.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace toile::body {

namespace {

constexpr std::array allLimbs{Limb::neck, Limb::torso, Limb::leftArm, Limb::rightArm, Limb::leftLeg, Limb::rightLeg};
constexpr int ringCount = 12;

/// Orthonormal, y as given, z as near to the front as it can be.
Transform frameAlong(const Vec3& origin, const Vec3& along) {
    const Vec3 y = normalized(along), front = {0, 0, 1};
    const Vec3 z = normalized(front - y * dot(front, y));
    return {cross(y, z), y, z, origin};
}

double crownOf(const Body& body) {
    return geometry::boundsOf(body.mesh.vertices).high.y;
}

/// The two ends between which a limb is measured.
struct Ends {
    Vec3 from, to;
};

Ends endsOf(const Body& body, const LimbAxis& axis) {
    const Landmarks& l = body.landmarks;
    switch (axis.limb) {
    case Limb::neck: {
        const Vec3 base = lerp(l.nape, l.frontNeck, 0.5);
        const Vec3 up = axis.points.size() > 2 ? axis.points[2] - base : Vec3{0, 1, 0};
        const Vec3 along = up.y > 0 ? normalized(up) : Vec3{0, 1, 0};
        return {base, base + along * ((crownOf(body) - base.y) / std::max(along.y, 0.5))};
    }
    case Limb::torso: return {l.waist, {l.waist.x, l.nape.y, l.waist.z}};
    case Limb::leftArm: return {axis.points.front(), l.wristLeft};
    case Limb::rightArm: return {axis.points.front(), l.wristRight};
    case Limb::leftLeg: return {{axis.points.front().x, l.crotch.y, axis.points.front().z}, l.ankleLeft};
    case Limb::rightLeg: break;
    }
    return {{axis.points.front().x, l.crotch.y, axis.points.front().z}, l.ankleRight};
}

/// The curve round the middle of the limb at a place along it; if there the trunk is in the plane too, still
/// that curve.
std::optional<ArrangementRing> ringAt(const Body& body, const Transform& frame, double at) {
    const auto loop = sectionRound(body.mesh, {frame.point({0, at, 0}), frame.axisY});
    if (!loop) return std::nullopt;
    ArrangementRing ring{.at = at};
    for (const Vec3& p : loop->points) {
        const double x = dot(p - frame.origin, frame.axisX), z = dot(p - frame.origin, frame.axisZ);
        ring.side = std::max(ring.side, std::abs(x));
        ring.front = std::max(ring.front, z);
        ring.back = std::max(ring.back, -z);
    }
    return ring;
}

/// Across the limb: half-width and half-depth in the middle of a limb, by which sizes compare.
struct Girthiness {
    double side, depth;
};

std::optional<Girthiness> middleSize(const Body& body, Limb limb) {
    const auto frame = limbFrame(body, limb);
    if (!frame) return std::nullopt;
    const auto ring = ringAt(body, *frame,
                             (limb == Limb::torso  ? 0.25
                              : limb == Limb::neck ? 0.1
                                                   : 0.4) *
                                 limbLength(body, limb));
    if (!ring) return std::nullopt;
    return Girthiness{ring->side, (ring->front + ring->back) / 2};
}

} // namespace

std::optional<Transform> limbFrame(const Body& body, Limb limb) {
    const LimbAxis* axis = axisOf(body, limb);
    if (!axis) return std::nullopt;
    const auto [from, to] = endsOf(body, *axis);
    return frameAlong(from, to - from);
}

double limbLength(const Body& body, Limb limb) {
    const LimbAxis* axis = axisOf(body, limb);
    if (!axis) return 0;
    const auto [from, to] = endsOf(body, *axis);
    return distance(from, to);
}

std::optional<geometry::Polyline> limbLine(const Body& body, Limb limb) {
    constexpr double step = 0.01, rounding = 0.05, nearness = 0.03; // [m]
    const LimbAxis* axis = axisOf(body, limb);
    if (!axis || limb == Limb::neck || limb == Limb::torso) return std::nullopt;
    geometry::Polyline line;
    for (const Vec3& p : axis->points) // two points that nearly coincide give no direction
        if (line.empty() || distance(line.back(), p) > nearness) line.push_back(p);
    if (line.size() < 2) return std::nullopt;
    return geometry::rounded(line, step, rounding);
}

double limbLineLength(const Body& body, Limb limb, const geometry::Polyline& line) {
    const LimbAxis* axis = axisOf(body, limb);
    return axis ? geometry::nearestArcLength(line, endsOf(body, *axis).to) : 0;
}

std::vector<ArrangementVolume> arrangementVolumes(const Body& body) {
    std::vector<ArrangementVolume> volumes;
    for (const Limb limb : allLimbs) {
        const auto frame = limbFrame(body, limb);
        if (!frame) continue;
        ArrangementVolume volume{.limb = limb, .frame = *frame, .length = limbLength(body, limb), .rings = {}};
        for (int n = 0; n < ringCount; ++n)
            if (const auto ring = ringAt(body, *frame, volume.length * n / (ringCount - 1)))
                volume.rings.push_back(*ring);
        volumes.push_back(std::move(volume));
    }
    return volumes;
}

std::optional<Transform> carriedOver(const Body& from, const Body& to, Limb limb) {
    const auto start = limbFrame(from, limb), end = limbFrame(to, limb);
    const auto startSize = middleSize(from, limb), endSize = middleSize(to, limb);
    if (!start || !end || !startSize || !endSize) return std::nullopt;
    const double along = limbLength(to, limb) / limbLength(from, limb);
    const double across = endSize->side / startSize->side, deep = endSize->depth / startSize->depth;
    const Transform outward{end->axisX * across, end->axisY * along, end->axisZ * deep, end->origin};
    const Vec3 &x = start->axisX, &y = start->axisY, &z = start->axisZ;
    const Transform inward{{x.x, y.x, z.x}, {x.y, y.y, z.y}, {x.z, y.z, z.z}, {}}; // the transposed rotation
    return composed(outward, {inward.axisX, inward.axisY, inward.axisZ, -inward.direction(start->origin)});
}

std::optional<double> sizeRatio(const Body& from, const Body& to, Limb limb) {
    const auto start = middleSize(from, limb), end = middleSize(to, limb);
    if (!start || !end) return std::nullopt;
    return (end->side + end->depth) / (start->side + start->depth);
}

std::optional<Transform> placementCarriedOver(const Transform& placement, const Body& from, const Body& to, Limb limb) {
    const auto carried = carriedOver(from, to, limb);
    if (!carried) return std::nullopt;
    const Transform start = *limbFrame(from, limb), end = *limbFrame(to, limb);
    const auto turned = [&](const Vec3& d) {
        return end.direction({dot(d, start.axisX), dot(d, start.axisY), dot(d, start.axisZ)});
    };
    return Transform{turned(placement.axisX), turned(placement.axisY), turned(placement.axisZ),
                     carried->point(placement.origin)};
}

} // namespace toile::body
