// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/collision/BodySurface.h"
#include "core/simulation/Worn.h"
#include "tests/Suite.h"
#include "tests/simulation/Tubes.h"

#include <QTest>
#include <cmath>
#include <numbers>

using namespace toile;
using namespace toile::simulation;

namespace {

constexpr int around = 24;

void appendRing(std::vector<Vec3>& points, const Vec3& centre, double radius) {
    const std::vector<Vec3> ring = tubes::ring(centre, radius, around);
    points.insert(points.end(), ring.begin(), ring.end());
}

void appendBand(std::vector<std::array<int, 3>>& triangles, int lower, int upper) {
    tubes::appendBand(triangles, lower, upper, around);
}

/// An upright open tube of cloth.
Drape tube(const Vec3& foot, double height, double radius) {
    Drape drape;
    appendRing(drape.positions, foot, radius);
    appendRing(drape.positions, foot + Vec3{0, height, 0}, radius);
    appendBand(drape.triangles, 0, around);
    drape.start = drape.positions;
    return drape;
}

void append(Drape& drape, const Drape& more) {
    const int first = static_cast<int>(drape.positions.size());
    for (const auto& [a, b, c] : more.triangles) drape.triangles.push_back({a + first, b + first, c + first});
    drape.positions.insert(drape.positions.end(), more.positions.begin(), more.positions.end());
    drape.start.insert(drape.start.end(), more.start.begin(), more.start.end());
}

void appendColumn(geometry::TriangleMesh& mesh, const Vec3& foot, double height, double radius) {
    const int first = static_cast<int>(mesh.vertices.size());
    appendRing(mesh.vertices, foot, radius);
    appendRing(mesh.vertices, foot + Vec3{0, height, 0}, radius);
    std::vector<std::array<int, 3>> side;
    appendBand(side, first, first + around);
    for (int i = 1; i + 1 < around; ++i) {
        side.push_back({first, first + i + 1, first + i});
        side.push_back({first + around, first + around + i, first + around + i + 1});
    }
    mesh.triangles.insert(mesh.triangles.end(), side.begin(), side.end());
}

/// A trunk of 0.1 m radius, shoulders at 1.4 m, and an arm that hangs on either side of it, 0.3 m away.
const body::Body& post() {
    static const body::Body made = [] {
        body::Body body{"post", {}, {}, {}};
        appendColumn(body.mesh, {0, 0, 0}, 1.7, 0.1);
        appendColumn(body.mesh, {0.3, 0.7, 0}, 0.7, 0.04);
        appendColumn(body.mesh, {-0.3, 0.7, 0}, 0.7, 0.04);
        body.landmarks.acromionLeft = {0.3, 1.4, 0};
        body.landmarks.acromionRight = {-0.3, 1.4, 0};
        body.landmarks.nape = {0, 1.45, -0.1};
        body.landmarks.neckLeft = {0.09, 1.44, 0};
        body.landmarks.neckRight = {-0.09, 1.44, 0};
        // Neck and torso overlap, as a mannequin's do.
        body.axes = {{body::Limb::neck, {{0, 1.3, 0}, {0, 1.4, 0.01}, {0, 1.9, 0}}},
                     {body::Limb::torso, {{0, 1.4, 0}, {0, -0.2, 0}}},
                     {body::Limb::leftArm, {{0.3, 1.4, 0}, {0.3, 0.5, 0}}},
                     {body::Limb::rightArm, {{-0.3, 1.4, 0}, {-0.3, 0.5, 0}}}};
        return body;
    }();
    return made;
}

WornReport verdictOn(const Drape& drape) {
    static const collision::BodySurface surface = *collision::BodySurface::create(post().mesh);
    return wornReport(drape, post(), surface);
}

bool says(const WornReport& report, const std::string& words) {
    return std::ranges::any_of(report.why,
                               [&](const std::string& why) { return why.find(words) != std::string::npos; });
}

/// A skirt: round the trunk between 0.6 and 1.0 m.
Drape skirt() {
    return tube({0, 0.6, 0}, 0.4, 0.13);
}

} // namespace

