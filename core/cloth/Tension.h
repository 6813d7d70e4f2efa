// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/material/Fabric.h"

#include <vector>

namespace toile::cloth {

/// Response to a strain e for a zero-strain modulus of 1.
struct TensionResponse {
    double stress = 0;  ///< s(e) = f(e)·e
    double tangent = 1; ///< ds/de, never negative
    double energy = 0;  ///< ∫₀ᵉ s
};

/// See TensionCurves for the law. An empty curve is linear.
[[nodiscard]] TensionResponse tensionResponse(const std::vector<material::TensionPoint>& curve, double strain);

/// s(e)/e of the same, at less cost: 1 in compression.
[[nodiscard]] double tensionSecant(const std::vector<material::TensionPoint>& curve, double strain);

} // namespace toile::cloth
