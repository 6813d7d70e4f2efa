// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cloth/Tension.h"

#include <algorithm>

namespace toile::cloth {

TensionResponse tensionResponse(const std::vector<material::TensionPoint>& curve, double strain) {
    if (strain <= 0 || curve.empty()) return {strain, 1, 0.5 * strain * strain};
    double energy = 0;
    material::TensionPoint last; // f(0) = 1
    double slope = 0;            // f' of the stretch before the last point
    for (const material::TensionPoint& point : curve) {
        if (point.strain <= last.strain) continue;
        slope = (point.modulusFactor - last.modulusFactor) / (point.strain - last.strain);
        const double base = last.modulusFactor - slope * last.strain; // f(e) = base + slope·e
        const double end = std::min(strain, point.strain);
        const auto potential = [&](double e) { return e * e * (base / 2 + slope * e / 3); };
        energy += potential(end) - potential(last.strain);
        if (strain <= point.strain)
            return {(base + slope * strain) * strain, std::max(0.0, base + 2 * slope * strain), energy};
        last = point;
    }
    const double tangent = std::max(0.0, last.modulusFactor + slope * last.strain);
    const double beyond = strain - last.strain, stress = last.modulusFactor * last.strain;
    return {stress + tangent * beyond, tangent, energy + beyond * (stress + 0.5 * tangent * beyond)};
}

double tensionSecant(const std::vector<material::TensionPoint>& curve, double strain) {
    if (strain <= 0 || curve.empty()) return 1;
    material::TensionPoint last; // f(0) = 1
    for (const material::TensionPoint& point : curve) {
        if (point.strain <= last.strain) continue;
        if (strain <= point.strain)
            return last.modulusFactor +
                   (point.modulusFactor - last.modulusFactor) * (strain - last.strain) / (point.strain - last.strain);
        last = point;
    }
    return tensionResponse(curve, strain).stress / strain;
}

} // namespace toile::cloth
