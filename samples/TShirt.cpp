// SPDX-License-Identifier: GPL-3.0-or-later
#include "samples/TShirt.h"

#include "core/material/FabricPresets.h"
#include "samples/Measuring.h"
#include "samples/Placing.h"
#include "samples/UpperGarment.h"
#include "samples/Waistband.h"

#include <algorithm>
#include <numbers>

namespace toile::samples {
namespace {

using namespace pattern;

struct TShirtTorso {
    Piece front, back;
};

Result<TShirtTorso> draftTorso(const body::Measurements& m, const body::Body& body, const Fabric& fabric,
                               const TShirtSettings& s) {
    const auto drafted = draftUpperBlock(m, figuresOf(m, body.landmarks), s.block);
    if (!drafted) return tl::unexpected(drafted.error());
    const UpperBlock& block = *drafted;
    TShirtTorso torso{pieceNamed("front", "Front", fabric, s.spacing), pieceNamed("back", "Back", fabric, s.spacing)};
    torso.front.outline = contourOf("front", wholeFromHalf(block.front, "neck-centre", "-left", "-right"));
    torso.back.outline = contourOf("back", wholeFromHalf(block.back, "neck-centre", "-right", "-left"));
    const NotchDistances at;
    torso.front.notches = {armholeNotch(torso.front, "armhole-left", at.front, true, false),
                           armholeNotch(torso.front, "armhole-right", at.front, false, false)};
    torso.back.notches = {armholeNotch(torso.back, "armhole-right", at.back, true, true),
                          armholeNotch(torso.back, "armhole-left", at.back, false, true)};
    const double height = body.landmarks.neckLeft.y + 0.03; // drawn together above the shoulders, they sink on them
    torso.front.placement = placedPanel(torso.front, body, {.behind = false, .height = height, .lean = 0.22});
    torso.back.placement = placedPanel(torso.back, body, {.behind = true, .height = height, .lean = 0.12});
    return torso;
}

double necklineLength(const TShirtTorso& torso) {
    return 2 * (edgeLength(torso.front, edgeId("front", "neckline-left")) +
                edgeLength(torso.back, edgeId("back", "neckline-left")));
}

/// x = 0 at the centre front, the wearer's left on +x, closed behind; a ring round the neck to begin with.
Piece draftNeckband(const Fabric& fabric, const body::Body& body, double length, const TShirtSettings& s) {
    Piece band = pieceNamed("neckband", "Neckband", fabric, s.spacing / 2);
    band.outline = contourOf("neckband", rectangle({-length / 2, 0}, {length / 2, s.bandWidth}));
    const double bottom = body.landmarks.neckLeft.y + 0.04;
    const Ring ring = ringRound(body, bottom, bottom + s.bandWidth, 0.008);
    const double radius = std::max(ring.radius, length / (2 * std::numbers::pi * 0.97));
    band.placement =
        Placement{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, bottom, ring.centre.z + radius}}, Curl{{0, 1}, radius}};
    return band;
}

/// From the centre back over the right shoulder, the front and the left shoulder to the centre back again.
std::vector<Side> wholeNeckline(const TShirtTorso& torso) {
    return {against(torso.back, "neckline-right"), against(torso.front, "neckline-right"),
            against(torso.front, "neckline-left"), against(torso.back, "neckline-left")};
}

} // namespace

Result<document::Document> tShirt(const body::Measurements& m, const body::Body& body, const TShirtSettings& s) {
    const Fabric jersey = material::jersey(), rib = material::rib();
    const auto drafted = draftTorso(m, body, jersey, s);
    if (!drafted) return tl::unexpected(drafted.error());
    const TShirtTorso& torso = *drafted;
    const NotchDistances at;
    const Armholes armholes{edgeLength(torso.front, edgeId("front", "armhole-left")),
                            edgeLength(torso.back, edgeId("back", "armhole-left")), at.front, at.back};
    const SleeveSettings settings{.width = m.biceps + s.bicepsEase,
                                  .bottom = s.sleeveBottom,
                                  .underarmLength = s.sleeveLength,
                                  .frontEase = s.frontCapEase,
                                  .backEase = s.backCapEase};
    auto arm = draftSleevePiece(jersey, s.spacing, armholes, settings);
    if (!arm) return tl::unexpected(arm.error());
    SleevePiece& sleeve = *arm;
    placeSleeve(sleeve, body);
    const Piece right = mirrorPiece("sleeve-right", "Sleeve right", sleeve.piece);
    const double neckline = necklineLength(torso), bandLength = s.bandRatio * neckline;
    const Piece band = draftNeckband(rib, body, bandLength, s);

    document::Document document;
    document.pattern.fabrics = {jersey, rib};
    document.pattern.pieces = {torso.front, torso.back, sleeve.piece, right, band};
    const HalfEdges frontLeft = positiveHalf(torso.front, "-left"), frontRight = negativeHalf(torso.front, "-right");
    const HalfEdges backLeft = negativeHalf(torso.back, "-left"), backRight = positiveHalf(torso.back, "-right");
    std::vector<Seam>& seams = document.pattern.seams;
    for (const auto& half : {sewSide("left", frontLeft, backLeft), sewSide("right", frontRight, backRight),
                             sewSleeve("left", sleeve.piece, frontLeft, backLeft, settings),
                             sewSleeve("right", right, frontRight, backRight, settings)})
        seams.insert(seams.end(), half.begin(), half.end());
    seams.push_back(seam("neckband", {along(band, "bottom")}, wholeNeckline(torso), {{bandLength - neckline, {}}}));
    seams.push_back(seam("neckband seam", {along(band, "right")}, {against(band, "left")}));
    document.avatarFile = "bodies/mannequin.glb";
    return document;
}

} // namespace toile::samples
