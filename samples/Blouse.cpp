// SPDX-License-Identifier: GPL-3.0-or-later
#include "samples/Blouse.h"

#include "core/material/FabricPresets.h"
#include "samples/Measuring.h"
#include "samples/Placing.h"
#include "samples/UpperGarment.h"

#include <algorithm>
#include <numbers>

namespace toile::samples {
namespace {

using namespace pattern;

Region region(const Piece& piece, const std::string& name, Polygon outline, int refinement) {
    std::string id = piece.id.value + "." + name;
    std::ranges::replace(id, ' ', '-');
    return {RegionId{id}, name, std::move(outline), {}, refinement, {}};
}

/// As figure 2 of Liu 2002: both shoulders with their blades and the middle below the neck at half the spacing, the
/// small of the back, between its darts, at the main spacing.
std::vector<Region> backRegions(const Piece& back, double waist) {
    const auto at = [&](const char* vertex) { return vertexPosition(back, vertexId("back", vertex)); };
    const Vec2 neck = at("neck-side-right"), tip = at("shoulder-tip-right"), underarm = at("underarm-right");
    const double blades = tip.y + 0.62 * (underarm.y - tip.y), yoke = tip.y - 0.045;
    const auto mirror = [](Polygon polygon) {
        for (Vec2& p : polygon) p.x = -p.x;
        std::ranges::reverse(polygon);
        return polygon;
    };
    const double armhole = widthAt(back, blades) / 2 + 0.004; // the armhole is hollow: this border lies just beyond it
    const Polygon right{{neck.x, blades}, {armhole, blades}, tip, neck};
    return {region(back, "right shoulder", right, 1), region(back, "left shoulder", mirror(right), 1),
            region(back, "yoke", {{-neck.x, yoke}, {neck.x, yoke}, neck, {-neck.x, neck.y}}, 1),
            region(back, "small of the back",
                   {{-0.06, waist - 0.06}, {0.06, waist - 0.06}, {0.06, waist + 0.10}, {-0.06, waist + 0.10}}, 0)};
}

/// A diamond cut out across the waist and sewn shut; clockwise from its upper tip, as holes run.
Contour waistDart(const std::string& piece, const std::string& suffix, Vec2 waist, const WaistDart& dart) {
    const Vec2 top = waist + Vec2{0, dart.above}, bottom = waist - Vec2{0, dart.below};
    const Vec2 right = waist + Vec2{dart.intake / 2, 0}, left = waist - Vec2{dart.intake / 2, 0};
    const auto leg = [&](const std::string& corner, const std::string& name, Vec2 from, Vec2 to) {
        return line("waist-dart-" + corner + suffix, "waist-dart-" + name + suffix, from, to);
    };
    return contourOf(piece, {leg("top", "right-upper", top, right), leg("right", "right-lower", right, bottom),
                             leg("bottom", "left-lower", bottom, left), leg("left", "left-upper", left, top)});
}

Seam waistDartSeam(const std::string& name, const Piece& piece, const std::string& suffix) {
    return seam(name,
                {along(piece, "waist-dart-right-upper" + suffix), along(piece, "waist-dart-right-lower" + suffix)},
                {against(piece, "waist-dart-left-upper" + suffix), against(piece, "waist-dart-left-lower" + suffix)});
}

struct Torso {
    Piece front, back;
};

Result<Torso> draftTorso(const body::Measurements& m, const Figures& f, const Fabric& fabric, const BlouseSettings& s) {
    const auto drafted = draftUpperBlock(m, f, s.block);
    if (!drafted) return tl::unexpected(drafted.error());
    const UpperBlock& block = *drafted;
    Torso torso{pieceNamed("front-left", "Front left", fabric, s.spacing),
                pieceNamed("back", "Back", fabric, s.spacing)};
    torso.front.outline = halfContour("front-left", block.front);
    torso.back.outline = contourOf("back", wholeFromHalf(block.back, "neck-centre", "-right", "-left"));
    torso.front.holes = {waistDart("front-left", "", {s.frontWaistDart.fromCentre, -f.frontWaist}, s.frontWaistDart)};
    const double backWaist = -f.backWaist + s.block.backShortening;
    torso.back.holes = {waistDart("back", "-right", {s.backWaistDart.fromCentre, backWaist}, s.backWaistDart),
                        waistDart("back", "-left", {-s.backWaistDart.fromCentre, backWaist}, s.backWaistDart)};
    const NotchDistances at;
    torso.front.notches = {armholeNotch(torso.front, "armhole", at.front, true, false)};
    torso.back.notches = {armholeNotch(torso.back, "armhole-right", at.back, true, true),
                          armholeNotch(torso.back, "armhole-left", at.back, false, true)};
    torso.back.regions = backRegions(torso.back, backWaist);
    return torso;
}

SleeveSettings sleeveSettings(const body::Measurements& m, const BlouseSettings& s) {
    return {.width = m.biceps + s.bicepsEase,
            .bicepsBelow = s.bicepsBelow,
            .bottom = m.wrist + s.cuffEase,
            .frontEase = s.frontCapEase,
            .backEase = s.backCapEase};
}

/// As long, down its middle, as is wanted once the cuff is sewn on.
Result<SleevePiece> draftArm(const body::Measurements& m, const Torso& torso, const Fabric& fabric,
                             const BlouseSettings& s) {
    const NotchDistances at;
    const Armholes armholes{edgeLength(torso.front, edgeId("front-left", "armhole")),
                            edgeLength(torso.back, edgeId("back", "armhole-right")), at.front, at.back};
    SleeveSettings settings = sleeveSettings(m, s);
    auto sleeve = draftSleevePiece(fabric, s.spacing, armholes, settings);
    for (int pass = 0; sleeve && pass < 3; ++pass) { // the taper moves the cap's height by less than a millimetre
        settings.underarmLength +=
            m.arm - s.aboveWrist - s.cuffWidth - (sleeve->draft.capHeight - sleeve->draft.bottomY);
        sleeve = draftSleevePiece(fabric, s.spacing, armholes, settings);
    }
    return sleeve;
}

Piece draftCuff(const body::Measurements& m, const Fabric& fabric, const BlouseSettings& s) {
    Piece cuff = pieceNamed("cuff-left", "Cuff left", fabric, s.spacing);
    const double half = (m.wrist + s.cuffEase) / 2;
    cuff.outline = contourOf("cuff-left", rectangle({-half, -s.cuffWidth}, {half, 0}));
    cuff.grain = std::numbers::pi / 2; // warp runs round the wrist
    return cuff;
}

/// Below the sleeve, wide enough for the hand it passes.
Placement placedCuff(const body::Body& body, double sleeveBottom, double girth, double width) {
    const LimbLine line = armLine(body, true);
    const double top = sleeveBottom + 0.012;
    return placedTube(
        line, top,
        std::max(girth / (2 * std::numbers::pi * 0.94), limbRadius(body, line, top, top + width, 0.09) + 0.008));
}

std::vector<Seam> sewHalf(const std::string& side, const Piece& front, const HalfEdges& back, const Piece& sleeve,
                          const Piece& cuff, const SleeveSettings& settings) {
    std::vector<Seam> seams{seam("dart " + side, {along(front, "dart-lower")}, {against(front, "dart-upper")}),
                            seam("cuff " + side, {along(sleeve, "bottom")}, {against(cuff, "top")}),
                            seam("cuff seam " + side, {along(cuff, "right")}, {against(cuff, "left")})};
    for (const auto& more :
         {sewSide(side, halfOf(front), back), sewSleeve(side, sleeve, halfOf(front), back, settings)})
        seams.insert(seams.end(), more.begin(), more.end());
    return seams;
}

} // namespace

body::Measurements blouseWearer() {
    return {.bust = 0.94, .underBust = 0.81, .waist = 0.76, .hip = 1.03, .biceps = 0.29, .thigh = 0.59};
}

Result<document::Document> blouse(const body::Measurements& m, const body::Body& body, const BlouseSettings& s) {
    const Fabric fabric = material::poplin();
    const SleeveSettings sleeveDraft = sleeveSettings(m, s);
    auto drafted = draftTorso(m, figuresOf(m, body.landmarks), fabric, s);
    if (!drafted) return tl::unexpected(drafted.error());
    Torso& torso = *drafted;
    auto arm = draftArm(m, torso, fabric, s);
    if (!arm) return tl::unexpected(arm.error());
    SleevePiece& sleeve = *arm;
    Piece cuff = draftCuff(m, fabric, s);

    const double height = body.landmarks.neckLeft.y + 0.03; // drawn together above the shoulders, they sink on them
    torso.front.placement = placedPanel(torso.front, body, {.behind = false, .height = height, .lean = 0.22});
    torso.back.placement = placedPanel(torso.back, body, {.behind = true, .height = height, .lean = 0.12});
    const double sleeveBottom = placeSleeve(sleeve, body);
    cuff.placement = placedCuff(body, sleeveBottom, sleeveDraft.bottom, s.cuffWidth);
    const Piece frontRight = mirrorPiece("front-right", "Front right", torso.front);
    const Piece sleeveRight = mirrorPiece("sleeve-right", "Sleeve right", sleeve.piece);
    const Piece cuffRight = mirrorPiece("cuff-right", "Cuff right", cuff);

    document::Document document;
    Pattern& pattern = document.pattern;
    pattern.fabrics = {fabric};
    pattern.pieces = {torso.front, frontRight, torso.back, sleeve.piece, sleeveRight, cuff, cuffRight};
    pattern.seams = {seam("centre front", {along(torso.front, "centre")}, {along(frontRight, "centre")})};
    for (const auto& half :
         {sewHalf("left", torso.front, negativeHalf(torso.back, "-left"), sleeve.piece, cuff, sleeveDraft),
          sewHalf("right", frontRight, positiveHalf(torso.back, "-right"), sleeveRight, cuffRight, sleeveDraft)})
        pattern.seams.insert(pattern.seams.end(), half.begin(), half.end());
    pattern.seams.push_back(waistDartSeam("front waist dart left", torso.front, ""));
    pattern.seams.push_back(waistDartSeam("front waist dart right", frontRight, ""));
    for (const std::string side : {"left", "right"})
        pattern.seams.push_back(waistDartSeam("back waist dart " + side, torso.back, "-" + side));
    document.scene.skinOffset = 0.0035; // elbows of real arms are sharper than the mannequin's
    document.avatarFile = "bodies/mannequin-42.glb";
    return document;
}

} // namespace toile::samples
