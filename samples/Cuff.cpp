// SPDX-License-Identifier: GPL-3.0-or-later
#include "samples/Cuff.h"

#include "samples/Placing.h"

#include <algorithm>
#include <numbers>

namespace toile::samples {

using namespace pattern;

Result<SleevePiece> draftCuffedSleeve(const body::Measurements& m, const Fabric& fabric, double spacing,
                                      const Armholes& armholes, SleeveSettings settings, const CuffedSleeve& wanted) {
    auto sleeve = draftSleevePiece(fabric, spacing, armholes, settings);
    for (int pass = 0; sleeve && pass < 3; ++pass) { // the taper moves the cap's height by less than a millimetre
        settings.underarmLength +=
            m.arm - wanted.aboveWrist - wanted.cuffWidth - (sleeve->draft.capHeight - sleeve->draft.bottomY);
        sleeve = draftSleevePiece(fabric, spacing, armholes, settings);
    }
    return sleeve;
}

Piece draftCuff(const Fabric& fabric, double spacing, const body::Body& body, double sleeveBottom,
                const CuffedSleeve& sleeve) {
    Piece cuff = pieceNamed("cuff-left", "Cuff left", fabric, spacing);
    const double half = sleeve.cuffLength / 2;
    cuff.outline = contourOf("cuff-left", rectangle({-half, -sleeve.cuffWidth}, {half, 0}));
    cuff.grain = std::numbers::pi / 2; // warp runs round the wrist
    const LimbLine line = armLine(body, true);
    const double top = sleeveBottom + 0.012;
    cuff.placement = placedTube(line, top,
                                std::max(sleeve.cuffLength / (2 * std::numbers::pi * 0.94),
                                         limbRadius(body, line, top, top + sleeve.cuffWidth, 0.09) + 0.008));
    return cuff;
}

std::vector<Seam> sewCuff(const std::string& side, const Piece& sleeve, const Piece& cuff) {
    return {seam("cuff " + side, {along(sleeve, "bottom")}, {against(cuff, "top")}),
            seam("cuff seam " + side, {along(cuff, "right")}, {against(cuff, "left")})};
}

} // namespace toile::samples
