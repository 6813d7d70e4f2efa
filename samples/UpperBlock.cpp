// SPDX-License-Identifier: GPL-3.0-or-later
#include "samples/UpperBlock.h"

#include "samples/Measuring.h"

#include <algorithm>
#include <cmath>

namespace toile::samples {
namespace {

/// The side seam with its dart closed, from the underarm down: straight, then into the waist, then out over the hip.
/// Front and back share its shape, so their lengths agree.
struct SideShape {
    Vec2 high, waist, hem;     ///< from the underarm
    double hipFullness = 0.35; ///< see UpperBlockSettings
};

/// What differs between front and back.
struct Half {
    double underarmX = 0; ///< of the side seam with its dart closed
    double waistY = 0;
    double neckY = 0, neckHandle = 0; ///< of the neckline's middle; share of its depth
    double across = 0;                ///< half the width at half the armhole's height
    double dartAngle = 0;             ///< [rad]
    Vec2 dartTip;
};

Vec2 turned(Vec2 p, Vec2 about, double angle) {
    return about + rotated(p - about, angle);
}

/// Everything both halves need.
struct Frame {
    Vec2 neckSide;
    double shoulderLength = 0, slope = 0;
    SideShape side;
    Solver* solver = nullptr;

    [[nodiscard]] Vec2 alongShoulder() const { return {std::cos(slope), -std::sin(slope)}; }
    [[nodiscard]] Vec2 downFromShoulder() const { return {-std::sin(slope), -std::cos(slope)}; }
    [[nodiscard]] Vec2 shoulderTip() const { return neckSide + shoulderLength * alongShoulder(); }
};

/// Leaves the underarm square to the side seam and arrives square to the shoulder; passes `across` half-way up.
Stroke armhole(const Frame& frame, Vec2 underarm, Vec2 sideDirection, double across) {
    const Vec2 tip = frame.shoulderTip(), inward = leftOf(sideDirection);
    const double low = 0.95 * (underarm.x - across), level = (underarm.y + tip.y) / 2;
    const auto withHandle = [&](double high) {
        return cubic("underarm", "armhole", underarm, low * inward, high * frame.downFromShoulder(), tip);
    };
    const auto excess = [&](double high) {
        const geometry::Curve curve = withHandle(high).curve;
        const double t = frame.solver->rootOf(
            "middle of the armhole", [&](double s) { return pointAt(curve, s).y - level; }, 0, 1);
        return pointAt(curve, t).x - across;
    };
    return withHandle(frame.solver->rootOf("curve of the armhole", excess, 0.0, 0.9 * (tip.y - underarm.y)));
}

Stroke neckline(const Frame& frame, const Half& half) {
    const double depth = frame.neckSide.y - half.neckY;
    return cubic("neck-side", "neckline", frame.neckSide, half.neckHandle * depth * frame.downFromShoulder(),
                 {0.55 * frame.neckSide.x, 0}, {0, half.neckY});
}

std::vector<Stroke> draftHalf(const Frame& frame, const Half& half) {
    const Vec2 closedUnderarm{half.underarmX, half.waistY - frame.side.waist.y};
    const Vec2 high = closedUnderarm + frame.side.high, waist = closedUnderarm + frame.side.waist,
               hem = closedUnderarm + frame.side.hem;
    const double below = waist.y - hem.y, above = high.y - waist.y;
    std::vector<Stroke> strokes{
        line("hem-centre", "hem", {0, hem.y}, hem),
        cubic("hem-side", "side-hip", hem, {0, frame.side.hipFullness * below},
              {0, -(0.7 - frame.side.hipFullness) * below}, waist),
        cubic("waist-side", "side-waist", waist, {0, above / 3}, frame.side.high * (above / 3 / -frame.side.high.y),
              high),
    };
    const Vec2 openHigh = turned(high, half.dartTip, half.dartAngle);
    const Vec2 underarm = turned(closedUnderarm, half.dartTip, half.dartAngle);
    if (half.dartAngle > 0) {
        strokes.push_back(line("dart-lower", "dart-lower", high, half.dartTip));
        strokes.push_back(line("dart-tip", "dart-upper", half.dartTip, openHigh));
    }
    strokes.push_back(line(half.dartAngle > 0 ? "dart-upper" : "side-high", "side-top", openHigh, underarm));
    strokes.push_back(armhole(frame, underarm, normalized(underarm - openHigh), half.across));
    strokes.push_back(line("shoulder-tip", "shoulder", frame.shoulderTip(), frame.neckSide));
    strokes.push_back(neckline(frame, half));
    return strokes;
}

double halfWidth(const std::vector<Stroke>& strokes, double y) {
    pattern::Piece piece;
    piece.outline = halfContour("half", strokes);
    return widthAt(piece, y);
}

/// The half with its side seam at x, and the dart that takes in `intake` there.
Half withUnderarm(Half half, const Frame& frame, double intake, double x) {
    half.underarmX = x;
    const Vec2 high = Vec2{x, half.waistY - frame.side.waist.y} + frame.side.high;
    half.dartAngle = 2 * std::asin(intake / 2 / distance(high, half.dartTip));
    return half;
}

Vec2 underarmOf(const std::vector<Stroke>& half) {
    return std::ranges::find(half, "underarm", &Stroke::vertex)->curve.start;
}

} // namespace

pattern::Contour halfContour(const std::string& piece, std::vector<Stroke> half) {
    half.push_back(line("neck-centre", "centre", half.back().curve.end, half.front().curve.start));
    return contourOf(piece, half);
}

Result<UpperBlock> draftUpperBlock(const body::Measurements& m, const Figures& f, const UpperBlockSettings& s) {
    // The seam lies a little above the shoulder: one degree less slope keeps its tip from pulling.
    const double slope = f.shoulderSlope - 0.02;
    Solver solver;
    Frame frame{{f.neckHalfWidth + s.neckGap, -s.neckGap * std::tan(slope)},
                f.shoulderLength - s.neckGap / std::cos(slope),
                slope,
                {},
                &solver};
    const double backUnderarm = -(f.backNeckDepth + s.armholeDepth);
    const double backWaist = f.backWaist - s.backShortening;
    const double sideTop = backWaist + backUnderarm;
    frame.side = {{-0.1 * s.sideDartAt, -s.sideDartAt},
                  {-s.waistSuppression, -sideTop},
                  {0, -(sideTop + f.waistToHip + s.hemBelowHip)},
                  s.hipFullness};

    Half back{.waistY = -backWaist,
              .neckY = -(f.backNeckDepth + s.napeGap),
              .neckHandle = 0.5,
              .across = (f.acrossBack + s.acrossBackEase) / 2};
    Half front{.waistY = -f.frontWaist,
               .neckY = -(f.frontNeckDepth + s.neckGap),
               .neckHandle = 0.6,
               .across = (f.acrossFront + s.acrossFrontEase) / 2};

    const double bustAside = f.bustHalfDistance - f.neckHalfWidth;
    const double bustY = -std::sqrt(f.bustHeight * f.bustHeight - bustAside * bustAside);
    front.dartTip = {f.bustHalfDistance + s.dartTipDistance, bustY};

    const double quarter = (m.bust + s.bustEase) / 4;
    const auto bustWidth = [&](const Half& half, double y) { return halfWidth(draftHalf(frame, half), y); };
    front = withUnderarm(front, frame, s.dartIntake,
                         solver.rootOf(
                             "width of the front",
                             [&](double x) {
                                 return bustWidth(withUnderarm(front, frame, s.dartIntake, x), bustY) -
                                        (quarter + s.frontMore);
                             },
                             quarter - 0.03, quarter + 0.05));

    UpperLevels levels;
    levels.bustFront = bustY;
    levels.bustBack = backUnderarm - (underarmOf(draftHalf(frame, front)).y - bustY);
    back.underarmX = solver.rootOf(
        "width of the back",
        [&](double x) { return bustWidth(withUnderarm(back, frame, 0, x), levels.bustBack) - (quarter - s.frontMore); },
        quarter - 0.03, quarter + 0.05);

    levels.hipFront = front.waistY - f.waistToHip;
    levels.hipBack = back.waistY - f.waistToHip;
    frame.side.hem.x = solver.rootOf(
        "width of the hem",
        [&](double x) {
            Frame trial = frame;
            trial.side.hem.x = x;
            return 2 * (halfWidth(draftHalf(trial, front), levels.hipFront) +
                        halfWidth(draftHalf(trial, back), levels.hipBack)) -
                   (m.hip + s.hipEase);
        },
        -0.1, 0.1);

    levels.acrossFront = (underarmOf(draftHalf(frame, front)).y + frame.shoulderTip().y) / 2;
    levels.acrossBack = (backUnderarm + frame.shoulderTip().y) / 2;
    UpperBlock block{draftHalf(frame, front), draftHalf(frame, back), levels};
    if (solver.error()) return tl::unexpected(*solver.error());
    return block;
}

} // namespace toile::samples
