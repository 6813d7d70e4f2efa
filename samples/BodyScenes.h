// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/Document.h"
#include "core/geometry/TriangleMesh.h"

/// Cloth on bodies simple enough to be set up in any program, to be measured side by side.
namespace toile::samples {

/// A square that falls on the ball of ballMesh(), hangs from it in folds and meets itself.
struct ClothOverBall {
    double side = 1.0;
    double spacing = side / 64; ///< 65 × 65 particles
};
[[nodiscard]] document::Document clothOverBall(const ClothOverBall& cloth = {});

/// Two rectangles before and behind the torso of capsuleMesh(), upright and flat, sewn together at the sides and on the
/// shoulders.
struct CapsuleTunic {
    double width = 0.44, height = 0.60; ///< of each [m]
    double neck = 0.16;                 ///< width of the neck opening [m]
    double spacing = 0.013;             ///< some 3 000 particles
};
[[nodiscard]] document::Document capsuleTunic(const CapsuleTunic& tunic = {});

/// Radius 0.1 m, its middle 1 m above the floor.
[[nodiscard]] geometry::TriangleMesh ballMesh();
/// Upright, of radius 0.12 m, from 0.4 to 1.3 m above the floor.
[[nodiscard]] geometry::TriangleMesh capsuleMesh();

} // namespace toile::samples
