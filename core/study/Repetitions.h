// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Result.h"

#include <string>
#include <vector>

namespace toile::study {

/// Median over least time beyond which the machine was too busy to conclude anything from a time [–].
constexpr double noisyRatio = 1.3;
/// A time below this is no measure of noise [s].
constexpr double shortestTime = 0.005;

/// Whether the machine was too busy while something ran so long [s].
[[nodiscard]] bool isNoisy(double least, double median);

/// CPU time of something that was run several times.
struct RunTime {
    double least = 0, median = 0; ///< [s]; the median of an even number is the mean of the two in the middle
    bool noisy = false;           ///< the median is over 1.3 of the least: no time is concluded from it
};
[[nodiscard]] RunTime runTimeOf(std::vector<double> seconds); ///< zero of none

/// Why nothing is concluded about cost from runs of which so many were noisy.
[[nodiscard]] std::string tooNoisy(std::size_t noisy, std::size_t runs);

/// Runs that take turns: 0, 1, 2, …, then all again, so that what slows the machine for a while slows all of them.
/// run(index, repetition) gives a Result<void>; the first error ends it.
template <class Run>
Result<void> inTurns(std::size_t runs, int repetitions, const Run& run) {
    for (int repetition = 0; repetition < repetitions; ++repetition)
        for (std::size_t i = 0; i < runs; ++i)
            if (Result<void> done = run(i, repetition); !done) return done;
    return {};
}

} // namespace toile::study
