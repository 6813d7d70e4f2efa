// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/Vec.h"

#include <chrono>
#include <vector>

namespace toile::simulation {

/// The pictures of a way that was not seen, from where a garment lay to where it lies now: so slow that nothing jumps,
/// but never long.
class Glide {
public:
    /// The same vertices before and after.
    Glide(std::vector<Vec3> from, std::vector<Vec3> to);

    /// Between the two ends; none of a way too short to be seen.
    [[nodiscard]] int pictures() const { return pictures_; }
    /// i: from 1 to pictures(). The way begins and ends slowly.
    [[nodiscard]] std::vector<Vec3> picture(int i) const;

    /// How long each is shown.
    static constexpr std::chrono::milliseconds each{16};

private:
    std::vector<Vec3> from_, to_;
    int pictures_ = 0;
};

} // namespace toile::simulation
