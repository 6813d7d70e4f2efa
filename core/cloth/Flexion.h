// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/cloth/ClothModel.h"

namespace toile::cloth {

struct FlexionReport {
    int springs = 0;
    int dropped = 0; ///< bending elements that are no line of three nodes, hinges and twist: springs have none of them
};

/// Puts flexion springs in the place of bending: one from each node's predecessor to its successor on a line, whose
/// lengths are those of the structural springs between them.
/// Bent by an angle θ at spacings l₁, l₂ such a spring is l₁l₂θ²/(2(l₁ + l₂)) too short, so that its
/// stiffness against bending grows with the square of the curvature and is nothing where the cloth is flat.
/// It is chosen so that the moment is the fabric's at the given curvature [1/m]: k = 16·B·w/((l₁l₂)²·(l₁ +
/// l₂)·κ²) for lines of width w. For comparison with the paper's model. Ref: Provot 1995;
/// docs/physics/bending.md
FlexionReport flexionInsteadOfBending(ClothModel& model, double curvature);

} // namespace toile::cloth
