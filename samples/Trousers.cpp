// SPDX-License-Identifier: GPL-3.0-or-later
#include "samples/Trousers.h"

#include "core/material/FabricPresets.h"
#include "samples/Measuring.h"
#include "samples/Placing.h"
#include "samples/Strokes.h"
#include "samples/Waistband.h"

#include <cmath>

namespace toile::samples {
namespace {

using namespace pattern;

/// One leg's front or back, its crease at x = 0, the side seam on +x, y = 0 at the waist.
struct LegPanel {
    double hip = 0;           ///< centre seam to side seam at the hip
    double extension = 0;     ///< from the centre seam inward to the crotch point
    double knee = 0, hem = 0; ///< half widths
    double legIn = 0;         ///< middle of knee and hem from the crease to the inside, where the body's leg is
    double dart = 0, dartLength = 0;
    double centreIn = 0, centreRise = 0; ///< of the centre seam's top
    double sideIn = 0, sideRise = 0;     ///< of the side seam's top
    double crotchDrop = 0;
    double sideCurve = 0; ///< the side's top is by so much nearer to the upright than the line from hip to waist [rad]
};

struct Heights {
    double top = 0, hip = 0, crotch = 0, knee = 0, hem = 0;
};

std::vector<Stroke> draft(const LegPanel& p, const Heights& y) {
    const double half = (p.hip + p.extension) / 2, shin = 0.4 * (y.knee - y.hem), thigh = 0.35 * (y.hip - y.knee);
    const Vec2 hemIn{-p.legIn - p.hem, y.hem}, hemOut{-p.legIn + p.hem, y.hem};
    const Vec2 kneeIn{-p.legIn - p.knee, y.knee}, kneeOut{-p.legIn + p.knee, y.knee};
    const Vec2 hip{half, y.hip}, sideTop{half - p.sideIn, y.top + p.sideRise};
    const Vec2 centreHip{half - p.hip, y.hip}, centreTop = centreHip + Vec2{p.centreIn, y.top + p.centreRise - y.hip};
    const Vec2 tip{-half, y.crotch - p.crotchDrop};
    const Vec2 middle = lerp(sideTop, centreTop, 0.5), dartTip = middle - Vec2{0, p.dartLength};
    const double angle = std::asin(p.dart / 2 / p.dartLength);
    const Vec2 legSide = geometry::rotated({0, 1}, -angle), legCentre = geometry::rotated({0, 1}, angle);
    const Vec2 mouthSide = dartTip + p.dartLength * legSide, mouthCentre = dartTip + p.dartLength * legCentre;
    const Vec2 down = normalized(centreHip - centreTop),
               up = geometry::rotated(normalized(sideTop - hip), -p.sideCurve);
    const double quarter = 0.3 * distance(sideTop, mouthSide), rise = 0.35 * (sideTop.y - hip.y);
    const double crotchHeight = centreHip.y - tip.y, inner = 0.45 * (tip.y - y.knee);
    return {
        line("hem-inside", "hem", hemIn, hemOut),
        cubic("hem-side", "side-low", hemOut, {0, shin}, {0, -shin}, kneeOut),
        cubic("knee-side", "side-thigh", kneeOut, {0, thigh}, {0, -thigh}, hip),
        cubic("hip-side", "side-hip", hip, {0, rise}, -rise * up, sideTop),
        cubic("waist-side", "waist-side", sideTop, quarter * geometry::leftOf(up), -quarter * geometry::leftOf(legSide),
              mouthSide),
        line("dart-side", "dart-side", mouthSide, dartTip),
        line("dart-tip", "dart-centre", dartTip, mouthCentre),
        cubic("dart-centre", "waist-centre", mouthCentre, quarter * geometry::leftOf(legCentre),
              quarter * geometry::leftOf(down), centreTop),
        line("waist-centre", "centre", centreTop, centreHip),
        cubic("hip-centre", "crotch", centreHip, 0.6 * crotchHeight * down, {0.75 * p.extension, 0}, tip),
        cubic("crotch-point", "inseam-thigh", tip, {0, -inner}, {0, inner}, kneeIn),
        cubic("knee-inside", "inseam-low", kneeIn, {0, -shin}, {0, shin}, hemIn),
    };
}

double lengthOf(const std::vector<Stroke>& strokes, std::initializer_list<const char*> edges) {
    double sum = 0;
    for (const Stroke& stroke : strokes)
        for (const char* edge : edges)
            if (stroke.edge == edge) sum += geometry::length(stroke.curve);
    return sum;
}

double width(const std::vector<Stroke>& strokes, double y) {
    Piece piece;
    piece.outline = contourOf("panel", strokes);
    return widthAt(piece, y);
}

struct Legs {
    std::vector<Stroke> front, back;
    double frontHalf = 0, backHalf = 0; ///< crease to crotch point
};

Heights heightsOf(const body::Measurements& m, const body::Landmarks& at, const TrousersSettings& s) {
    const TrouserLevels levels = trouserLevels(m, at, s);
    return {-s.waistbandWidth / 2, levels.hip, at.crotch.y - at.waist.y - s.crotchEase, levels.knee,
            s.ankleClearance - at.waist.y};
}

/// The free measures settle one after the other: the crotch's width by the thigh, the back's crotch point by the
/// inseams, the sides' slant by the waist, the back's side height by the side seams. Each hardly moves the others.
Result<Legs> draftLegs(const body::Measurements& m, const body::Landmarks& at, const TrousersSettings& s) {
    const Heights y = heightsOf(m, at, s);
    const double quarter = (m.hip + s.hipEase) / 4, thighY = trouserLevels(m, at, s).thigh;
    LegPanel front{.hip = quarter - 0.010,
                   .knee = s.kneeGirth / 4 - 0.005,
                   .hem = s.hemGirth / 4 - 0.005,
                   .legIn = 0.000,
                   .dart = s.frontDart,
                   .dartLength = 0.09,
                   .centreIn = 0.008,
                   .centreRise = -0.006,
                   .sideCurve = s.sideCurve};
    LegPanel back{.hip = quarter + 0.010,
                  .knee = s.kneeGirth / 4 + 0.005,
                  .hem = s.hemGirth / 4 + 0.005,
                  .legIn = 0.012,
                  .dart = s.backDart,
                  .dartLength = 0.11,
                  .centreIn = 0.030,
                  .centreRise = 0.026,
                  .sideCurve = s.sideCurve};
    Solver solver;
    const auto solve = [&](const char* measure, double& free, double low, double high, const auto& error) {
        free = solver.rootOf(
            measure,
            [&](double value) {
                free = value;
                return error();
            },
            low, high);
    };
    double extension = 0;
    for (int round = 0; round < 5; ++round) {
        solve("width of the crotch", extension, 0.05, 0.30, [&] {
            front.extension = 0.35 * extension;
            back.extension = 0.65 * extension;
            return width(draft(front, y), thighY) + width(draft(back, y), thighY) - (m.thigh + s.thighEase);
        });
        front.extension = 0.35 * extension;
        back.extension = 0.65 * extension;
        solve("depth of the back's crotch", back.crotchDrop, -0.02, 0.06, [&] {
            return lengthOf(draft(front, y), {"inseam-thigh", "inseam-low"}) -
                   lengthOf(draft(back, y), {"inseam-thigh", "inseam-low"});
        });
        double sideIn = 0;
        solve("slant of the sides", sideIn, -0.02, 0.07, [&] {
            front.sideIn = back.sideIn = sideIn;
            return 2 * (lengthOf(draft(front, y), {"waist-side", "waist-centre"}) +
                        lengthOf(draft(back, y), {"waist-side", "waist-centre"})) -
                   (m.waist + s.waistEase);
        });
        front.sideIn = back.sideIn = sideIn;
        solve("height of the back's side", back.sideRise, -0.03, 0.03, [&] {
            const auto side = {"side-low", "side-thigh", "side-hip"};
            return lengthOf(draft(back, y), side) - lengthOf(draft(front, y), side);
        });
    }
    if (solver.error()) return tl::unexpected(*solver.error());
    return Legs{draft(front, y), draft(back, y), (front.hip + front.extension) / 2, (back.hip + back.extension) / 2};
}

/// Before or behind its leg, the crotch point just beside the middle, so that the inseam closes between the legs.
Placement placedLeg(const Piece& piece, const body::Body& body, bool behind, double half) {
    constexpr double radius = 0.35, besideMiddle = 0.006;
    const double crease = radius * std::sin(half / radius) + besideMiddle;
    return placedPanel(
        piece, body,
        {.behind = behind, .height = body.landmarks.waist.y, .radius = radius, .aside = behind ? -crease : crease});
}

std::vector<Seam> sewLeg(const std::string& side, const Piece& front, const Piece& back) {
    const auto whole = [](const Piece& piece, std::initializer_list<const char*> edges) {
        std::vector<Side> sides;
        for (const char* edge : edges) sides.push_back(along(piece, edge));
        return sides;
    };
    return {
        seam("front dart " + side, {along(front, "dart-side")}, {against(front, "dart-centre")}),
        seam("back dart " + side, {along(back, "dart-side")}, {against(back, "dart-centre")}),
        seam("side " + side, whole(front, {"side-low", "side-thigh", "side-hip"}),
             whole(back, {"side-low", "side-thigh", "side-hip"})),
        seam("inseam " + side, whole(front, {"inseam-thigh", "inseam-low"}),
             whole(back, {"inseam-thigh", "inseam-low"})),
    };
}

Seam crotchSeam(const std::string& name, const Piece& left, const Piece& right) {
    return seam(name, {along(left, "centre"), along(left, "crotch")}, {along(right, "centre"), along(right, "crotch")});
}

/// From one centre over the side to the other.
std::vector<Side> waistEdge(const Piece& first, const Piece& second) {
    return {against(first, "waist-centre"), against(first, "waist-side"), along(second, "waist-side"),
            along(second, "waist-centre")};
}

} // namespace

TrouserLevels trouserLevels(const body::Measurements& m, const body::Landmarks& at, const TrousersSettings& s) {
    return {at.hip.y - at.waist.y, at.crotch.y - s.crotchEase - 0.03 - at.waist.y, 0.595 * m.insideLeg - at.waist.y};
}

Result<document::Document> trousers(const body::Measurements& m, const body::Body& body, const TrousersSettings& s) {
    const Fabric fabric = material::twill(), stiff = interlined(fabric);
    const auto drafted = draftLegs(m, body.landmarks, s);
    if (!drafted) return tl::unexpected(drafted.error());
    const Legs& legs = *drafted;
    Piece frontLeft = pieceNamed("front-left", "Front left", fabric, s.spacing);
    frontLeft.outline = contourOf("front-left", legs.front);
    frontLeft.placement = placedLeg(frontLeft, body, false, legs.frontHalf);
    Piece backRight = pieceNamed("back-right", "Back right", fabric, s.spacing); // seen from behind its side lies on +x
    backRight.outline = contourOf("back-right", legs.back);
    backRight.placement = placedLeg(backRight, body, true, legs.backHalf);
    const Piece frontRight = mirrorPiece("front-right", "Front right", frontLeft);
    const Piece backLeft = mirrorPiece("back-left", "Back left", backRight);
    const Piece band =
        draftWaistband(stiff, body, {m.waist + s.waistEase, s.waistbandWidth, s.spacing}, s.waistbandWidth / 2);

    document::Document document;
    document.pattern.fabrics = {fabric, stiff};
    document.pattern.pieces = {frontLeft, frontRight, backRight, backLeft, band};
    std::vector<Seam>& seams = document.pattern.seams;
    seams = {crotchSeam("centre front", frontLeft, frontRight), crotchSeam("centre back", backLeft, backRight),
             seam("waist left", waistEdge(frontLeft, backLeft), {along(band, "bottom-left")}),
             seam("waist right", waistEdge(backRight, frontRight), {along(band, "bottom-right")}), waistbandSeam(band)};
    for (const auto& leg : {sewLeg("left", frontLeft, backLeft), sewLeg("right", frontRight, backRight)})
        seams.insert(seams.end(), leg.begin(), leg.end());
    document.avatarFile = "bodies/mannequin.glb";
    document.scene.substeps = s.substeps;
    document.scene.skinOffset = s.skinOffset;
    document.scene.damping = s.damping;
    document.scene.selfContact = true; // the legs meet at the crotch
    return document;
}

} // namespace toile::samples
