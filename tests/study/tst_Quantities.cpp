// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/Sew.h"
#include "core/study/Quantities.h"
#include "samples/SmallScenes.h"
#include "tests/Suite.h"
#include "tests/simulation/Tubes.h"

#include <QTest>
#include <cmath>
#include <numbers>

using namespace toile;
using study::Quantity;

namespace {

constexpr int around = 96;
constexpr double polygon = 0.9998; ///< girth of a regular 96-gon over that of its circle

/// A trunk of 0.1 m radius from the floor to 1.7 m with its neck at 1.45 m; bust, waist and hip at 1.2, 1.0 and 0.8 m.
const body::Body& post() {
    static const body::Body made = [] {
        body::Body body{
            "post",
            tubes::throughRings({tubes::ring({0, 0, 0}, 0.1, around), tubes::ring({0, 1.7, 0}, 0.1, around)}),
            {},
            {}};
        body.landmarks.bustLeft = {0.05, 1.2, 0.09};
        body.landmarks.waist = {0, 1.0, 0};
        body.landmarks.hip = {0, 0.8, 0};
        body.landmarks.nape = {0, 1.45, -0.1};
        body.landmarks.neckLeft = {0.1, 1.45, 0};
        body.landmarks.neckRight = {-0.1, 1.45, 0};
        body.landmarks.acromionLeft = {0.1, 1.4, 0};
        body.landmarks.acromionRight = {-0.1, 1.4, 0};
        body.axes = {{body::Limb::neck, {{0, 1.4, 0}, {0, 1.9, 0}}}, {body::Limb::torso, {{0, 1.45, 0}, {0, -0.2, 0}}}};
        return body;
    }();
    return made;
}

simulation::Drape tubeThrough(const std::vector<std::vector<Vec3>>& rings) {
    const geometry::TriangleMesh mesh = tubes::throughRings(rings);
    return {mesh.triangles, mesh.vertices, mesh.vertices, {}, std::vector<int>(mesh.triangles.size(), 0)};
}

std::vector<Quantity> quantitiesOf(const simulation::Drape& drape, double touching = 0.003) {
    static const collision::BodySurface surface = *collision::BodySurface::create(post().mesh);
    return study::quantitiesOf({drape, &post(), &surface, std::vector<double>(drape.positions.size(), touching), {}});
}

const Quantity& named(const std::vector<Quantity>& all, std::string_view key) {
    return *std::ranges::find(all, key, &Quantity::key);
}

double valueOf(const std::vector<Quantity>& all, std::string_view key) {
    return named(all, key).value.value_or(NAN);
}

bool isNear(double value, double expected, double tolerance) {
    return std::abs(value - expected) < tolerance;
}

/// A tube of 0.13 m radius from the nape to between hip and waist.
simulation::Drape shirt() {
    return tubeThrough({tubes::ring({0, 0.9, 0}, 0.13, around), tubes::ring({0, 1.45, 0}, 0.13, around)});
}

/// A line whose distance from the middle swings so many times.
std::vector<Vec3> wavy(int waves, double swing, double height = 0.5) {
    std::vector<Vec3> line;
    for (int i = 0; i < around; ++i) {
        const double angle = 2 * std::numbers::pi * i / around + 0.01, r = 0.25 + swing * std::cos(waves * angle);
        line.push_back({r * std::cos(angle), height, -r * std::sin(angle)});
    }
    return line;
}

} // namespace

/// The named quantities of shapes whose answers are known.
class tst_Quantities : public QObject {
    Q_OBJECT
private slots:
    void easeIsTheGirthThatTheBodyDoesNotFill();
    void aGarmentThatEndsAboveALevelHasNoEaseThere();
    void aHemThatIsCutByALevelHasNoEaseThere();
    void aSlantedHemIsHigherOnOneSide();
    void foldsAreCounted_data();
    void foldsAreCounted();
    void aTubeOnTheSkinTouchesWithAllItsArea();
    void aHigherNecklineIsFartherFromTheNape();
    void theShoulderIsWhereItsSeamEnds();
    void aSkirtHasAHemAndNoNeck();
    void aWaistbandAloneIsNoHem();
    void aGarmentWithLimbsInItIsNotToldAsHanging();
    void clothOnNothingIsToldByHeightShadowAndFolds();
    void theMeanHeightIsThatOfTheArea();
    void clothThatCoversItselfCastsOneShadow();
    void strainIsThatOfTheHoop();
};

