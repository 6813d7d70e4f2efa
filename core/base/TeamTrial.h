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
    [[nodiscard]] bool shares() const { return isTrying_ ? (step_ + 1) / 2 % 2 == 0 : pays_; }

    /// That step took so long [s].
    void took(double seconds) {
        if (isTrying_) {
            double& ratio = ratios_[step_ / 2];
            const double factor = shares() ? seconds : 1 / seconds;
            ratio = step_ % 2 == 0 ? factor : ratio * factor;
            if (step_ % 2 == 1) judge(step_ / 2 + 1);
        }
        if (++step_ < period) return;
        step_ = 0;
        isTrying_ = true;
    }

private:
    void judge(int pairs) {
        if (pairs == few && *std::max_element(ratios_.begin(), ratios_.begin() + few) < clearlyWorth) pays_ = true;
        else if (pairs == most) {
            std::ranges::nth_element(ratios_, ratios_.begin() + most / 2);
            pays_ = ratios_[most / 2] < worth;
        } else return;
        isTrying_ = false;
    }

    static constexpr int few = 2, most = 5; // pairs of steps that are tried
    static constexpr int period = 128;      // steps
    /// Threads that look out for work cost processor time also where they bring none [–].
    static constexpr double worth = 0.95;
    /// In few pairs. A trial costs what its steps alone are slower: where sharing is worth much, that is much [–].
    static constexpr double clearlyWorth = 0.8;

    int step_ = 0; ///< of the period
    bool isTrying_ = true, pays_ = true;
    std::array<double, most> ratios_{}; ///< of a pair's times, shared to alone [–]
};

} // namespace toile
