// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/cloth/ClothModel.h"

#include <array>

namespace toile::cloth {

/// Side vectors of a membrane cell over their rest lengths: weft at the lower and the upper row, warp at the left and
/// the right column. All are linear in the corners: side[s] = Σ sideWeights(cell)[s][corner] · x(corner).
using CellSides = std::array<Vec3, 4>;

[[nodiscard]] CellSides cellSides(const MembraneCell& cell, const std::array<Vec3, 4>& corners);
/// [side][corner], [1/m].
[[nodiscard]] std::array<std::array<double, 4>, 4> sideWeights(const MembraneCell& cell);

/// W = a·b·[½C11·(U(ε₀) + U(ε₁)) + ½C22·(U(ε₂) + U(ε₃)) + ¼C12·(ε₀ + ε₁)(ε₂ + ε₃) + ½C33·(x_u·x_v)²]  [J],
/// ε_s = |side s| − 1, U = ∫ of the tension curve (ε²/2 when linear), x_u, x_v the mean sides.
[[nodiscard]] double cellEnergy(const ClothModel& model, const MembraneCell& cell, const CellSides& sides);
/// ∂W/∂side [N·m].
[[nodiscard]] CellSides cellGradient(const ClothModel& model, const MembraneCell& cell, const CellSides& sides);
/// ∂²W/∂side∂side, 12×12 column-major.
[[nodiscard]] std::array<double, 144> cellHessian(const ClothModel& model, const MembraneCell& cell,
                                                  const CellSides& sides);

} // namespace toile::cloth
