// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cloth/Flexion.h"

#include "core/base/Contracts.h"

#include <algorithm>
#include <cmath>

namespace toile::cloth {
namespace {

/// The spring for one element Σ c·x = κ of three nodes, with energy ½·B·w·(l₁ + l₂)/2·|κ|².
Spring springFor(const Stencil& stencil, double curvature) {
    std::array<int, 3> order{0, 1, 2}; // the centre last: its coefficient −2/(l₁l₂) is the largest
    std::ranges::sort(order, {}, [&](int i) { return std::abs(stencil.coefficients[i]); });
    const double toFirst = std::abs(stencil.coefficients[order[0]]),
                 toSecond = std::abs(stencil.coefficients[order[1]]);
    const double product = 2 / std::abs(stencil.coefficients[order[2]]); // l₁l₂
    const double l1 = std::sqrt(product * toSecond / toFirst), l2 = product / l1, both = l1 + l2;
    const double bendingTimesWidth = 2 * stencil.stiffness / both;
    return {stencil.particles[order[0]], stencil.particles[order[1]], both,
            16 * bendingTimesWidth / (product * product * both * curvature * curvature)};
}

} // namespace

FlexionReport flexionInsteadOfBending(ClothModel& model, double curvature) {
    expects(curvature > 0, "flat cloth has no flexion stiffness to compare with");
    FlexionReport report;
    for (const Stencil& stencil : model.bending) {
        double sum = 0, largest = 0; // a line of three nodes: opposite signs, nothing over
        int used = 0;
        for (int i = 0; i < 4 && stencil.particles[i] >= 0; ++i, ++used) {
            sum += stencil.coefficients[i];
            largest = std::max(largest, std::abs(stencil.coefficients[i]));
        }
        if (used != 3 || std::abs(sum) > 1e-9 * largest) {
            ++report.dropped;
            continue;
        }
        model.flexion.push_back(springFor(stencil, curvature));
        ++report.springs;
    }
    report.dropped += static_cast<int>(model.twist.size() + model.hinges.size());
    model.bending.clear();
    model.twist.clear();
    model.hinges.clear();
    return report;
}

} // namespace toile::cloth
