// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/Speeds.h"

#include "core/base/Contracts.h"

#include <algorithm>
#include <cmath>

namespace toile::simulation {

Speeds speedsOf(std::span<const double> mass, std::span<const Vec3> before, std::span<const Vec3> after,
                double duration) {
    expects(mass.size() == before.size() && before.size() == after.size(), "a mass and two places per particle");
    double largest = 0, moved = 0, whole = 0;
    for (std::size_t i = 0; i < mass.size(); ++i) {
        const double square = geometry::squaredLength(after[i] - before[i]);
        largest = std::max(largest, square);
        moved += mass[i] * square;
        whole += mass[i];
    }
    return {std::sqrt(largest) / duration, whole > 0 ? std::sqrt(moved / whole) / duration : 0};
}

} // namespace toile::simulation