void tst_Quantities::easeIsTheGirthThatTheBodyDoesNotFill() {
    const auto all = quantitiesOf(shirt());
    const double ease = 2 * std::numbers::pi * 0.03;
    QVERIFY(isNear(valueOf(all, "bustEase"), ease, 1e-4)); // both polygons have as many corners
    QVERIFY(isNear(valueOf(all, "waistEase"), ease, 1e-4));
}

void tst_Quantities::aGarmentThatEndsAboveALevelHasNoEaseThere() {
    const Quantity hip = named(quantitiesOf(shirt()), "hipEase");
    QVERIFY(!hip.value);
    QCOMPARE(hip.whyAbsent, std::string("The garment does not go round the body there."));
}

void tst_Quantities::aHemThatIsCutByALevelHasNoEaseThere() {
    auto hem = tubes::ring({0, 0.98, 0}, 0.13, around);
    for (Vec3& p : hem) p.y += 0.5 * p.z; // the waist lies between its back and its front
    const auto all = quantitiesOf(tubeThrough({hem, tubes::ring({0, 1.45, 0}, 0.13, around)}));
    QCOMPARE(named(all, "waistEase").whyAbsent, std::string("The garment is open there."));
    QVERIFY(named(all, "bustEase").value);
}

void tst_Quantities::aSlantedHemIsHigherOnOneSide() {
    auto hem = tubes::ring({0, 0.6, 0}, 0.2, around);
    for (Vec3& p : hem) p.y += 0.1 * p.x + 0.3 * p.z;
    const auto all = quantitiesOf(tubeThrough({hem, tubes::ring({0, 1.45, 0}, 0.13, around)}));
    QVERIFY(isNear(valueOf(all, "hemFront"), 0.66, 1e-4)); // a chord lies inside the circle by 0.1 mm
    QVERIFY(isNear(valueOf(all, "hemBack"), 0.54, 1e-4));
    QVERIFY(isNear(valueOf(all, "hemLeft"), 0.62, 1e-4));
    QVERIFY(isNear(valueOf(all, "hemRight"), 0.58, 1e-4));
    QCOMPARE(valueOf(all, "hemFolds"), 0.0);
}

void tst_Quantities::foldsAreCounted_data() {
    QTest::addColumn<int>("waves");
    QTest::addColumn<double>("swing");
    QTest::addColumn<double>("folds");
    QTest::newRow("a round hem has none") << 6 << 0.0 << 0.0;
    QTest::newRow("four deep folds") << 4 << 0.04 << 4.0;
    QTest::newRow("seven folds") << 7 << 0.02 << 7.0;
    QTest::newRow("twelve folds") << 12 << 0.01 << 12.0;
    QTest::newRow("ripples of 2 mm are none") << 9 << 0.001 << 0.0;
}

void tst_Quantities::foldsAreCounted() {
    QFETCH(int, waves);
    QFETCH(double, swing);
    QFETCH(double, folds);
    const auto all = quantitiesOf(tubeThrough({wavy(waves, swing), tubes::ring({0, 1.45, 0}, 0.13, around)}));
    QCOMPARE(valueOf(all, "hemFolds"), folds);
}

void tst_Quantities::aTubeOnTheSkinTouchesWithAllItsArea() {
    // The lower half lies on the body, the upper half 30 mm off it; of the band between, the lower corners do.
    const auto skin = [](double y) { return tubes::ring({0, y, 0}, 0.103, around); };
    const auto drape = tubeThrough(
        {skin(0.6), skin(0.8), tubes::ring({0, 0.8, 0}, 0.13, around), tubes::ring({0, 1.45, 0}, 0.13, around)});
    const double onTheBody = 2 * std::numbers::pi * 0.103 * 0.2,
                 between = std::numbers::pi * (0.13 * 0.13 - 0.103 * 0.103);
    // Of two triangles between corners that touch and corners that do not, one has two of the former and one has one.
    const double shareOfBetween = (2.0 / 3 * 0.103 + 1.0 / 3 * 0.13) / (0.103 + 0.13);
    QVERIFY(
        isNear(valueOf(quantitiesOf(drape), "contactArea"), polygon * (onTheBody + shareOfBetween * between), 2e-4));
    QVERIFY(isNear(valueOf(quantitiesOf(shirt()), "contactArea"), 0, 1e-12));
}

