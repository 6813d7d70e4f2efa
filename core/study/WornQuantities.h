// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/Quantities.h"

#include <tl/expected.hpp>

namespace toile::study {

/// A number, or the sentence why there is none.
using Found = tl::expected<double, std::string>;

/// Of a garment on a body with limbs, in this order: the hem's height at the centre front, centre back, left and right,
/// its folds; ease at bust, waist and hip; the back neck's distance from the nape; height and distance of the shoulder
/// points.
[[nodiscard]] std::vector<Found> wornQuantities(const WornDrape& worn);
constexpr std::size_t wornQuantityCount = 11;

} // namespace toile::study
