// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/Document.h"
#include "core/geometry/TriangleMesh.h"

namespace toile::samples {

enum class SheetPins { twoCorners, oneEdge };

/// A square of poplin, flat and level 1.5 m above the floor, its far edge (−z) held at the corners or all along.
[[nodiscard]] document::Document squareSheet(SheetPins pins, double side = 1.0, double spacing = 0.02);

/// A square cloth 1.2 m wide, flat above the round table of tableMesh().
[[nodiscard]] document::Document tablecloth(double spacing = 0.025);

/// A strip of poplin, 1 m long, that lies on the same table and hangs over its edge by 0.2 m.
[[nodiscard]] document::Document tableEdge(double spacing = 0.02);

/// V24: a tube of linear cloth without gravity and friction, sewn round the cylinder of cylinderMesh(), which is
/// thicker than the tube.
struct TubeScene {
    double restRadius = 0.095, height = 0.20; ///< of the tube [m]
    double stiffness = 100;                   ///< E round the tube and along it [N/m]
    double spacing = 0.02;                    ///< [m]
};
[[nodiscard]] document::Document tubeRoundCylinder(const TubeScene& scene = {});

/// A band round the cylinder of cylinderMesh(), without gravity and friction: two fronts, sewn together at the back,
/// that overlap by 30 mm at the front, right over left, and are held by three buttons.
struct ButtonedBand {
    double ease = 0.004;                          ///< of the radius, beyond cloth that lies on the cylinder [m]
    double height = 0.20, overlap = 0.03;         ///< [m]
    double leftStart = 0.125, rightStart = 0.125; ///< radii at which the fronts are drawn [m]
    double spacing = 0.02;                        ///< [m]
};
[[nodiscard]] document::Document buttonedBand(const ButtonedBand& band = {});

/// V21: two free squares in one plane, 0.2 m apart, sewn edge to edge without gravity and damping.
[[nodiscard]] document::Document twoSquares(double side = 0.3, double spacing = 0.02);

/// A round table on a column: top of radius 0.45 m, 0.735 m high, with a rounded rim.
[[nodiscard]] geometry::TriangleMesh tableMesh();
/// An upright cylinder of radius 0.1 m and height 0.6 m on the floor.
[[nodiscard]] geometry::TriangleMesh cylinderMesh();

} // namespace toile::samples
