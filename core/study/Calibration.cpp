// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/Calibration.h"

#include "core/geometry/Vec.h"

#include <algorithm>
#include <ctime>
#include <vector>

namespace toile::study {

double threadSeconds() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double calibrationSeconds() {
    constexpr std::size_t springs = 1000000;
    std::vector<Vec3> position(springs + 1), force(springs + 1);
    for (std::size_t i = 0; i <= springs; ++i) position[i] = {0.011 * static_cast<double>(i), 0.1, 0.2};
    double best = 1e300;
    [[maybe_unused]] volatile double last = 0;
    for (std::size_t run = 0; run < 7; ++run) {
        const double start = threadSeconds();
        for (std::size_t i = 0; i < springs; ++i) {
            const Vec3 along = position[i + 1] - position[i];
            const double longer = length(along) - 0.01;
            const Vec3 pull = along * (30.0 * longer / length(along));
            force[i] += pull;
            force[i + 1] -= pull;
        }
        last = force[run].x; // the loop has a use
        best = std::min(best, threadSeconds() - start);
    }
    return best;
}

} // namespace toile::study