/// The verdict on shapes whose faults are put in by hand.
class tst_Worn : public QObject {
    Q_OBJECT
private slots:
    void aTubeRoundTheTrunkIsWorn();
    void whereNeckAndTorsoOverlapAnOpeningIsCrossedOnce();
    void aHemInDeepFoldsIsCrossedOnce();
    void aTubeRoundAnArmIsNamedAfterIt();
    void aTubeBesideTheBodyIsNotWorn();
    void aClosedBallIsNotWorn();
    void aTubeRoundTrunkAndArmIsNotSound();
    void twoTubesOnOneArmAreSaid();
    void aSleevePlacedOnTheOtherSideIsSaid();
    void insideOutIsSeen();
    void aSeamSewnTheWrongWayRoundIsMeasured();
    void aWaistThatSlidIsSaid();
    void wovenClothThatIsStretchedIsSaid_data();
    void wovenClothThatIsStretchedIsSaid();
    void aSkirtHasNoNeckOpening();
    void theBackNeckPointIsMeasuredToTheNape();
    void aWideNecklineMayLieLower_data();
    void aWideNecklineMayLieLower();
    void underACollarTheSeamCounts_data();
    void underACollarTheSeamCounts();
    void mirrorPairsAreCompared();
    void cornersOfAHemThatHangsFreeAreNoLandmarks();
};

void tst_Worn::aTubeRoundTheTrunkIsWorn() {
    const WornReport report = verdictOn(skirt());
    QVERIFY2(report.worn, report.why.empty() ? "" : report.why.front().c_str());
    QCOMPARE(report.openings.size(), std::size_t(2));
    for (const OpeningReport& opening : report.openings) {
        QCOMPARE(opening.name, std::string("torso"));
        QCOMPARE(opening.crossings, 1);
        const double polygon = 2 * around * 0.13 * std::sin(std::numbers::pi / around);
        QVERIFY(std::abs(opening.perimeter - polygon) < 1e-12);
    }
    QCOMPARE(report.rightSideOut, 1.0);
    QCOMPARE(*report.waistDrop, 0.0);
    QVERIFY(!report.napeDistance && !report.symmetryDifference);
}

void tst_Worn::whereNeckAndTorsoOverlapAnOpeningIsCrossedOnce() {
    for (const OpeningReport& opening : verdictOn(tube({0, 1.2, 0}, 0.15, 0.13)).openings)
        QCOMPARE(opening.crossings, 1);
}

void tst_Worn::aHemInDeepFoldsIsCrossedOnce() {
    std::vector<Vec3> hem; // goes round once, but wanders to and fro by more than it gets on
    for (int i = 0; i < 240; ++i) {
        const double turn = 2 * std::numbers::pi * i / 240, angle = turn + 0.5 * std::sin(8 * turn);
        hem.push_back({0.2 * std::cos(angle), 0.02 * std::sin(5 * turn), 0.2 * std::sin(angle)});
    }
    for (double x = -0.15; x < 0.16; x += 0.05) QCOMPARE(crossings(hem, {{x, 1, 0.03}, {x, -1, 0.03}}), 1);
    QCOMPARE(crossings(hem, {{0.5, 1, 0}, {0.5, -1, 0}}), 0);
    QCOMPARE(crossings(hem, {{0, 1, 0.03}, {0, -1, 0.03}, {0.5, -1, 0}, {0.5, 1, 0}, {0, 1, 0.03}, {0, -1, 0.03}}), 2);
}

void tst_Worn::aTubeRoundAnArmIsNamedAfterIt() {
    const WornReport left = verdictOn(tube({0.3, 0.8, 0}, 0.3, 0.06)),
                     right = verdictOn(tube({-0.3, 0.8, 0}, 0.3, 0.06));
    for (const OpeningReport& opening : left.openings) QCOMPARE(opening.name, std::string("left arm"));
    for (const OpeningReport& opening : right.openings) QCOMPARE(opening.name, std::string("right arm"));
}

void tst_Worn::aTubeBesideTheBodyIsNotWorn() {
    const WornReport report = verdictOn(tube({0, 0.6, 0.4}, 0.4, 0.13));
    QVERIFY(!report.worn);
    QVERIFY(says(report, "No limb passes through the opening at height 600 mm."));
    QVERIFY(says(report, "No limb passes through the opening at height 1000 mm."));
    QCOMPARE(report.openings[0].name, std::string("free edge"));
}

void tst_Worn::aClosedBallIsNotWorn() {
    geometry::TriangleMesh bag;
    appendColumn(bag, {0, 0.5, 0.4}, 0.3, 0.1);
    QVERIFY(says(verdictOn({bag.triangles, bag.vertices, bag.vertices, {}}), "The garment has no opening."));
}

void tst_Worn::aTubeRoundTrunkAndArmIsNotSound() {
    const WornReport report = verdictOn(tube({0, 0.8, 0}, 0.4, 0.5)); // round everything
    QVERIFY(!report.worn);
    QVERIFY(says(report, "The opening at height 800 mm is crossed 3 times (torso, left arm, right arm)."));
}

void tst_Worn::twoTubesOnOneArmAreSaid() {
    Drape sleeves = tube({0.3, 0.75, 0}, 0.1, 0.06);
    append(sleeves, tube({0.3, 1.0, 0}, 0.1, 0.06));
    QVERIFY(says(verdictOn(sleeves), "The left arm passes through more than one opening."));
}

