// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>

namespace toile {

/// Whether it pays to share out steps that are much alike: now and then some are done with a team and their neighbours
/// without, and the way that is mostly faster does the ones that follow. Only neighbours are compared, now one way
/// first and now the other, so that what grows or lessens with time tells nothing. It goes by the clock, so what a step
/// does must not depend on who does it.
class TeamTrial {
public:
    /// Whether the next step is to be shared out.
    [[nodiscard]] bool shares() const { return step_ < turns ? (step_ + 1) / 2 % 2 == 0 : pays_; }

    /// That step took so long [s].
    void took(double seconds) {
        if (step_ < turns) {
            double& ratio = ratios_[step_ / 2];
            const double factor = shares() ? seconds : 1 / seconds;
            ratio = step_ % 2 == 0 ? factor : ratio * factor;
        }
        ++step_;
        if (step_ == turns) {
            std::ranges::nth_element(ratios_, ratios_.begin() + pairs / 2);
            pays_ = ratios_[pairs / 2] < worth;
        }
        if (step_ == period) step_ = 0;
    }

private:
    static constexpr int pairs = 5, turns = 2 * pairs, period = 64; // pairs of steps, steps
    /// Threads that look out for work cost processor time also where they bring none [–].
    static constexpr double worth = 0.95;

    int step_ = 0; ///< of the period
    bool pays_ = true;
    std::array<double, pairs> ratios_{}; ///< of a pair's times, shared to alone [–]
};

} // namespace toile
