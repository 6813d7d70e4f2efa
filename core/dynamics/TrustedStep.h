// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/dynamics/BlockMatrix.h"
#include "core/dynamics/RoundedFactor.h"

#include <span>
#include <stop_token>
#include <vector>

namespace toile::dynamics {

/// A Newton step no longer than its quadratic model is trusted.
struct TrustedStep {
    std::vector<Vec3> move; ///< of every unknown
    double expected = 0;    ///< how far the model falls, fᵀs − ½sᵀHs
    double norm = 0;        ///< √(sᵀPs)
    bool bounded = false;   ///< ends where trust ends
    bool downwards = false; ///< there along a direction in which the model curves down
    int iterations = 0;     ///< of conjugate gradients
};

struct TrustedStepSettings {
    double forcing = 0.1;       ///< part of the largest force that may be left over [–]
    double leastForce = 0;      ///< as much may be left in any case, in the unit of the forces
    int maximumIterations = 60; ///< of conjugate gradients
    std::stop_token stop = {};  ///< of conjugate gradients none more, once it is asked
};

/// Minimises −fᵀs + ½sᵀHs over √(sᵀPs) ≤ radius, roughly: by conjugate gradients from 0 that stop where they leave the
/// radius or find that H curves down. H may be indefinite; P is what the preconditioner has factored. The first
/// direction is P⁻¹f, so that the model falls at least as far as along it. radius 0: the length of P⁻¹f.
/// Ref: Steihaug 1983
[[nodiscard]] TrustedStep trustedStep(const BlockMatrix& hessian, RoundedFactor& preconditioner,
                                      std::span<const Vec3> forces, double radius, const TrustedStepSettings& settings,
                                      Team* team = nullptr);

} // namespace toile::dynamics
