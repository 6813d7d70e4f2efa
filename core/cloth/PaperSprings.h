// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/cloth/ClothModel.h"

namespace toile::cloth {

/// What was lost on the way to springs alone.
struct PaperReport {
    int triangles = 0; ///< that became three springs each
    double fitResidual = 0; ///< RMS over them of ‖C_springs − C‖/‖C‖ [–]: three springs have three of six constants
    int flexionSprings = 0;
    int droppedBending = 0; ///< FlexionReport
};

/// Three springs along the sides of a triangle, none negative, whose stiffness tensor comes nearest to its membrane's.
[[nodiscard]] std::array<Spring, 3> springsInsteadOf(const MembraneTriangle& triangle);

/// The cloth of the 2002 paper: structural, shear and flexion springs and nothing else. Membrane triangles become their
/// sides, bending becomes flexion springs that are as stiff as the fabric at this curvature [1/m]. The cloth has been
/// made with CellForm::springs. Ref: docs/physics/paper.md
PaperReport springsAlone(ClothModel& model, double curvature);

} // namespace toile::cloth
