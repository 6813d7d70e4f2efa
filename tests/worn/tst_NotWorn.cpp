// SPDX-License-Identifier: GPL-3.0-or-later
#include "WornScenes.h" // first: moc 6.4 stumbles over <compare> as the first header
#include "tests/Suite.h"
#include "tests/pattern/TwoPanels.h"

#include "core/pattern/PatternPlacement.h"
#include "core/pattern/PatternSeams.h"
#include "samples/CircleSkirt.h"
#include "samples/SmallScenes.h"

using namespace toile;
using namespace toile::simulation;

namespace {

constexpr double controlSpacing = 0.030; // [m]; a control need not close every seam, only be found out
constexpr double dressed = 3.5;          // [s]; sewing takes two, then weight and friction show

/// Without a fault: at the spacing of the sample, at which every seam closes.
const SewReport& correctBlouse() {
    static const SewReport report = sewnFor(4.5, onBlouseWearer(blouseAt(0.020)));
    return report;
}

SewReport skirtWithWaist(double ease) {
    const auto skirt =
        samples::circleSkirt(mannequin().measurements, mannequin().body, {.spacing = 0.040, .waistEase = ease});
    return sewnFor(3, onMannequin(skirt.pattern));
}

/// The pieces stay where they are; the seams that set a sleeve in take the other one.
pattern::Pattern withSleevesSwapped(pattern::Pattern pattern) {
    const auto other = [](const pattern::PieceId& piece) {
        return pattern::PieceId(piece.value == "sleeve-left" ? "sleeve-right" : "sleeve-left");
    };
    for (pattern::Seam& seam : pattern.seams)
        if (seam.name.starts_with("sleeve front") || seam.name.starts_with("sleeve back"))
            for (pattern::SeamPart& part : seam.sides[0]) part.piece = other(part.piece);
    return pattern;
}

/// A piece that lies across the middle of the body turned round the upright line through its origin.
Result<pattern::Pattern> withPieceTurned(const pattern::Pattern& pattern, const pattern::PieceId& piece) {
    const Vec3 at = pattern::findPiece(pattern, piece)->placement->transform.origin;
    return pattern::movePlacement(pattern, piece, {{-1, 0, 0}, {0, 1, 0}, {0, 0, -1}, {2 * at.x, 0, 2 * at.z}});
}

/// A strip of cloth that stays where it is runs through the left front, to and fro past the body, and nothing can
/// draw them apart.
Scene blouseWithStripThroughIt() {
    Scene scene = onBlouseWearer(blouseAt(controlSpacing));
    const pattern::Piece& front = *scene.pattern.pieces[0];
    Vec2 middle;
    for (const pattern::Vertex& vertex : front.outline.vertices)
        middle += vertex.position / static_cast<double>(front.outline.vertices.size());
    const Vec3 at = placed(*front.placement, middle);
    pattern::Piece strip = tests::rectangle("strip", 0.3, 0.08);
    strip.fabric = front.fabric;
    strip.frozen = true;
    strip.placement = pattern::Placement{{{0, 0, 1}, {0, 1, 0}, {-1, 0, 0}, at - Vec3{0, 0.04, 0.2}}, {}};
    scene.pattern.pieces.push_back(strip);
    return scene;
}

/// Between the two squares of the sample, 50 mm thick and out of their reach on every other side.
body::Body wall() {
    body::Body body{"wall", {}, {}, {}};
    for (const double x : {-0.025, 0.025})
        for (const double y : {0.0, 2.0})
            for (const double z : {-1.0, 1.0}) body.mesh.vertices.push_back({x, y, z});
    body.mesh.triangles = {{0, 1, 3}, {0, 3, 2}, {4, 6, 7}, {4, 7, 5}, {0, 4, 5}, {0, 5, 1},
                           {2, 3, 7}, {2, 7, 6}, {0, 2, 6}, {0, 6, 4}, {1, 5, 7}, {1, 7, 3}};
    return body;
}

} // namespace

/// Garments that were put on wrongly must not count as worn, and the verdict must say what is wrong with them.
class tst_NotWorn : public QObject {
    Q_OBJECT
private slots:
    void theCorrectBlouseIsPutOnRight();
    void theCorrectBlouseGivesNoneOfTheReasonsBelow();
    void aSeamReversed_data();
    void aSeamReversed();
    void sleevesSwapped();
    void aPieceInsideOut();
    void layersThatCross();
    void withoutGravity();
    void aWaistbandFarTooWide();
    void aWaistbandFarTooNarrow();
    void aSeamHeldOpenByTheBody();
};

void tst_NotWorn::theCorrectBlouseIsPutOnRight() {
    const SewReport& report = correctBlouse();
    QVERIFY(report.allClosed());
    QVERIFY(report.contact.outsideBody);
    QCOMPARE(report.contact.bodyIntersections, 0);
    QVERIFY(report.worn->rightSideOut >= 0.99);
    QCOMPARE(report.worn->turnedLength, 0.0);
    QCOMPARE(openingsOf(report), (std::vector<std::string>{"left arm", "neck", "right arm", "torso"}));
}

void tst_NotWorn::theCorrectBlouseGivesNoneOfTheReasonsBelow() {
    for (const char* words : {"wrong side", "right side out", "passes through more than one", "is crossed", "No limb",
                              "Without gravity", "seam is closed", "layers have crossed"})
        QVERIFY2(!says(correctBlouse(), words), reasonsOf(correctBlouse()).c_str());
}