void tst_Quantities::aHigherNecklineIsFartherFromTheNape() {
    for (const double height : {1.45, 1.47}) {
        const auto all = quantitiesOf(
            tubeThrough({tubes::ring({0, 0.9, 0}, 0.13, around), tubes::ring({0, height, 0}, 0.1, around)}));
        QVERIFY(isNear(valueOf(all, "napeDistance"), height - 1.45, 1e-4));
    }
}

void tst_Quantities::theShoulderIsWhereItsSeamEnds() {
    // Front and back meet along the sides; on the upper border these seams end beside the acromion.
    simulation::Drape drape =
        tubeThrough({tubes::ring({0, 0.9, 0}, 0.13, around), tubes::ring({0, 1.42, 0}, 0.13, around)});
    for (std::size_t t = 0; t < drape.triangles.size(); ++t) {
        const auto& [a, b, c] = drape.triangles[t];
        drape.piece[t] = drape.positions[a].z + drape.positions[b].z + drape.positions[c].z > 0;
    }
    const auto all = quantitiesOf(drape);
    QVERIFY(isNear(valueOf(all, "shoulderHeight"), 1.42, 1e-9));
    QVERIFY(isNear(valueOf(all, "shoulderDistance"), 0.26, 2e-3)); // the nearest nodes to the side: within 4°
    QCOMPARE(named(quantitiesOf(shirt()), "shoulderHeight").whyAbsent, std::string("No seam ends at the shoulders."));
}

void tst_Quantities::aSkirtHasAHemAndNoNeck() {
    const auto all = quantitiesOf(tubeThrough({wavy(5, 0.03, 0.4), tubes::ring({0, 1.0, 0}, 0.101, around)}));
    QCOMPARE(valueOf(all, "hemFolds"), 5.0);
    QVERIFY(isNear(valueOf(all, "hemFront"), 0.4, 1e-9));
    QCOMPARE(named(all, "napeDistance").whyAbsent, std::string("No opening goes round the neck."));
}

void tst_Quantities::aWaistbandAloneIsNoHem() {
    // Trousers' upper border, and below it a cloth that is closed: the legs are another matter.
    simulation::Drape drape =
        tubeThrough({tubes::ring({0, 0.6, 0}, 0.13, around), tubes::ring({0, 1.0, 0}, 0.11, around)});
    drape.positions.push_back({0.3, 0.6, 0}); // the lower border runs to a point beside the trunk
    const int point = static_cast<int>(drape.positions.size()) - 1;
    for (int i = 0; i < around; ++i) {
        drape.triangles.push_back({(i + 1) % around, i, point});
        drape.piece.push_back(0);
    }
    drape.start = drape.positions;
    const auto all = quantitiesOf(drape);
    QVERIFY(!named(all, "hemFront").value);
    QVERIFY(named(all, "hemFolds").whyAbsent.starts_with("No hem goes round the body"));
}

void tst_Quantities::aGarmentWithLimbsInItIsNotToldAsHanging() {
    for (const char* key : {"lowestPoint", "meanHeight", "shadowArea", "borderFolds"}) {
        const Quantity quantity = named(quantitiesOf(shirt()), key);
        QVERIFY(!quantity.value);
        QCOMPARE(quantity.whyAbsent, std::string("It is worn: hem and ease tell."));
    }
}

