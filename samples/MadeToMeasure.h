// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "samples/Blouse.h"

namespace toile::samples {

/// Eases for arms that may be bent: a sleeve that is rolled round a bend needs room at the biceps to be drawn up, and a
/// wide cuff to pass the hand. [m]
[[nodiscard]] BlouseSettings easeForBentArms();

/// The blouse for a body that is not the mannequin: measured with the tape, drafted, its sleeves and cuffs rolled round
/// arms that may be bent.
[[nodiscard]] Result<document::Document> blouseMadeToMeasure(const body::Body& body,
                                                             const BlouseSettings& settings = easeForBentArms());

} // namespace toile::samples
