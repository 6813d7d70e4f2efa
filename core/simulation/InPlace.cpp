// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/InPlace.h"

#include <algorithm>

namespace toile::simulation {
namespace {

constexpr double withinReach = 0.0005; // [m]

} // namespace

double InPlace::note(std::span<const Vec3> positions, double duration) {
    const auto isNear = [](const Vec3& a, const Vec3& b) { return squaredLength(a - b) <= withinReach * withinReach; };
    if (std::ranges::equal(places_, positions, isNear)) return time_ += duration;
    places_.assign(positions.begin(), positions.end());
    return time_ = 0;
}

void InPlace::forget() {
    places_.clear();
    time_ = 0;
}

} // namespace toile::simulation
