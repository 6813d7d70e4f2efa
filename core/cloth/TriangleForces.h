// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/cloth/TriangleStrain.h"

#include <array>

namespace toile::cloth {

/// W = area·[C11·U(E_xx) + C22·U(E_yy) + C12·E_xx·E_yy + ½C33·(2E_xy)²]  [J], E the Biot strain, U = ∫ of the tension
/// curve (E²/2 when linear).
[[nodiscard]] double triangleEnergy(const ClothModel& model, const MembraneTriangle& triangle,
                                    const DeformationGradient& f);
/// ∂W/∂F [N·m].
[[nodiscard]] DeformationGradient triangleGradient(const ClothModel& model, const MembraneTriangle& triangle,
                                                   const DeformationGradient& f);
/// ∂²W/∂F∂F, 6×6 column-major over (F_u, F_v).
[[nodiscard]] std::array<double, 36> triangleHessian(const ClothModel& model, const MembraneTriangle& triangle,
                                                     const DeformationGradient& f);

} // namespace toile::cloth
