// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/TriangleMesh.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

namespace toile::body {

/// Named points of a body. Left is the body's own left: +x when it faces +z, y up. [m]
struct Landmarks {
    Vec3 nape;                        ///< back-neck point (7th cervical vertebra)
    Vec3 frontNeck;                   ///< pit of the neck
    Vec3 neckLeft, neckRight;         ///< side neck points, where shoulder seams begin
    Vec3 acromionLeft, acromionRight; ///< shoulder points
    Vec3 bustLeft, bustRight;         ///< bust points
    Vec3 waist;                       ///< centre of the waist section
    Vec3 hip;                         ///< centre of the fullest hip section
    Vec3 crotch;                      ///< lowest point between the legs
    Vec3 wristLeft, wristRight;       ///< centres of the wrist sections
    Vec3 ankleLeft, ankleRight;       ///< centres of the ankle sections
    friend bool operator==(const Landmarks&, const Landmarks&) = default;
};

enum class Limb { neck, torso, leftArm, rightArm, leftLeg, rightLeg };

/// "left arm".
[[nodiscard]] constexpr std::string_view nameOf(Limb limb) {
    switch (limb) {
    case Limb::neck: return "neck";
    case Limb::torso: return "torso";
    case Limb::leftArm: return "left arm";
    case Limb::rightArm: return "right arm";
    case Limb::leftLeg: return "left leg";
    case Limb::rightLeg: return "right leg";
    }
    return {};
}

/// The middle line of a limb as a polyline from the trunk outward, past the end of the mesh:
/// neck up through the head, torso from the neck down to below the crotch, arms past the hands, legs past the
/// feet.
struct LimbAxis {
    Limb limb = Limb::torso;
    std::vector<Vec3> points;
    friend bool operator==(const LimbAxis&, const LimbAxis&) = default;
};

/// A body as the simulation knows it.
struct Body {
    std::string name;
    geometry::TriangleMesh mesh;
    Landmarks landmarks;
    std::vector<LimbAxis> axes; ///< empty when the mesh is not a human body (a table)
    friend bool operator==(const Body&, const Body&) = default;
};

/// The middle line of a limb, of two points at least; null when the body has none.
[[nodiscard]] inline const LimbAxis* axisOf(const Body& body, Limb limb) {
    const auto found = std::ranges::find(body.axes, limb, &LimbAxis::limb);
    return found == body.axes.end() || found->points.size() < 2 ? nullptr : &*found;
}

} // namespace toile::body
