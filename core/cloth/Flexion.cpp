// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cloth/Flexion.h"

#include "core/base/Contracts.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

namespace toile::cloth {
namespace {

/// Rest lengths of the cloth's sides by their ends.
using Sides = std::map<std::pair<int, int>, double>;

Sides sidesOf(const ClothModel& model) {
    Sides sides;
    for (const Spring& spring : model.structural) sides[std::minmax(spring.a, spring.b)] = spring.restLength;
    return sides;
}

/// The spring for one element of energy ½·k·|Σ c·x|² of three nodes on a line, whose two lengths the sides tell:
/// Σ c·x = s·κ with a factor s of the element's own, so that B·w = 2·k·s²/(l₁ + l₂).
std::optional<Spring> springFor(const Stencil& stencil, const Sides& sides, double curvature) {
    std::array<int, 3> order{0, 1, 2}; // the centre last: its coefficient −2s/(l₁l₂) is the largest
    std::ranges::sort(order, {}, [&](int i) { return std::abs(stencil.coefficients[i]); });
    const auto [first, second, centre] = order;
    const auto to = [&](int end) { return sides.find(std::minmax(stencil.particles[end], stencil.particles[centre])); };
    if (to(first) == sides.end() || to(second) == sides.end()) return {};
    const double l1 = to(first)->second, l2 = to(second)->second, both = l1 + l2, product = l1 * l2;
    const double factor = std::abs(stencil.coefficients[centre]) * product / 2;
    const double bendingTimesWidth = 2 * stencil.stiffness * factor * factor / both;
    return Spring{stencil.particles[first], stencil.particles[second], both,
                  16 * bendingTimesWidth / (product * product * both * curvature * curvature)};
}

} // namespace

FlexionReport flexionInsteadOfBending(ClothModel& model, double curvature) {
    expects(curvature > 0, "flat cloth has no flexion stiffness to compare with");
    FlexionReport report;
    const Sides sides = sidesOf(model);
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
        if (const auto spring = springFor(stencil, sides, curvature)) {
            model.flexion.push_back(*spring);
            ++report.springs;
        } else {
            ++report.dropped;
        }
    }
    report.dropped += static_cast<int>(model.twist.size() + model.hinges.size());
    model.bending.clear();
    model.twist.clear();
    model.hinges.clear();
    return report;
}

} // namespace toile::cloth
