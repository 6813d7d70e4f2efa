// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/accuracy/TimeLeft.h"

#include <algorithm>
#include <cmath>

namespace toile::ui {
namespace {

/// Cost over the spacing and of a method, as the T-shirt's and the blouse's studies have it (docs/accuracy.md).
double weightOf(double factor, const std::optional<dynamics::Method>& method) {
    const double ofMethod = method && *method != dynamics::Method::xpbd ? 8 : 1;
    return ofMethod * std::pow(factor, -2.3);
}

} // namespace

TimeLeft::TimeLeft(const study::GarmentPlan& plan) {
    for (int i = 0; i < plan.referenceRuns; ++i)
        goes_.push_back({weightOf(plan.referenceFactor, dynamics::Method::xpbd), -1, {}});
    const int setups = static_cast<int>(plan.setups.size());
    for (int repetition = 0; repetition < plan.repetitions; ++repetition)
        for (const study::GarmentSetup& setup : plan.setups)
            goes_.push_back({weightOf(setup.factor, setup.method), repetition > 0 ? goes() - setups : -1, {}});
}

void TimeLeft::begin(int go, double now) {
    if (current_ >= 0 && go > current_ && current_ < goes())
        goes_[static_cast<std::size_t>(current_)].taken = now - start_;
    current_ = go;
    start_ = now;
}

std::optional<double> TimeLeft::at(double now) const {
    double seconds = 0, weights = 0, left = 0;
    for (const Go& go : goes_)
        if (go.taken) {
            seconds += *go.taken;
            weights += go.weight;
        }
    if (weights == 0) return {};
    for (int i = std::max(current_, 0); i < goes(); ++i) {
        const Go& go = goes_[static_cast<std::size_t>(i)];
        const auto known = go.earlier >= 0 ? goes_[static_cast<std::size_t>(go.earlier)].taken : std::nullopt;
        const double whole = known.value_or(go.weight * seconds / weights);
        left += i == current_ ? std::max(0.0, whole - (now - start_)) : whole;
    }
    return left;
}

} // namespace toile::ui
