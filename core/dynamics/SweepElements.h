// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/Vec.h"

#include <array>

namespace toile::dynamics {

/// A position as the loops of a sweep load and store it: at once.
struct alignas(32) Place : Vec3 {
    double unused = 0; ///< stays finite
    friend bool operator==(const Place&, const Place&) = default;
};

/// Four springs that share no particle.
struct alignas(32) FourSprings {
    std::array<double, 4> restLength{}, correctionA{}, correctionB{}; ///< correction = w/(w_a + w_b + compliance)
    std::array<int, 4> a{}, b{};
};

/// |Σ c·x| → 0
template <int N>
struct Linear {
    std::array<int, N> particles{};
    std::array<double, N> coefficients{}, corrections{}; ///< correction = w·c/(Σ w c² + compliance)
};

} // namespace toile::dynamics
