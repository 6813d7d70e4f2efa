// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/Scene.h"

#include <initializer_list>
#include <string>
#include <vector>

/// The small scenes that the parts of a step are looked at in.
namespace toile::study::lean {

inline constexpr double side = 0.3; ///< of a sheet [m]

/// A sheet in the air, right side up, its warp away from the viewer.
[[nodiscard]] pattern::Piece sheetPiece(const std::string& id, double spacing, const Vec3& origin);
/// Of plain cloth.
[[nodiscard]] simulation::Scene sceneOf(std::vector<pattern::Piece> pieces);
void pin(simulation::Scene& scene, const std::string& piece, std::initializer_list<const char*> vertices);

/// A sheet of 0.3 m in the air, in no plane of the axes' mirror: free, or held at its far corners.
[[nodiscard]] simulation::Scene freeSheet(double spacing);
[[nodiscard]] simulation::Scene heldSheet(double spacing);

/// Two squares with their sides facing each other, so far apart; and the same with a seam between these sides.
[[nodiscard]] simulation::Scene facingSquares(double spacing, double gap);
[[nodiscard]] simulation::Scene sewn(simulation::Scene scene);

/// For self-contact.
[[nodiscard]] simulation::Scene asking(simulation::Scene scene);

} // namespace toile::study::lean
