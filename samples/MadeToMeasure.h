// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "samples/Blouse.h"

namespace toile::samples {

/// With sleeves as long as the arm, which may be bent.
[[nodiscard]] BlouseSettings longSleeved();

/// The blouse for a body that is not the mannequin: measured with the tape, drafted, its sleeves and cuffs rolled round
/// arms that may be bent.
[[nodiscard]] Result<document::Document> blouseMadeToMeasure(const body::Body& body,
                                                             const BlouseSettings& settings = longSleeved());

} // namespace toile::samples
