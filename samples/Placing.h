// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/body/Landmarks.h"
#include "core/pattern/Pattern.h"

namespace toile::samples {

/// Level, right side up, the piece's y axis away from the viewer (−z).
[[nodiscard]] inline Transform lyingAt(const Vec3& origin) {
    return {{1, 0, 0}, {0, 0, -1}, {0, 1, 0}, origin};
}

/// The placement that makes a mirror piece (mirrored at the piece's own y axis) start as the mirror image, x ↦ −x of
/// the world, of its source.
[[nodiscard]] pattern::Placement mirrored(const pattern::Placement& placement);

/// A vertical panel before (facing +z) or behind (facing −z) the body.
struct Panel {
    bool behind = false;
    double height = 0;       ///< of the piece's origin [m]
    double lean = 0;         ///< its top towards the body [rad]
    double radius = 0.22;    ///< of the curl [m]
    double clearance = 0.02; ///< to the body [m]
    double aside = 0;        ///< x of the piece's origin [m]
};

/// Moves the panel towards the body until a body point behind the piece is as near as the clearance.
[[nodiscard]] pattern::Placement placedPanel(const pattern::Piece& piece, const body::Body& body, const Panel& panel);

/// A straight stretch of a limb.
struct LimbLine {
    Vec3 start, direction; ///< outward, unit
};

/// The line of the upper arm and forearm together, from beside the shoulder point to the wrist.
[[nodiscard]] LimbLine armLine(const body::Body& body, bool left);

/// Wraps a piece round a limb: the piece's x = 0 on the upper (outer) side, its y axis up the limb, the right side
/// out; the piece's y = 0 lies `along` metres down the line.
[[nodiscard]] pattern::Placement placedTube(const LimbLine& limb, double along, double radius);

/// Points all over a piece: on its outline and on a grid inside, about `step` apart [m].
[[nodiscard]] std::vector<Vec2> pointsOn(const pattern::Piece& piece, double step);

/// The least distance between points on the placed piece and vertices of the body [m].
[[nodiscard]] double clearanceOf(const pattern::Piece& piece, const pattern::Placement& placement,
                                 const body::Body& body);

/// How far a limb reaches from its line between two distances along it [m].
[[nodiscard]] double limbRadius(const body::Body& body, const LimbLine& limb, double from, double to, double within);

} // namespace toile::samples
