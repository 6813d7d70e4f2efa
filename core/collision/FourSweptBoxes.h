// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/collision/SweptBox.h"

#include <limits>

namespace toile::collision {

/// Four boxes side by side, to be compared with another in one go. What has not been set is nowhere.
struct alignas(64) FourSweptBoxes {
    using Lanes = SweptBox::Four; ///< of one coordinate, a box each
    static constexpr int width = 4;

    Lanes low[3]{}, high[3]{}, moveLow[3]{}, moveHigh[3]{}; ///< by axis

    FourSweptBoxes() {
        constexpr float nowhere = std::numeric_limits<float>::infinity();
        for (Lanes& axis : low) axis += nowhere;
        for (Lanes& axis : high) axis -= nowhere;
    }

    void set(int lane, const SweptBox& box) {
        for (int axis = 0; axis < 3; ++axis) {
            low[axis][lane] = box.low[axis];
            high[axis][lane] = box.high[axis];
            moveLow[axis][lane] = box.moveLow[axis];
            moveHigh[axis][lane] = box.moveHigh[axis];
        }
    }
};

using BoxFlags [[gnu::may_alias]] = int __attribute__((vector_size(16))); ///< −1 = yes, 0 = no

/// Bit 0 for the first.
[[nodiscard]] inline unsigned bitsOf(BoxFlags flags) {
    using Halves [[gnu::may_alias]] = long long __attribute__((vector_size(16)));
    const auto halves = reinterpret_cast<Halves>(flags & BoxFlags{1, 2, 4, 8});
    const auto both = static_cast<unsigned long long>(halves[0] | halves[1]);
    return static_cast<unsigned>(both | both >> 32) & 15U;
}

/// Which of the four can meet what is in the box, as meet() says.
[[nodiscard]] inline BoxFlags meeting(const FourSweptBoxes& four, const SweptBox& box) {
    BoxFlags apart{};
    for (int axis = 0; axis < 3; ++axis) {
        const auto &low = four.low[axis], &high = four.high[axis];
        const auto above = (low > box.high[axis]) & (low + (four.moveLow[axis] - box.moveHigh[axis]) > box.high[axis]);
        const auto below = (box.low[axis] > high) & (box.low[axis] > high + (four.moveHigh[axis] - box.moveLow[axis]));
        apart |= above | below;
    }
    return ~apart;
}

} // namespace toile::collision
