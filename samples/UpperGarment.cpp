// SPDX-License-Identifier: GPL-3.0-or-later
#include "samples/UpperGarment.h"

#include "samples/Measuring.h"
#include "samples/Placing.h"
#include "samples/Strokes.h"

#include <algorithm>
#include <numbers>

namespace toile::samples {

using namespace pattern;

HalfEdges halfOf(const Piece& piece) {
    return [piece](const std::string& edge) { return along(piece, edge); };
}

HalfEdges positiveHalf(const Piece& piece, const std::string& suffix) {
    return [piece, suffix](const std::string& edge) { return along(piece, edge + suffix); };
}

HalfEdges negativeHalf(const Piece& piece, const std::string& suffix) {
    return [piece, suffix](const std::string& edge) { return against(piece, edge + suffix); };
}

Notch armholeNotch(const Piece& piece, const std::string& edge, double fromUnderarm, bool runsUp, bool isBack) {
    const EdgeId id = edgeId(piece.id.value, edge);
    const double fraction = fromUnderarm / edgeLength(piece, id);
    return {id, runsUp ? fraction : 1 - fraction, NotchKind::slit, isBack};
}

Result<SleevePiece> draftSleevePiece(const Fabric& fabric, double spacing, const Armholes& armholes,
                                     const SleeveSettings& settings) {
    auto draft = draftSleeve(armholes, settings);
    if (!draft) return tl::unexpected(draft.error());
    SleevePiece sleeve{pieceNamed("sleeve-left", "Sleeve left", fabric, spacing), std::move(*draft)};
    sleeve.piece.outline = contourOf("sleeve-left", sleeve.draft.strokes);
    sleeve.piece.notches = {{edgeId("sleeve-left", "cap-back"), sleeve.draft.backNotch, NotchKind::slit, true},
                            {edgeId("sleeve-left", "cap-front"), sleeve.draft.frontNotch, NotchKind::slit, false}};
    return sleeve;
}

double placeSleeve(SleevePiece& sleeve, const body::Body& body) {
    const LimbLine line = armLine(body, true);
    const double cap = sleeve.draft.capHeight, furthest = cap + 0.1;
    const double closing =
        sleeve.draft.capWidth / (2 * std::numbers::pi * 0.94); // the seam's edges nearly meet beneath the arm
    double biceps = cap, bottom = 0;
    do { // down the arm until the cap is clear of the shoulder
        biceps += 0.005;
        bottom = biceps - sleeve.draft.bottomY;
        const double radius = std::max(closing, limbRadius(body, line, biceps, bottom, 0.09) + 0.008);
        sleeve.piece.placement = placedTube(line, biceps, radius);
    } while (clearanceOf(sleeve.piece, *sleeve.piece.placement, body) < 0.008 && biceps < furthest);
    return bottom;
}

std::vector<Seam> sewSide(const std::string& side, const HalfEdges& front, const HalfEdges& back) {
    const auto sideOf = [](const HalfEdges& half) {
        return std::vector{half("side-hip"), half("side-waist"), half("side-top")};
    };
    return {seam("shoulder " + side, {front("shoulder")}, {back("shoulder")}),
            seam("side " + side, sideOf(front), sideOf(back))};
}

std::vector<Seam> sewSleeve(const std::string& side, const Piece& sleeve, const HalfEdges& front, const HalfEdges& back,
                            const SleeveSettings& s) {
    return {
        seam("sleeve front " + side, {against(sleeve, "cap-front")}, {front("armhole")}, {{0, {}}, {s.frontEase, {}}}),
        seam("sleeve back " + side, {along(sleeve, "cap-back")}, {back("armhole")}, {{0, {}}, {s.backEase, {}}}),
        seam("sleeve seam " + side, {along(sleeve, "seam-back")}, {against(sleeve, "seam-front")}),
    };
}

} // namespace toile::samples
