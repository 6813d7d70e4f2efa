// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/Vec.h"

#include <span>
#include <vector>

namespace toile::simulation {

/// Watches whether cloth goes anywhere: particles that tremble may be fast and yet stay where they are.
class InPlace {
public:
    /// After a frame step: for how long no particle has been farther than half a millimetre from where it was at the
    /// beginning [s]. What swings as little is held for still.
    double note(std::span<const Vec3> positions, double duration);
    /// It begins anew.
    void forget();

private:
    std::vector<Vec3> places_;
    double time_ = 0;
};

} // namespace toile::simulation
