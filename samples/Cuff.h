// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "samples/UpperGarment.h"

#include "core/body/Mannequin.h"

namespace toile::samples {

/// How long a sleeve is and what closes it. Lengths [m].
struct CuffedSleeve {
    double aboveWrist = 0.13; ///< where the cuff ends
    double cuffWidth = 0.05;
    double cuffLength = 0.25; ///< round the arm
};

/// As long, down its middle, as is wanted once the cuff is sewn on. `settings` keeps the length of its seam.
[[nodiscard]] Result<SleevePiece> draftCuffedSleeve(const body::Measurements& m, const pattern::Fabric& fabric,
                                                    double spacing, const Armholes& armholes, SleeveSettings settings,
                                                    const CuffedSleeve& sleeve);

/// A straight band that is sewn shut and lies below a sleeve which ends `sleeveBottom` down the arm [m], wide enough
/// for the hand it passes. Edges: bottom, right, top, left.
[[nodiscard]] pattern::Piece draftCuff(const pattern::Fabric& fabric, double spacing, const body::Body& body,
                                       double sleeveBottom, const CuffedSleeve& sleeve);

/// The cuff to its sleeve and to itself.
[[nodiscard]] std::vector<pattern::Seam> sewCuff(const std::string& side, const pattern::Piece& sleeve,
                                                 const pattern::Piece& cuff);

} // namespace toile::samples