void tst_Worn::aSleevePlacedOnTheOtherSideIsSaid() {
    Drape sleeve = tube({0.3, 0.8, 0}, 0.3, 0.06);
    QVERIFY(!says(verdictOn(sleeve), "placed on the other side"));
    for (Vec3& p : sleeve.start) p.x -= 0.6;
    QVERIFY(says(verdictOn(sleeve), "The left arm is in an opening that was placed on the other side."));
}

void tst_Worn::insideOutIsSeen() {
    Drape drape = skirt();
    for (auto& triangle : drape.triangles) std::swap(triangle[1], triangle[2]);
    const WornReport report = verdictOn(drape);
    QCOMPARE(report.rightSideOut, 0.0);
    QVERIFY(says(report, "Only 0.0 % of the cloth has its right side out."));
}

void tst_Worn::aSeamSewnTheWrongWayRoundIsMeasured() {
    Drape drape = skirt();
    QCOMPARE(verdictOn(drape).turnedLength, 0.0);
    for (std::size_t t = 0; t < 2; ++t) std::swap(drape.triangles[t][1], drape.triangles[t][2]); // one cell of the tube
    const WornReport report = verdictOn(drape);
    QVERIFY(std::abs(report.turnedLength - 2 * 0.4) < 1e-12); // both its upright edges
    QVERIFY(says(report, "Right side is sewn to wrong side along 800 mm."));
    QVERIFY(!report.worn);
}

void tst_Worn::aWaistThatSlidIsSaid() {
    Drape drape = skirt();
    for (Vec3& p : drape.start) p.y += 0.014;
    QVERIFY(verdictOn(drape).worn);
    for (Vec3& p : drape.start) p.y += 0.002;
    const WornReport report = verdictOn(drape);
    QVERIFY(std::abs(*report.waistDrop - 0.016) < 1e-12);
    QVERIFY(says(report, "The uppermost opening lies 16.0 mm below the level it was placed at."));
}

void tst_Worn::wovenClothThatIsStretchedIsSaid_data() {
    QTest::addColumn<double>("warpPercentile99");
    QTest::addColumn<double>("weftPercentile99");
    QTest::addColumn<double>("warpMaximum");
    QTest::addColumn<double>("weftMaximum");
    QTest::addColumn<QString>("sentence"); // empty: worn
    QTest::newRow("just within the limits") << 0.0199 << 0.0199 << 0.0499 << 0.0499 << "";
    QTest::newRow("much of it, along warp")
        << 0.021 << 0.010 << 0.030 << 0.030
        << "A hundredth of the woven cloth is stretched by more than 2.1 % along its warp.";
    QTest::newRow("much of it, along weft")
        << 0.010 << 0.021 << 0.030 << 0.030
        << "A hundredth of the woven cloth is stretched by more than 2.1 % along its weft.";
    QTest::newRow("a spot, along warp") << 0.010 << 0.010 << 0.051 << 0.030
                                        << "Woven cloth is stretched by 5.1 % along its warp.";
    QTest::newRow("a spot, along weft") << 0.010 << 0.010 << 0.030 << 0.051
                                        << "Woven cloth is stretched by 5.1 % along its weft.";
}

void tst_Worn::wovenClothThatIsStretchedIsSaid() {
    QFETCH(double, warpPercentile99);
    QFETCH(double, weftPercentile99);
    QFETCH(double, warpMaximum);
    QFETCH(double, weftMaximum);
    QFETCH(QString, sentence);
    Drape drape = skirt();
    drape.wovenStrain = {.warpMaximum = warpMaximum,
                         .weftMaximum = weftMaximum,
                         .warpPercentile99 = warpPercentile99,
                         .weftPercentile99 = weftPercentile99};
    const WornReport report = verdictOn(drape);
    QCOMPARE(report.worn, sentence.isEmpty());
    QCOMPARE(report.why.size(), std::size_t(sentence.isEmpty() ? 0 : 1));
    if (!sentence.isEmpty()) QCOMPARE(QString::fromStdString(report.why.front()), sentence);
}

void tst_Worn::aSkirtHasNoNeckOpening() {
    QVERIFY(!hasNeckOpening(skirt(), post()));
    QVERIFY(hasNeckOpening(tube({0, 1.2, 0}, 0.25, 0.11), post()));
}

