// SPDX-License-Identifier: GPL-3.0-or-later
#include "samples/Placing.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace toile::samples {
namespace {

using namespace pattern;

Vec3 reflected(const Vec3& p) {
    return {-p.x, p.y, p.z};
}

Transform standing(const Panel& panel) {
    const double c = std::cos(panel.lean), s = std::sin(panel.lean), side = panel.behind ? -1 : 1;
    return {{side, 0, 0}, {0, c, -side * s}, {0, s, side * c}, {panel.aside, panel.height, 0}};
}

/// Coordinates of a world point in a rigid frame.
Vec3 local(const Transform& frame, const Vec3& p) {
    const Vec3 d = p - frame.origin;
    return {dot(d, frame.axisX), dot(d, frame.axisY), dot(d, frame.axisZ)};
}

Polygon flatOutline(const Piece& piece) {
    Polygon outline;
    for (std::size_t e = 0; e < piece.outline.edges.size(); ++e) {
        const auto points = geometry::flattened(curveOf(piece.outline, e), 1e-3);
        outline.insert(outline.end(), points.begin(), points.end() - 1);
    }
    return outline;
}

} // namespace

Placement mirrored(const Placement& placement) {
    const Transform& t = placement.transform;
    Placement image = placement;
    image.transform = {-reflected(t.axisX), reflected(t.axisY), reflected(t.axisZ), reflected(t.origin)};
    return image;
}

Placement placedPanel(const Piece& piece, const body::Body& body, const Panel& panel) {
    Placement placement{standing(panel), Curl{{0, 1}, panel.radius}};
    const Polygon outline = flatOutline(piece);
    const double inner = panel.radius - panel.clearance, side = panel.behind ? -1 : 1;
    // The farther out a leaning panel stands, the other heights of the body it meets: a few rounds settle it.
    for (int round = 0; round < 8; ++round) {
        double outward = -1;
        for (const Vec3& vertex : body.mesh.vertices) {
            const Vec3 p = local(placement.transform, vertex);
            if (std::abs(p.x) >= inner) continue;
            const Vec2 flat{panel.radius * std::asin(p.x / panel.radius), p.y};
            // A half piece at the centre line stands for its mirror image as well.
            const bool mirrored = panel.aside == 0 && geometry::windingNumber(outline, {-flat.x, flat.y});
            if (!mirrored && !geometry::windingNumber(outline, flat)) continue;
            outward = std::max(outward, p.z + panel.radius - std::sqrt(inner * inner - p.x * p.x));
        }
        expects(outward > -1, "the body stands behind the panel");
        placement.transform.origin.z += side * outward / std::cos(panel.lean);
    }
    return placement;
}

LimbLine armLine(const body::Body& body, bool left) {
    const body::Landmarks& at = body.landmarks;
    const Vec3 wrist = left ? at.wristLeft : at.wristRight, acromion = left ? at.acromionLeft : at.acromionRight;
    const auto wanted = left ? body::Limb::leftArm : body::Limb::rightArm;
    const auto axis = std::ranges::find(body.axes, wanted, &body::LimbAxis::limb);
    expects(axis != body.axes.end(), "a human body has arms");
    const Vec3 shoulder =
        *std::ranges::min_element(axis->points, {}, [&](const Vec3& p) { return distance(p, acromion); });
    return {shoulder, normalized(wrist - shoulder)};
}

Placement placedTube(const LimbLine& limb, double along, double radius) {
    const Vec3 up = -limb.direction;
    const Vec3 world{0, 1, 0};
    const Vec3 outer = normalized(world - dot(world, up) * up);
    const Vec3 centre = limb.start + along * limb.direction;
    return {{cross(up, outer), up, outer, centre + radius * outer}, Curl{{0, 1}, radius}};
}

std::vector<Vec2> pointsOn(const Piece& piece, double step) {
    const Polygon outline = flatOutline(piece);
    std::vector<Vec2> points = outline;
    const auto [low, high] = geometry::boundsOf(outline);
    for (double x = low.x; x < high.x; x += step)
        for (double y = low.y; y < high.y; y += step)
            if (geometry::windingNumber(outline, {x, y})) points.push_back({x, y});
    return points;
}

double clearanceOf(const Piece& piece, const Placement& placement, const body::Body& body) {
    double least = std::numeric_limits<double>::infinity();
    for (const Vec2 point : pointsOn(piece, 0.015)) {
        const Vec3 p = placed(placement, point);
        for (const Vec3& vertex : body.mesh.vertices) least = std::min(least, squaredLength(p - vertex));
    }
    return std::sqrt(least);
}

double limbRadius(const body::Body& body, const LimbLine& limb, double from, double to, double within) {
    double radius = 0;
    for (const Vec3& vertex : body.mesh.vertices) {
        const Vec3 d = vertex - limb.start;
        const double along = dot(d, limb.direction), away = length(d - along * limb.direction);
        if (along >= from && along <= to && away < within) radius = std::max(radius, away);
    }
    return radius;
}

} // namespace toile::samples
