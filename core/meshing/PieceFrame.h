// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/meshing/GridPoint.h"
#include "core/meshing/MeshInput.h"

#include <span>

namespace toile::meshing {

/// The coordinates in which a piece is meshed: warp = +y, origin at its middle, mirrored if asked [m]; and
/// the integer grid laid over them.
struct PieceFrame {
    double grain = 0;            ///< [rad]
    double cosine = 1, sine = 0; ///< of the grain
    double side = 1;             ///< −1 when the mirror image is meshed
    Vec2 centre;                 ///< of the turned and mirrored piece [m]
    double unit = 1;             ///< of the integer grid [m]

    [[nodiscard]] Vec2 materialOf(Vec2 point) const {
        return {cosine * point.x + sine * point.y, cosine * point.y - sine * point.x};
    }
    [[nodiscard]] Vec2 frameOf(Vec2 point) const {
        const Vec2 material = materialOf(point);
        return Vec2{side * material.x, material.y} - centre;
    }
    [[nodiscard]] Vec2 materialFromFrame(Vec2 inFrame) const {
        const Vec2 shifted = inFrame + centre;
        return {side * shifted.x, shifted.y};
    }
    [[nodiscard]] Vec2 pointOf(Vec2 material) const {
        return {cosine * material.x - sine * material.y, sine * material.x + cosine * material.y};
    }
    [[nodiscard]] Vec2 pointFromFrame(Vec2 inFrame) const { return pointOf(materialFromFrame(inFrame)); }
    [[nodiscard]] GridPoint gridOf(Vec2 inFrame) const;
    [[nodiscard]] Vec2 placeOf(GridPoint point) const; ///< in the frame [m]
};

/// The frame in which all these points, with a margin [m] around them, fit the integer grid.
[[nodiscard]] PieceFrame frameFor(double grain, bool mirrored, std::span<const Vec2> points, double margin);

/// The box of points, given in the piece's coordinates, in the frame [m].
[[nodiscard]] geometry::Box2 boxInFrame(const PieceFrame& frame, std::span<const Vec2> points);

} // namespace toile::meshing
