// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/cloth/ClothModel.h"
#include "core/dynamics/Stage.h"

#include <array>
#include <span>
#include <vector>

namespace toile::dynamics {

/// A triangle of the cloth that air acts on; counter-clockwise seen from its right side.
struct Face {
    std::array<int, 3> particles{};
    double mass = 0;     ///< of its share of the cloth [kg]
    double share = 1;    ///< ½ for each of the four triangles that are both ways to halve a rectangle [–]
    double pressure = 0; ///< from its wrong side to its right side [Pa]
};

/// A rectangle as its four half-counted triangles, so that neither diagonal is preferred. mass: of the whole [kg]
void appendRectangle(std::vector<Face>& faces, const std::array<int, 4>& particles, double mass, double pressure);

/// Area times unit normal, out of the right side [m²].
[[nodiscard]] inline Vec3 areaOf(const Face& face, std::span<const Vec3> positions) {
    const auto [a, b, c] = face.particles;
    return 0.5 * face.share * cross(positions[b] - positions[a], positions[c] - positions[a]);
}

/// Moves free particles of a substep as far as forces [N] do in it; what lies on slaves goes to their masters.
void moveBy(std::span<Vec3> forces, const cloth::ClothModel& model, Substep& substep);

} // namespace toile::dynamics
