// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <limits>

namespace toile {

/// Whether it pays to share out steps that are alike: now and then two are done with a team and two without, and the
/// faster way does the ones that follow. It goes by the clock, so what a step does must not depend on who does it.
class TeamTrial {
public:
    /// Whether the next step is to be shared out.
    [[nodiscard]] bool shares() const { return step_ < turns ? step_ < turns / 2 : pays_; }

    /// That step took so long [s].
    void took(double seconds) {
        if (step_ < turns) {
            double& least = shares() ? shared_ : alone_;
            least = std::min(least, seconds);
        }
        ++step_;
        if (step_ == turns) pays_ = shared_ < worth * alone_;
        if (step_ < period) return;
        step_ = 0;
        shared_ = alone_ = std::numeric_limits<double>::infinity();
    }

private:
    static constexpr int turns = 4, period = 32; // steps
    /// Threads that look out for work cost processor time also where they bring none [–].
    static constexpr double worth = 0.95;

    int step_ = 0; ///< of the period
    bool pays_ = true;
    double shared_ = std::numeric_limits<double>::infinity(), alone_ = shared_; ///< the least of each [s]
};

} // namespace toile
