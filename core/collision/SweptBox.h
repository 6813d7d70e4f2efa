// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/TriangleMesh.h"

#include <algorithm>
#include <cmath>

namespace toile::collision {

/// Where something is at first, and the ways that parts of it go: one line of cache, in `float` and a little wider than
/// what it was made of, so that no two miss each other by rounding.
struct alignas(64) SweptBox {
    using Four [[gnu::may_alias]] = float __attribute__((vector_size(16))); ///< x, y, z and nothing

    Four low{}, high{}, moveLow{}, moveHigh{};

    SweptBox() = default;
    /// at widened by margin on all sides [m]
    SweptBox(const geometry::Box3& at, double margin, const geometry::Vec3& move = {}) {
        constexpr double rounding = 4e-7; // of six roundings to 24 bits, here and in meet()
        for (int axis = 0; axis < 3; ++axis) {
            const double far = std::max(std::abs(at.low[axis]), std::abs(at.high[axis])) + std::abs(move[axis]);
            const double wide = margin + rounding * far;
            low[axis] = static_cast<float>(at.low[axis] - wide);
            high[axis] = static_cast<float>(at.high[axis] + wide);
            moveLow[axis] = moveHigh[axis] = static_cast<float>(move[axis]);
        }
    }
};

[[nodiscard]] inline SweptBox around(const SweptBox& a, const SweptBox& b) {
    const auto lower = [](SweptBox::Four p, SweptBox::Four q) { return p < q ? p : q; };
    const auto higher = [](SweptBox::Four p, SweptBox::Four q) { return p < q ? q : p; };
    SweptBox box;
    box.low = lower(a.low, b.low);
    box.high = higher(a.high, b.high);
    box.moveLow = lower(a.moveLow, b.moveLow);
    box.moveHigh = higher(a.moveHigh, b.moveHigh);
    return box;
}

/// Whether what is in them can meet while each goes its way, in step. Only how they go against each other counts: cloth
/// that flies as a whole is as far apart as at rest.
[[nodiscard]] inline bool meet(const SweptBox& a, const SweptBox& b) {
    using Halves [[gnu::may_alias]] = long long __attribute__((vector_size(16)));
    // Apart along an axis is what is so at the start and at the end of a way.
    const auto aAbove = (a.low > b.high) & (a.low + (a.moveLow - b.moveHigh) > b.high);
    const auto bAbove = (b.low > a.high) & (b.low > a.high + (a.moveHigh - b.moveLow));
    const auto apart = reinterpret_cast<Halves>(aAbove | bAbove); // the fourth of the boxes, nothing, never is
    return (apart[0] | apart[1]) == 0;
}

} // namespace toile::collision