void tst_Quantities::clothOnNothingIsToldByHeightShadowAndFolds() {
    // A cone open below, from a small ring to a wavy border: it covers the wave's own area but for the hole.
    constexpr int waves = 6;
    constexpr double swing = 0.02, hole = 0.01;
    const auto drape = tubeThrough({wavy(waves, swing), tubes::ring({0, 1.1, 0}, hole, around)});
    const auto all = study::quantitiesOf({drape, nullptr, nullptr, {}, {.warpPercentile95 = 0.01}});
    QCOMPARE(valueOf(all, "lowestPoint"), 0.5);
    QCOMPARE(valueOf(all, "borderFolds"), double(waves));
    const double wave = std::numbers::pi * (0.25 * 0.25 + swing * swing / 2), ring = std::numbers::pi * hole * hole;
    QVERIFY(isNear(valueOf(all, "shadowArea"), wave - ring, 2e-3 * wave)); // 96 chords
    QVERIFY(!named(all, "contactArea").value);
    QCOMPARE(named(all, "hemFront").whyAbsent, std::string("There is no body with limbs."));
    QCOMPARE(valueOf(all, "warpStrain"), 0.01);
}

void tst_Quantities::theMeanHeightIsThatOfTheArea() {
    // A cone's area grows with its radius: from r at the top to R below, its mean lies (R + 2 r) / (3 (R + r)) up.
    constexpr double above = 0.1, below = 0.2;
    const auto drape = tubeThrough({tubes::ring({0, 0.4, 0}, below, around), tubes::ring({0, 1, 0}, above, around)});
    const auto all = study::quantitiesOf({drape, nullptr, nullptr, {}, {}});
    QVERIFY(isNear(valueOf(all, "meanHeight"), 0.4 + 0.6 * (below + 2 * above) / (3 * (below + above)), 1e-3));
}

void tst_Quantities::clothThatCoversItselfCastsOneShadow() {
    const auto once = tubeThrough({tubes::ring({0, 1, 0}, 0.2, around), tubes::ring({0, 1, 0}, 0.1, around)});
    simulation::Drape twice = once; // the same ring below it, and an upright sheet that shows its edge alone
    const int offset = static_cast<int>(once.positions.size());
    for (const Vec3& p : once.positions) twice.positions.push_back({p.x, p.y - 0.1, p.z});
    for (const auto& [a, b, c] : once.triangles) twice.triangles.push_back({a + offset, b + offset, c + offset});
    twice.triangles.push_back({0, around / 2, offset});
    twice.piece.resize(twice.triangles.size(), 0);
    const auto shadow = [](const simulation::Drape& drape) {
        return valueOf(study::quantitiesOf({drape, nullptr, nullptr, {}, {}}), "shadowArea");
    };
    QVERIFY(isNear(shadow(once), std::numbers::pi * 0.03, 3e-4));
    QVERIFY(isNear(shadow(twice), shadow(once), 4e-4)); // 0.2 m of edge between squares of 2 mm
}

/// V24: a tube of 95 mm radius, sewn round a cylinder of 100 mm and its skin of 3 mm, is stretched round it.
void tst_Quantities::strainIsThatOfTheHoop() {
    const samples::TubeScene tube{.spacing = 0.01}; // chords are shorter than arcs by 0.05 %
    const auto document = samples::tubeRoundCylinder(tube);
    body::Body cylinder{"cylinder", samples::cylinderMesh(), {}, {}};
    auto simulation =
        simulation::Simulation::create({document.pattern, Shared<body::Body>(std::move(cylinder)), document.scene});
    QVERIFY(simulation);
    const auto report = simulation::sew(*simulation, {});
    QVERIFY(report && report->atRest);
    const auto all = study::quantitiesOf(*simulation);
    std::vector<double> radii;
    for (const Vec3& p : simulation->state().positions) radii.push_back(std::hypot(p.x, p.z));
    std::ranges::sort(radii);
    const double expected = radii[radii.size() / 2] / tube.restRadius - 1; // 8.6 %
    QVERIFY2(isNear(valueOf(all, "weftStrain"), expected, 0.01 * expected),
             qPrintable(QString("%1 instead of %2").arg(valueOf(all, "weftStrain")).arg(expected)));
    QVERIFY(std::abs(valueOf(all, "shear")) < 0.002);
}

TOILE_TEST(tst_Quantities)
#include "tst_Quantities.moc"
