// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/Repetitions.h"

#include <algorithm>
#include <fmt/format.h>

namespace toile::study {

bool isNoisy(double least, double median) {
    return median > noisyRatio * least && least > shortestTime;
}

RunTime runTimeOf(std::vector<double> seconds) {
    if (seconds.empty()) return {};
    std::ranges::sort(seconds);
    const std::size_t middle = seconds.size() / 2;
    const double least = seconds.front(),
                 median = seconds.size() % 2 == 1 ? seconds[middle] : (seconds[middle - 1] + seconds[middle]) / 2;
    return {least, median, isNoisy(least, median)};
}

std::string tooNoisy(std::size_t noisy, std::size_t runs) {
    return fmt::format("**No conclusion about cost**: {} of {} runs took over {:g} times their least time in the "
                       "median. Run it again on a machine that does nothing else.",
                       noisy, runs, noisyRatio);
}

} // namespace toile::study
