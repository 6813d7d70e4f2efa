// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/dynamics/AdaptiveTrBdf2.h"

#include <algorithm>
#include <cmath>

namespace toile::dynamics {
namespace {

/// How much longer the next part may be than one of this error. Small changes are not worth a new matrix.
double growthAfter(double error) {
    const double growth = error > 0 ? std::clamp(0.9 * std::cbrt(1 / error), 0.3, 2.0) : 2;
    return growth > 0.8 && growth < 1.2 && error <= 1 ? 1 : growth;
}

} // namespace

double AdaptiveTrBdf2::errorOf(const std::vector<Vec3>& difference, double h) {
    const double span = h * trBdf2().a[1][1];
    const std::vector<Vec3> filtered = stage().resisted(difference, span);
    double sum = 0, mass = 0;
    for (const int p : eliminated().free()) {
        sum += model().mass[p] * squaredLength(filtered[p]);
        mass += model().mass[p];
    }
    return mass > 0 ? std::sqrt(sum / mass) / settings_.tolerance : 0;
}

Result<StepReport> AdaptiveTrBdf2::advance(ParticleState& state, double duration, const Vec3& gravity,
                                           std::span<Stage* const> stages, std::stop_token stop) {
    StepReport sum{.parts = 0};
    double left = duration, wanted = wanted_ > 0 ? wanted_ : duration;
    while (left > 0) {
        const double parts = std::max(1.0, std::ceil(left / wanted - 1e-9)),
                     h = left / parts; // no crumb at the end
        const ParticleState start = state;
        const auto step = once(state, h, gravity, stages, stop);
        if (!step) return tl::unexpected(step.error());
        const bool solved = step->report.accurate;
        const double error = solved ? errorOf(step->difference, h) : 0;
        const bool good = solved && error <= 1;
        StepReport report = step->report;
        if (!good && h > settings_.smallestStep) {
            state = start;
            wanted = std::max(settings_.smallestStep, h * (solved ? std::min(0.9, growthAfter(error)) : 0.5));
            report.parts = 0;
            report.repeated = 1;
            report.accurate = true;
            report.residual = 0;
            sum += report;
            continue;
        }
        report.accurate = good;
        sum += report;
        left = parts > 1 ? left - h : 0;
        wanted = good ? h * growthAfter(error) : 2 * h;
    }
    wanted_ = wanted;
    return sum;
}

} // namespace toile::dynamics
