// SPDX-License-Identifier: GPL-3.0-or-later
#include "samples/Shirt.h"

#include "core/material/FabricPresets.h"
#include "samples/Measuring.h"
#include "samples/Placing.h"

#include <algorithm>

namespace toile::samples {
namespace {

using namespace pattern;

struct ShirtTorso {
    Piece frontLeft, frontRight, back, yoke;
};

Stroke& strokeNamed(std::vector<Stroke>& strokes, const std::string& edge) {
    return *std::ranges::find(strokes, edge, &Stroke::edge);
}

/// Half a front that goes on beyond the centre by the button stand.
std::vector<Stroke> withButtonStand(std::vector<Stroke> half, double width) {
    const Vec2 bottom = half.front().curve.start, top = half.back().curve.end, beyond{-width, 0};
    half.insert(half.begin(), line("hem-edge", "hem-extension", bottom + beyond, bottom));
    half.push_back(line("neck-centre", "neckline-extension", top, top + beyond));
    half.push_back(line("neck-edge", "edge", top + beyond, bottom + beyond));
    return half;
}

struct DividedBack {
    std::vector<Stroke> back, yoke; ///< halves
};

/// Half a back cut at a level that meets the armhole: its upper part is the yoke.
DividedBack dividedAt(double level, std::vector<Stroke> half) {
    const Stroke armhole = strokeNamed(half, "armhole");
    double low = 0, high = 1;
    for (int i = 0; i < 60; ++i) {
        const double middle = (low + high) / 2;
        (pointAt(armhole.curve, middle).y < level ? low : high) = middle;
    }
    const auto [below, above] = splitAt(armhole.curve, low);
    const auto cut = std::ranges::find(half, "armhole", &Stroke::edge);
    const Vec2 centre{0, above.start.y};
    DividedBack divided{{half.begin(), cut}, {line("yoke-centre", "back", centre, above.start)}};
    divided.back.push_back({armhole.vertex, "armhole", below});
    divided.back.push_back(line("yoke-end", "yoke", below.end, centre));
    divided.yoke.push_back({"yoke-end", "armhole", above});
    divided.yoke.insert(divided.yoke.end(), cut + 1, half.end());
    return divided;
}

void placeTorso(ShirtTorso& torso, const Piece& wholeBack, const body::Body& body) {
    constexpr double rightOverLeft = 0.008;                 // [m]
    const double height = body.landmarks.neckLeft.y + 0.03; // drawn together above the shoulders, they sink on them
    const Panel before{.behind = false, .height = height, .lean = 0.22};
    torso.frontLeft.placement = placedPanel(torso.frontLeft, body, before);
    torso.back.placement = placedPanel(wholeBack, body, {.behind = true, .height = height, .lean = 0.12});
    torso.yoke.placement = torso.back.placement;
    torso.frontRight = mirrorPiece("front-right", "Front right", torso.frontLeft);
    torso.frontRight.placement->transform.origin += rightOverLeft * torso.frontRight.placement->transform.axisZ;
    torso.frontRight.layer = 1;
}

Result<ShirtTorso> draftTorso(const body::Measurements& m, const body::Body& body, const Fabric& fabric,
                              const ShirtSettings& s) {
    const Figures f = figuresOf(m, body.landmarks);
    const auto block = draftUpperBlock(m, f, s.block);
    if (!block) return tl::unexpected(block.error());
    ShirtTorso torso{pieceNamed("front-left", "Front left", fabric, s.spacing),
                     {},
                     pieceNamed("back", "Back", fabric, s.spacing),
                     pieceNamed("yoke", "Yoke", fabric, s.spacing)};
    torso.frontLeft.outline = contourOf("front-left", withButtonStand(block->front, s.buttonStand));
    const auto divided = dividedAt(-(f.backNeckDepth + s.yokeDepth), block->back);
    torso.back.outline = contourOf("back", wholeFromHalf(divided.back, "yoke-centre", "-right", "-left"));
    torso.yoke.outline = contourOf("yoke", wholeFromHalf(divided.yoke, "neck-centre", "-right", "-left"));
    torso.yoke.plies = 2; // the fronts' and the back's seam allowances lie between them
    const NotchDistances at;
    torso.frontLeft.notches = {armholeNotch(torso.frontLeft, "armhole", at.front, true, false)};
    torso.back.notches = {armholeNotch(torso.back, "armhole-right", at.back, true, true),
                          armholeNotch(torso.back, "armhole-left", at.back, false, true)};
    Piece wholeBack = pieceNamed("back", "Back", fabric, s.spacing);
    wholeBack.outline = contourOf("back", wholeFromHalf(block->back, "neck-centre", "-right", "-left"));
    placeTorso(torso, wholeBack, body);
    return torso;
}

Side turnedRound(Side side) {
    side.reversed = !side.reversed;
    return side;
}

/// What is sewn on one side, with its half of back and yoke.
struct Half {
    std::string side;
    const Piece &front, &sleeve, &cuff, &stand;
    HalfEdges back, yoke;
};

std::vector<Seam> sewHalf(const Half& h, const SleeveSettings& settings) {
    const HalfEdges front = halfOf(h.front);
    const auto sideOf = [](const HalfEdges& half) {
        return std::vector{half("side-hip"), half("side-waist"), half("side-top")};
    };
    std::vector<Seam> seams{
        seam("dart " + h.side, {along(h.front, "dart-lower")}, {against(h.front, "dart-upper")}),
        seam("yoke " + h.side, {h.back("yoke")}, {turnedRound(h.yoke("back"))}),
        seam("shoulder " + h.side, {front("shoulder")}, {h.yoke("shoulder")}),
        seam("side " + h.side, sideOf(front), sideOf(h.back)),
        seam("sleeve front " + h.side, {against(h.sleeve, "cap-front")}, {front("armhole")},
             {{0, {}}, {settings.frontEase, {}}}),
        seam("sleeve back " + h.side, {along(h.sleeve, "cap-back")}, {h.back("armhole"), h.yoke("armhole")},
             {{0, {}}, {settings.backEase, {}}}),
        seam("sleeve seam " + h.side, {along(h.sleeve, "seam-back")}, {against(h.sleeve, "seam-front")}),
        seam("neckline " + h.side, {along(h.stand, "bottom")},
             {against(h.front, "neckline-extension"), against(h.front, "neckline"), h.yoke("neckline")})};
    const auto cuffs = sewCuff(h.side, h.sleeve, h.cuff);
    seams.insert(seams.end(), cuffs.begin(), cuffs.end());
    return seams;
}

Tack button(int number, double diameter, ClothPoint left, ClothPoint right) {
    Tack tack;
    tack.id = TackId{"button-" + std::to_string(number)};
    tack.name = "Button " + std::to_string(number);
    tack.ends = {std::move(left), std::move(right)};
    tack.buttonDiameter = diameter;
    return tack;
}

/// The first on the stand, five down the centre of the fronts.
std::vector<Tack> buttons(const ShirtTorso& torso, const CollarStand& stand, const ShirtSettings& s) {
    const auto at = [&](const char* vertex) {
        return vertexPosition(torso.frontLeft, vertexId("front-left", vertex)).y;
    };
    const double first = at("neck-centre") - s.firstButton, last = at("hem-centre") + s.lastButton;
    const Vec2 onStand{0, s.stand.height / 2};
    std::vector<Tack> row{button(1, s.buttonDiameter, {stand.left.id, onStand}, {stand.right.id, onStand})};
    constexpr int onFronts = 5;
    for (int i = 0; i < onFronts; ++i) {
        const Vec2 place{0, first + (last - first) * i / (onFronts - 1)};
        row.push_back(button(i + 2, s.buttonDiameter, {torso.frontLeft.id, place}, {torso.frontRight.id, place}));
    }
    return row;
}

/// The level at which a stand's top starts.
double standTop(const CollarStand& stand) {
    const Vec2 corner = vertexPosition(stand.left, vertexId("stand-left", "back-top"));
    return stand.left.placement->transform.origin.y + corner.y;
}

void sewOn(Pattern& pattern, const Piece& collar, const CollarStand& stand, const FoldedCollarSettings& s) {
    Seam turned = seam("collar", {along(collar, "neck")}, {against(stand.left, "top"), along(stand.right, "top")});
    turned.foldAngle = s.foldAngle;
    turned.order = 1;
    pattern.pieces.push_back(collar);
    pattern.seams.push_back(turned);
}

} // namespace

Result<document::Document> shirt(const body::Measurements& m, const body::Body& body, const ShirtSettings& s) {
    const Fabric fabric = material::poplin();
    const auto drafted = draftTorso(m, body, fabric, s);
    if (!drafted) return tl::unexpected(drafted.error());
    const ShirtTorso& torso = *drafted;

    const NotchDistances at;
    const double backArmhole = edgeLength(torso.back, edgeId("back", "armhole-right")) +
                               edgeLength(torso.yoke, edgeId("yoke", "armhole-right"));
    const Armholes armholes{edgeLength(torso.frontLeft, edgeId("front-left", "armhole")), backArmhole, at.front,
                            at.back};
    const CuffedSleeve cuffed{s.aboveWrist, s.cuffWidth, m.wrist + s.cuffEase};
    const SleeveSettings sleeveDraft{.width = m.biceps + s.bicepsEase,
                                     .bicepsBelow = s.bicepsBelow,
                                     .bottom = cuffed.cuffLength,
                                     .frontEase = s.frontCapEase,
                                     .backEase = s.backCapEase};
    auto arm = draftCuffedSleeve(m, fabric, s.spacing, armholes, sleeveDraft, cuffed);
    if (!arm) return tl::unexpected(arm.error());
    const double sleeveBottom = placeSleeve(*arm, body);
    const Piece& sleeve = arm->piece;
    Piece cuff = draftCuff(fabric, s.spacing, body, sleeveBottom, cuffed);
    cuff.interfacing = Interfacing{};
    const Piece sleeveRight = mirrorPiece("sleeve-right", "Sleeve right", sleeve);
    Piece cuffRight = mirrorPiece("cuff-right", "Cuff right", cuff);
    cuffRight.interfacing = cuff.interfacing;

    const double neckline = edgeLength(torso.frontLeft, edgeId("front-left", "neckline")) +
                            edgeLength(torso.yoke, edgeId("yoke", "neckline-left"));
    const CollarStand stand = draftCollarStand(fabric, body, {neckline, s.buttonStand}, s.stand);

    document::Document document;
    Pattern& pattern = document.pattern;
    pattern.fabrics = {fabric};
    pattern.pieces = {torso.frontLeft, torso.frontRight, torso.back, torso.yoke, sleeve, sleeveRight, cuff,
                      cuffRight,       stand.left,       stand.right};
    const auto sewn = [&](const Half& half) {
        const auto seams = sewHalf(half, sleeveDraft);
        pattern.seams.insert(pattern.seams.end(), seams.begin(), seams.end());
    };
    const auto leftOf = [](const Piece& piece) { return negativeHalf(piece, "-left"); };
    const auto rightOf = [](const Piece& piece) { return positiveHalf(piece, "-right"); };
    sewn({"left", torso.frontLeft, sleeve, cuff, stand.left, leftOf(torso.back), leftOf(torso.yoke)});
    sewn({"right", torso.frontRight, sleeveRight, cuffRight, stand.right, rightOf(torso.back), rightOf(torso.yoke)});
    pattern.seams.push_back(collarStandSeam(stand));
    sewOn(pattern, draftFoldedCollar(fabric, body, 2 * neckline, standTop(stand), s.collar), stand, s.collar);
    pattern.tacks = buttons(torso, stand, s);
    document.scene.skinOffset = 0.0035; // as the blouse's
    document.scene.selfContact = true;
    document.avatarFile = "bodies/mannequin-42.glb";
    return document;
}

} // namespace toile::samples
