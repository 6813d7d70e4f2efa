// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/scenes/Case.h"

#include <algorithm>

namespace toile::study::scenes {

bool Row::hasGoal() const {
    return std::ranges::any_of(figures, [](const Figure& figure) { return figure.goal.has_value(); });
}

bool Row::reached() const {
    return failure.empty() && std::ranges::all_of(figures, &Figure::reached);
}

} // namespace toile::study::scenes