void tst_Worn::theBackNeckPointIsMeasuredToTheNape() {
    const Drape collar = tube({0, 1.2, 0}, 0.25, 0.11); // its upper edge lies at the nape's height
    const WornReport report = verdictOn(collar);
    QVERIFY(std::ranges::count(report.openings, "neck", &OpeningReport::name) == 1);
    // The ring passes x = 0 behind between two corners of a 24-gon: at most r(1 − cos 7.5°) nearer than its radius.
    QVERIFY(std::abs(*report.napeDistance - 0.010) < 0.11 * (1 - std::cos(std::numbers::pi / around)) + 1e-9);
    QVERIFY(!report.waistDrop);
}

void tst_Worn::aWideNecklineMayLieLower_data() {
    QTest::addColumn<double>("radius"); // of the neckline; the neck's is 0.09 m, the nape lies 0.1 m behind its middle
    QTest::addColumn<double>("height"); // of the neckline; the nape's is 1.45 m
    QTest::addColumn<bool>("right");
    QTest::newRow("as wide as the neck, at its level") << 0.090 << 1.44 << true;
    QTest::newRow("as wide as the neck, lower") << 0.090 << 1.43 << false;
    QTest::newRow("wider, lower by what it is wider") << 0.112 << 1.43 << true;
    QTest::newRow("wider, lower by more than that") << 0.112 << 1.41 << false;
    QTest::newRow("wider, but higher") << 0.112 << 1.47 << false;
}

void tst_Worn::aWideNecklineMayLieLower() {
    QFETCH(double, radius);
    QFETCH(double, height);
    QFETCH(bool, right);
    const WornReport report = verdictOn(tube({0, height - 0.2, 0}, 0.2, radius));
    QVERIFY(std::abs(*report.necklineWiderBy - (radius - 0.09)) < 0.001); // 24 corners, none at the sides
    QCOMPARE(!says(report, "from the nape, more than"), right);
}

void tst_Worn::underACollarTheSeamCounts_data() {
    QTest::addColumn<double>("high"); // the upper piece; its edge is as far above the nape
    QTest::addColumn<bool>("isCollar");
    QTest::newRow("a collar") << 0.06 << true;
    QTest::newRow("a yoke") << 0.10 << false;
}

void tst_Worn::underACollarTheSeamCounts() {
    QFETCH(double, high);
    QFETCH(bool, isCollar);
    const double level = post().landmarks.nape.y;
    Drape drape = tube({0, level - 0.2, 0}, 0.2, 0.1);
    drape.piece.assign(drape.triangles.size(), 0);
    appendRing(drape.positions, {0, level + high, 0}, 0.1);
    appendBand(drape.triangles, around, 2 * around);
    drape.piece.resize(drape.triangles.size(), 1);
    drape.start = drape.positions;
    const WornReport report = verdictOn(drape);
    // Behind, between two corners, the tube is narrower by r(1 − cos 7.5°) at most.
    const double narrower = 0.1 * (1 - std::cos(std::numbers::pi / around));
    QVERIFY(std::abs(*report.napeDistance - (isCollar ? 0 : high)) <= narrower);
    QCOMPARE(!says(report, "from the nape, more than"), isCollar);
}

void tst_Worn::mirrorPairsAreCompared() {
    Drape drape = skirt();
    const int left = static_cast<int>(drape.positions.size()), right = left + 1;
    drape.positions.insert(drape.positions.end(), {{0.13, 0.8, 0.01}, {-0.13, 0.8, 0.01}});
    drape.start = drape.positions;
    drape.mirrorPairs = {{left, right}};
    QCOMPARE(*verdictOn(drape).symmetryDifference, 0.0);
    drape.positions[right] += Vec3{0, 0.006, 0};
    const WornReport report = verdictOn(drape);
    QVERIFY(std::abs(*report.symmetryDifference - 0.006) < 1e-12);
    QVERIFY(says(report, "Left and right differ by 6.0 mm."));
}

void tst_Worn::cornersOfAHemThatHangsFreeAreNoLandmarks() {
    const auto flared = [](double hemRadius) {
        Drape drape = skirt(); // and its hem so wide
        for (int i = 0; i < around; ++i) {
            drape.positions[i].x *= hemRadius / 0.13;
            drape.positions[i].z *= hemRadius / 0.13;
        }
        drape.positions[0].y -= 0.02; // one corner hangs lower
        drape.start = drape.positions;
        drape.mirrorPairs = {{0, around / 2}};
        return drape;
    };
    Drape close = flared(0.14), free = flared(0.16);
    QVERIFY(*verdictOn(close).symmetryDifference > 0.02);      // 0.04 m from the body
    QVERIFY(!verdictOn(free).symmetryDifference);              // 0.06 m
    free.mirrorPairs.push_back({around, around + around / 2}); // on its waist
    free.positions[around].y += 0.01;
    QVERIFY(std::abs(*verdictOn(free).symmetryDifference - 0.01) < 0.001);
}

TOILE_TEST(tst_Worn)
#include "tst_Worn.moc"
