// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/Vec.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace toile::study {

/// What is to be written beside a point of a plot.
struct PointLabel {
    Vec2 point; ///< in a picture [px]
    std::string text;
};

/// Where labels of so many pixels a character and a line are readable.
struct LabelRoom {
    Vec2 character{7, 11}; ///< of a small font [px]
    double marker = 4;     ///< from the middle of a point to the border of its marker [px]
};

/// From each point to the middle of its label [px]: above it where there is room, else below or beside it, or farther
/// away, so that labels lie neither on each other nor on points. Absent where another of the same text lies as near,
/// which then stands for both, or where there is no room.
[[nodiscard]] std::vector<std::optional<Vec2>> placedLabels(std::span<const PointLabel> labels,
                                                            const LabelRoom& room = {});

} // namespace toile::study
