// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Result.h"
#include "core/body/Landmarks.h"

#include <string>
#include <vector>

namespace toile::body {

/// Girths as a tape lies (ISO 8559-1), lengths along the body [m]. Defaults: a woman of size EU 38–40.
struct Measurements {
    double height = 1.68;
    double bust = 0.90, underBust = 0.78, waist = 0.72, hip = 0.97;
    double neck = 0.36, biceps = 0.28, wrist = 0.16, thigh = 0.56;
    double shoulderWidth = 0.39; ///< acromion to acromion, straight
    double shoulderSlope = 0.38; ///< below the horizontal [rad]
    double napeToWaist = 0.41;   ///< vertical
    double bustHeight = 0.27;    ///< side neck point to bust point
    double arm = 0.58;           ///< acromion to wrist
    double insideLeg = 0.76;     ///< crotch to floor
    double armAngle = 0.70;      ///< A-pose: arm below the horizontal [rad]
    friend bool operator==(const Measurements&, const Measurements&) = default;
};

/// One girth of the finished mesh.
struct Girth {
    std::string name;
    double asked = 0;   ///< [m]
    double hull = 0;    ///< as a tape lies: perimeter of the convex hull of the section [m]
    double section = 0; ///< perimeter of the section itself [m]
    double level = 0;   ///< distance along the limb or height above the floor where it was taken [m]
};

struct Mannequin {
    Body body;
    Measurements measurements;
    std::vector<Girth> girths; ///< bust, underBust, waist, hip, neck, biceps, wrist, thigh
};

/// A smooth adult body, closed and manifold, facing +z, standing on y = 0, arms in an A-pose.
/// Edges of its mesh are about as long as `edge` [m]; half of it makes four times the triangles.
/// The error's place names the measurement that no body can have or that was not reached, as its field is called.
[[nodiscard]] Result<Mannequin> makeMannequin(const Measurements& measurements, double edge = 0.0115);

/// Landmarks and limb axes guessed from the shape of a standing body that faces +z with y up; error when the
/// mesh does not look like one.
[[nodiscard]] Result<Body> recognizedBody(std::string name, geometry::TriangleMesh mesh);

} // namespace toile::body