void tst_NotWorn::aSeamReversed_data() {
    QTest::addColumn<QString>("seam");
    QTest::newRow("a long one, which twists the trunk") << "seam-side-left";
    QTest::newRow("a short one, whose twist can hardly be seen") << "seam-cuff-seam-left";
}

void tst_NotWorn::aSeamReversed() {
    QFETCH(QString, seam);
    const auto reversed = pattern::reverseSeam(blouseAt(controlSpacing), pattern::SeamId(seam.toStdString()));
    QVERIFY(reversed);
    const SewReport report = sewnFor(dressed, onBlouseWearer(*reversed));
    QVERIFY(!report.worn->worn);
    QVERIFY2(says(report, "Right side is sewn to wrong side"), reasonsOf(report).c_str());
}

/// No armhole reaches the sleeve of the other arm. What is torn to and fro between them is chance, but it never leaves
/// the four openings of a blouse.
void tst_NotWorn::sleevesSwapped() {
    const SewReport report = sewnFor(2.5, onBlouseWearer(withSleevesSwapped(blouseAt(0.040))));
    QVERIFY(!report.worn->worn);
    QVERIFY2(says(report, "Not every seam is closed."), reasonsOf(report).c_str());
    QVERIFY(openingsOf(report) != openingsOf(correctBlouse()));
    QVERIFY2(says(report, "is crossed") || says(report, "No limb passes"), reasonsOf(report).c_str());
}

void tst_NotWorn::aPieceInsideOut() {
    const auto turned = withPieceTurned(blouseAt(controlSpacing), pattern::PieceId("back"));
    QVERIFY(turned);
    const SewReport report = sewnFor(dressed, onBlouseWearer(*turned));
    QVERIFY(!report.worn->worn);
    QVERIFY2(says(report, "of the cloth has its right side out."), reasonsOf(report).c_str());
}

void tst_NotWorn::layersThatCross() {
    Scene scene = blouseWithStripThroughIt();
    const SewSettings settings{.seconds = dressed};
    const std::string words = "Its layers have crossed";
    for (const bool selfContact : {false, true}) {
        scene.settings.selfContact = selfContact;
        const SewReport report = sewn(scene, settings);
        QVERIFY(report.contact.selfIntersections > 0 && !report.worn->worn);
        QCOMPARE(report.contact.layersApart, !selfContact); // no promise is broken that was not given
        QVERIFY2(says(report, words) == selfContact, reasonsOf(report).c_str());
    }
}

void tst_NotWorn::withoutGravity() {
    Scene scene = onBlouseWearer(blouseAt(controlSpacing));
    scene.settings.gravity = {};
    const SewReport report = sewnFor(dressed, scene);
    QVERIFY(!report.worn->worn);
    QVERIFY2(says(report, "Without gravity nothing hangs on the body."), reasonsOf(report).c_str());
}

void tst_NotWorn::aWaistbandFarTooWide() {
    const SewReport fitting = skirtWithWaist(0.010), wide = skirtWithWaist(0.010 + 0.150);
    QVERIFY(!wide.worn->worn);
    QVERIFY2(says(wide, "The uppermost opening lies"), reasonsOf(wide).c_str());
    // It is wider than the hip as well: nothing holds it, and in free fall it drops metres in the time it has.
    QVERIFY(*wide.worn->waistDrop > *fitting.worn->waistDrop + 0.5);
    QVERIFY2(says(wide, "No limb passes through the opening"), reasonsOf(wide).c_str());
    QVERIFY2(!says(fitting, "No limb passes through the opening"), reasonsOf(fitting).c_str());
}

void tst_NotWorn::aWaistbandFarTooNarrow() {
    const SewReport narrow = skirtWithWaist(-0.080);
    QVERIFY(!narrow.worn->worn);
    QVERIFY2(says(narrow, "Woven cloth is stretched by"), reasonsOf(narrow).c_str());
    QVERIFY2(says(narrow, "A hundredth of the woven cloth is stretched by more than"), reasonsOf(narrow).c_str());
    QVERIFY(narrow.worn->wovenStrain->warpMaximum > 0.05); // warp runs round the waist
}

void tst_NotWorn::aSeamHeldOpenByTheBody() {
    const document::Document squares = samples::twoSquares();
    Scene scene{squares.pattern, Shared<body::Body>(wall()), squares.scene};
    scene.settings.damping = 2; // so that it comes to rest against the wall
    auto simulation = Simulation::create(scene);
    QVERIFY(simulation);
    const SewSettings settings{.limit = 6};
    const auto report = sew(*simulation, settings);
    QVERIFY(report);
    QVERIFY(!report->seams[0].state.merged);
    QVERIFY(report->seams[0].gap.maximum >= 0.050);
    QVERIFY(report->contact.outsideBody); // neither sewing nor the finish may press it into the wall
    QVERIFY(!report->allClosed());
    QVERIFY(!report->reachedItsGoal(settings));
    QVERIFY(std::ranges::any_of(report->warnings, [](const Warning& w) { return w.place == "seam \"middle\""; }));
    QVERIFY(!report->worn); // a wall wears nothing
    const Json json = toJson(*report);
    const Json& seam = json.find("seams")->asArray()->front();
    QCOMPARE(*seam.find("closed")->asBool(), false);
    QVERIFY(*seam.find("maximumGap")->asNumber() >= 0.050);
    QVERIFY(seam.find("gapAtMergeMaximum")->isNull());
}

TOILE_TEST(tst_NotWorn)
#include "tst_NotWorn.moc"
