// SPDX-License-Identifier: GPL-3.0-or-later
#include "samples/Blouse.h"

#include "core/material/FabricPresets.h"
#include "samples/Cuff.h"
#include "samples/Measuring.h"
#include "samples/Placing.h"
#include "samples/UpperGarment.h"

#include <algorithm>

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

struct BlouseTorso {
    Piece front, back;
};

Result<BlouseTorso> draftTorso(const body::Measurements& m, const Figures& f, const Fabric& fabric,
                               const BlouseSettings& s) {
    const auto drafted = draftUpperBlock(m, f, s.block);
    if (!drafted) return tl::unexpected(drafted.error());
    const UpperBlock& block = *drafted;
    BlouseTorso torso{pieceNamed("front-left", "Front left", fabric, s.spacing),
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

CuffedSleeve cuffedSleeve(const body::Measurements& m, const BlouseSettings& s) {
    return {.aboveWrist = s.aboveWrist, .cuffWidth = s.cuffWidth, .cuffLength = m.wrist + s.cuffEase};
}

std::vector<Seam> sewHalf(const std::string& side, const Piece& front, const HalfEdges& back, const Piece& sleeve,
                          const Piece& cuff, const SleeveSettings& settings) {
    std::vector<Seam> seams{seam("dart " + side, {along(front, "dart-lower")}, {against(front, "dart-upper")})};
    for (const auto& more : {sewCuff(side, sleeve, cuff), sewSide(side, halfOf(front), back),
                             sewSleeve(side, sleeve, halfOf(front), back, settings)})
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
    BlouseTorso& torso = *drafted;
    const NotchDistances at;
    const Armholes armholes{edgeLength(torso.front, edgeId("front-left", "armhole")),
                            edgeLength(torso.back, edgeId("back", "armhole-right")), at.front, at.back};
    const CuffedSleeve cuffed = cuffedSleeve(m, s);
    auto arm = draftCuffedSleeve(m, fabric, s.spacing, armholes, sleeveDraft, cuffed);
    if (!arm) return tl::unexpected(arm.error());
    SleevePiece& sleeve = *arm;

    const double height = body.landmarks.neckLeft.y + 0.03; // drawn together above the shoulders, they sink on them
    torso.front.placement = placedPanel(torso.front, body, {.behind = false, .height = height, .lean = 0.22});
    torso.back.placement = placedPanel(torso.back, body, {.behind = true, .height = height, .lean = 0.12});
    const double sleeveBottom = placeSleeve(sleeve, body);
    const Piece cuff = draftCuff(fabric, s.spacing, body, sleeveBottom, cuffed);
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
