// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/Polygon.h"

#include <optional>
#include <vector>

namespace toile::pattern {

/// A straight piece of a border; `loop` and `edge` say whose, `order` counts along the loop.
struct BorderSegment {
    Vec2 a, b;
    int loop = 0;
    std::size_t edge = 0, order = 0;
};

struct Crossing {
    BorderSegment first, second;
    Vec2 point;
};

/// A common point of two closed segments.
[[nodiscard]] std::optional<Vec2> meeting(const BorderSegment& p, const BorderSegment& q);

/// A point where two segments that do not follow each other along a loop cross or touch; the first found by a sweep
/// from left to right. `loopLengths[loop]` is the number of segments of a loop.
[[nodiscard]] std::optional<Crossing> firstCrossing(std::vector<BorderSegment> segments,
                                                    const std::vector<std::size_t>& loopLengths);
/// The same of a polygon's own border.
[[nodiscard]] std::optional<Crossing> firstCrossing(const geometry::Polygon& polygon);

} // namespace toile::pattern
