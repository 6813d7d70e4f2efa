// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/Quantities.h"

#include <optional>

namespace toile::study {

/// Statistics of cloth on a thing without limbs, or on nothing: where its folds fall is chance, these are not.
struct Hanging {
    double lowest = 0;             ///< height of the lowest point [m]
    double meanHeight = 0;         ///< by area; with the weight it is the potential energy [m]
    double shadow = 0;             ///< area that it covers, seen from above, to a grid of 2 mm [m²]
    std::optional<int> folds;      ///< of its lowest border; absent = it has none
    std::optional<double> contact; ///< area that lies on the body; absent = there is no body [m²]
};

[[nodiscard]] Hanging hangingOf(const WornDrape& worn);

/// Area of the cloth whose corners lie within half a millimetre of the distance that contact keeps; there must be a
/// body's surface [m²].
[[nodiscard]] double contactAreaOf(const WornDrape& worn);

} // namespace toile::study
