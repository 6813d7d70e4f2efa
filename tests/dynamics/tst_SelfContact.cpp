// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/dynamics/Energy.h"
#include "tests/Suite.h"
#include "tests/dynamics/Constants.h"
#include "tests/dynamics/LayeredCloth.h"

#include <QTest>
#include <numbers>

using namespace toile;
using namespace toile::layers;
using dynamics::SelfContact;
using dynamics::Stage;

namespace {

/// A small sheet at some height over a larger one that is pinned everywhere at y = 0.
Cloth sheetOver(double height, double friction = 0.3) {
    Cloth cloth;
    append(cloth, 0.3, 30, 0.3, 30, friction, [](const Vec2& m) { return Vec3{m.x - 0.15, 0, 0.15 - m.y}; });
    pin(cloth, 0, cloth.model.particleCount());
    append(cloth, 0.1, 10, 0.1, 10, friction, level(height));
    return cloth;
}

double meanX(const Cloth& cloth) {
    double sum = 0;
    int count = 0;
    for (int p = static_cast<int>(cloth.model.pinned.size()); p < cloth.model.particleCount(); ++p, ++count)
        sum += cloth.state.positions[p].x;
    return sum / count;
}

/// Two sheets that overlap by a cell and a half at their borders, and slope through each other.
Cloth crossedSheets() {
    Cloth cloth;
    append(cloth, 0.1, 10, 0.1, 10, 0.3, [](const Vec2& m) { return Vec3{m.x - 0.1, 0.1 * (m.x - 0.09), -m.y}; });
    append(cloth, 0.1, 10, 0.1, 10, 0.3, [](const Vec2& m) {
        return Vec3{m.x - 0.015, -0.1 * (m.x - 0.008), -0.003 - m.y};
    });
    return cloth;
}

struct Run {
    Cloth& cloth;
    SelfContact contact;
    dynamics::Xpbd xpbd;
    explicit Run(Cloth& c, double damping = 0)
        : cloth(c), contact(c.model, c.surface), xpbd(c.model, {.damping = damping}) {}
    void frames(int count, const Vec3& pull, int substeps = 20) {
        std::array<Stage*, 1> stages{&contact};
        for (int f = 0; f < count; ++f)
            if (const auto done = xpbd.step(cloth.state, frame, substeps, pull, stages); !done)
                qFatal("%s", toString(done.error()).c_str());
    }
};

} // namespace

/// Layers of one cloth in position-based substeps.
class tst_SelfContact : public QObject {
    Q_OBJECT
private slots:
    void aSheetComesToRestOneThicknessAboveAnother();
    void noSpeedPassesThrough_data();
    void noSpeedPassesThrough();
    void belowTheAngleOfFrictionASheetSticks();
    void aboveItItSlidesAsTheConeSays();
    void whatIsApartIsNotTouched();
    void aMeshFinerThanTheClothIsThickStaysFlat();
    void momentumIsKeptWhenLayersMeet();
    void layersThatHaveCrossedAreDrawnApart();
    void whatHasGoneStraightThroughComesBack();
    void crossedPiecesGoToTheSidesOfTheirLayers_data();
    void crossedPiecesGoToTheSidesOfTheirLayers();
    void whatASeamWillBringTogetherIsNotPushed();
    void piecesThatPassAreLetThrough();
    void slavesOfTwoRegionsAreHeldToo();
    void whatPushesASlaveIsNotAddedUp();
    void equalStartsGiveEqualBits();
};

void tst_SelfContact::aSheetComesToRestOneThicknessAboveAnother() {
    Cloth cloth = sheetOver(0.003);
    Run run(cloth, 5);
    run.frames(60, gravity);
    QCOMPARE(cloth.intersections(), 0);
    for (int p = static_cast<int>(cloth.model.pinned.size()); p < cloth.model.particleCount(); ++p) {
        // A substep of gravity is 7 µm.
        QVERIFY(std::abs(cloth.state.positions[p].y - thickness) < 1e-5);
        QVERIFY(length(cloth.state.velocities[p]) < 1e-3);
    }
}

void tst_SelfContact::noSpeedPassesThrough_data() {
    QTest::addColumn<double>("speed");
    for (const double speed : {1.0, 10.0, 100.0}) QTest::addRow("%g m/s", speed) << speed;
}

void tst_SelfContact::noSpeedPassesThrough() {
    QFETCH(double, speed);
    Cloth cloth = sheetOver(0.02);
    for (std::size_t p = cloth.model.pinned.size(); p < cloth.state.positions.size(); ++p)
        cloth.state.velocities[p] = {0.1 * speed, -speed, 0};
    Run run(cloth);
    for (int f = 0; f < 10; ++f) {
        run.frames(1, gravity);
        QCOMPARE(cloth.intersections(), 0);
        QVERIFY(lowest(cloth) > 0);
    }
}

void tst_SelfContact::belowTheAngleOfFrictionASheetSticks() {
    Cloth cloth = sheetOver(thickness, 0.5);
    Run run(cloth);
    const double angle = 0.9 * std::atan(0.5);
    run.frames(5, {0, -9.81, 0});
    const double before = meanX(cloth);
    run.frames(60, {9.81 * std::sin(angle), -9.81 * std::cos(angle), 0});
    QVERIFY2(std::abs(meanX(cloth) - before) < 1e-3, qPrintable(QString::number(meanX(cloth) - before)));
}

void tst_SelfContact::aboveItItSlidesAsTheConeSays() {
    Cloth cloth = sheetOver(thickness, 0.2);
    Run run(cloth);
    const double angle = 0.5, time = 0.25;
    run.frames(15, {9.81 * std::sin(angle), -9.81 * std::cos(angle), 0});
    const double expected = 0.5 * 9.81 * (std::sin(angle) - 0.2 * std::cos(angle)) * time * time;
    // Layers touch at corners and edges, whose shortest ways are not quite upright: a tenth.
    QVERIFY2(std::abs(meanX(cloth) - expected) < 0.1 * expected, qPrintable(QString::number(meanX(cloth) / expected)));
}

void tst_SelfContact::whatIsApartIsNotTouched() {
    Cloth cloth = sheetOver(0.1), free = cloth;
    Run run(cloth);
    run.frames(3, gravity);
    dynamics::Xpbd xpbd(free.model, {.damping = 0});
    for (int f = 0; f < 3; ++f) QVERIFY(xpbd.step(free.state, frame, 20, gravity, {}));
    QVERIFY(cloth.state.positions == free.state.positions);
    QVERIFY(run.contact.searches() <= 3); // once a frame step: the ways are foreseen, all but what gravity adds
    QCOMPARE(run.contact.nearPairs(), std::size_t(0));
}

void tst_SelfContact::aMeshFinerThanTheClothIsThickStaysFlat() {
    Cloth cloth;
    append(cloth, 0.004, 16, 0.004, 16, 0.3, level(0)); // 0.25 mm cells
    const std::vector<Vec3> before = cloth.state.positions;
    Run run(cloth);
    run.frames(5, {});
    for (std::size_t p = 0; p < before.size(); ++p)
        QVERIFY(geometry::distance(before[p], cloth.state.positions[p]) < 1e-9);
}

void tst_SelfContact::momentumIsKeptWhenLayersMeet() {
    Cloth cloth;
    append(cloth, 0.1, 10, 0.1, 10, 0.4, level(0, 0));
    append(cloth, 0.1, 10, 0.1, 10, 0.4, level(0.005));
    const int half = cloth.model.particleCount() / 2;
    for (int p = half; p < 2 * half; ++p) cloth.state.velocities[p] = {0.3, -1, 0.2};
    const auto momentum = [&] {
        Vec3 sum;
        for (int p = 0; p < 2 * half; ++p) sum += cloth.model.mass[p] * cloth.state.velocities[p];
        return sum;
    };
    const Vec3 before = momentum();
    Run run(cloth);
    run.frames(10, {}, 100); // 0.2 mm a substep: pushing is enough, no way is shortened
    QVERIFY(cloth.state.velocities[0] != Vec3{});
    QVERIFY2(length(momentum() - before) < 1e-9 * length(before),
             qPrintable(QString::number(length(momentum() - before) / length(before))));
    QCOMPARE(cloth.intersections(), 0);
}

void tst_SelfContact::layersThatHaveCrossedAreDrawnApart() {
    Cloth cloth = crossedSheets();
    QVERIFY(cloth.intersections() > 10);
    Run run(cloth, 10);
    std::array<Stage*, 1> stages{&run.contact};
    QVERIFY(run.xpbd.step(cloth.state, frame / 20, 1, {}, stages));
    QVERIFY(run.contact.crossings() > 0 && !run.contact.guaranteed());
    for (const Vec3& place : run.contact.crossingPlaces(cloth.state.positions))
        QVERIFY(std::abs(place.x + 0.0075) < 0.03 && std::abs(place.y) < 0.01); // where the sheets overlap
    run.frames(120, {});
    QCOMPARE(cloth.intersections(), 0);
    QCOMPARE(run.contact.crossings(), 0);
    QVERIFY(run.contact.guaranteed() && run.contact.crossingPlaces(cloth.state.positions).empty());
}

/// The line of the crossing is as long wherever the upright sheet stands in the level one.
void tst_SelfContact::whatHasGoneStraightThroughComesBack() {
    Cloth cloth;
    append(cloth, 0.2, 10, 0.2, 10, 0.3, [](const Vec2& m) { return Vec3{m.x - 0.1, 0, 0.1 - m.y}; });
    pin(cloth, 0, cloth.model.particleCount());
    append(cloth, 0.1, 10, 0.1, 10, 0.3, [](const Vec2& m) { return Vec3{m.x - 0.05, m.y - 0.035, 0.003}; });
    QVERIFY(cloth.intersections() > 10);
    Run run(cloth, 2);
    run.frames(60, {});
    QCOMPARE(cloth.intersections(), 0);
    QVERIFY(run.contact.guaranteed() && lowest(cloth) > 0); // not the other way, which is longer
}

void tst_SelfContact::crossedPiecesGoToTheSidesOfTheirLayers_data() {
    QTest::addColumn<int>("left");
    QTest::addColumn<int>("right");
    QTest::addColumn<bool>("leftTurned");
    QTest::addColumn<bool>("leftAbove");
    QTest::newRow("left over right") << 1 << 0 << false << true;
    QTest::newRow("right over left") << 0 << 3 << false << false;
    QTest::newRow("left over right, face to face") << 1 << 0 << true << true;
    QTest::newRow("right over left, whose right side looks down") << 0 << 1 << true << true;
}

void tst_SelfContact::crossedPiecesGoToTheSidesOfTheirLayers() {
    QFETCH(int, left);
    QFETCH(int, right);
    QFETCH(bool, leftTurned);
    QFETCH(bool, leftAbove);
    Cloth cloth = crossedSheets(); // their right sides look upwards
    const std::size_t half = cloth.surface.triangles.size() / 2;
    if (leftTurned)
        for (std::size_t t = 0; t < half; ++t) std::swap(cloth.surface.triangles[t][0], cloth.surface.triangles[t][1]);
    cloth.surface.layers.assign(half, left);
    cloth.surface.layers.resize(2 * half, right);
    Run run(cloth, 10);
    run.frames(120, {});
    QCOMPARE(cloth.intersections(), 0);
    QVERIFY(run.contact.guaranteed());
    const auto heightOf = [&](int first, int last) { // mean of what lies in the overlap
        double sum = 0;
        int count = 0;
        for (int p = first; p < last; ++p)
            if (const Vec3& x = cloth.state.positions[p]; x.x > -0.012 && x.x < -0.003) sum += x.y, ++count;
        return sum / count;
    };
    const int middle = cloth.model.particleCount() / 2, all = cloth.model.particleCount();
    QVERIFY((heightOf(0, middle) > heightOf(middle, all)) == leftAbove);
}

void tst_SelfContact::whatASeamWillBringTogetherIsNotPushed() {
    Cloth cloth = sheetOver(0.0002);
    const std::vector<Vec3> before = cloth.state.positions;
    cloth.surface.becomes.assign(before.size(), 0);
    Run run(cloth);
    run.frames(2, {});
    for (std::size_t p = 0; p < before.size(); ++p)
        QVERIFY(geometry::distance(before[p], cloth.state.positions[p]) < 1e-9);
}

/// Two sheets are thrown at one that is held: one passes as if it were alone, the other is stopped.
void tst_SelfContact::piecesThatPassAreLetThrough() {
    Cloth cloth;
    append(cloth, 0.3, 30, 0.3, 30, 0.3, [](const Vec2& m) { return Vec3{m.x - 0.15, 0, 0.15 - m.y}; });
    pin(cloth, 0, cloth.model.particleCount());
    std::vector<std::size_t> firstTriangle{0, cloth.surface.triangles.size()};
    std::vector<int> firstParticle{0, cloth.model.particleCount()};
    for (const double x : {-0.14, 0.04}) {
        append(cloth, 0.1, 10, 0.1, 10, 0.3, [=](const Vec2& m) { return Vec3{x + m.x, 0.02, 0.05 - m.y}; });
        firstTriangle.push_back(cloth.surface.triangles.size());
        firstParticle.push_back(cloth.model.particleCount());
    }
    for (int piece = 0; piece < 3; ++piece) cloth.surface.pieces.resize(firstTriangle[piece + 1], piece);
    for (int p = firstParticle[1]; p < firstParticle[3]; ++p) cloth.state.velocities[p] = {0, -2, 0};
    Cloth free = cloth;
    cloth.surface.passing = {{0, 1}};
    Run run(cloth);
    run.frames(3, {});
    QVERIFY(!run.contact.guaranteed());
    QCOMPARE(run.contact.crossings(), 0); // that are to be drawn apart
    dynamics::Xpbd xpbd(free.model, {.damping = 0});
    for (int f = 0; f < 3; ++f) QVERIFY(xpbd.step(free.state, frame, 20, {}, {}));
    for (int p = firstParticle[1]; p < firstParticle[2]; ++p)
        QVERIFY(cloth.state.positions[p] == free.state.positions[p] && cloth.state.positions[p].y < -0.05);
    for (int p = firstParticle[2]; p < firstParticle[3]; ++p) QVERIFY(cloth.state.positions[p].y > 0);
}

void tst_SelfContact::slavesOfTwoRegionsAreHeldToo() {
    Cloth cloth = sheetThrownAtTwoRegions(3);
    QCOMPARE(cloth.intersections(), 0);
    const std::vector<Vec3> before = cloth.state.velocities;
    QVERIFY(!cloth.model.slaves.empty());
    Run run(cloth);
    for (int f = 0; f < 10; ++f) {
        run.frames(1, {});
        QCOMPARE(cloth.intersections(), 0);
        QVERIFY(farthestSlave(cloth) < 1e-12);
    }
    QVERIFY(cloth.state.velocities.back() != before.back()); // of the sheet that was at rest
}

/// Two triangles with a slave between them come down on a pinned sheet of small cells: what one of its edges has pushed
/// away is not pushed by the others again, though it is not the slave that they move but its masters.
void tst_SelfContact::whatPushesASlaveIsNotAddedUp() {
    constexpr double duration = frame / 20, high = 2 * thickness, low = 0.2 * thickness;
    Cloth cloth;
    append(cloth, 0.01, 10, 0.01, 10, 0.3, [](const Vec2& m) { return Vec3{m.x - 0.0052, 0, 0.0053 - m.y}; });
    const int below = cloth.model.particleCount(), a = below, b = below + 1, c = below + 2, slave = below + 3;
    for (const Vec3& place : {Vec3{0, high, -0.004}, Vec3{0, high, 0.004}, Vec3{0.004, high, 0}, Vec3{0, high, 0}}) {
        cloth.state.positions.push_back(place);
        cloth.model.mass.push_back(1e-6);
        cloth.surface.halfThickness.push_back(thickness / 2);
        cloth.surface.friction.push_back(0.3);
        cloth.surface.room.push_back(0.004);
    }
    cloth.model.mass[slave] = 0;
    cloth.model.slaves.push_back({slave, {{a, 0.5}, {b, 0.5}}});
    cloth.surface.triangles.push_back({a, slave, c});
    cloth.surface.triangles.push_back({slave, b, c});
    std::vector<double> inverseMass(below, 0.0);
    inverseMass.insert(inverseMass.end(), {1e6, 1e6, 1e6, 0.5e6});
    std::vector<Vec3> places = cloth.state.positions;
    for (int p = below; p <= slave; ++p) places[p].y = low;

    SelfContact contact(cloth.model, cloth.surface);
    contact.beginStep(cloth.state, frame);
    dynamics::Substep substep{places, cloth.state.positions, inverseMass, duration, duration};
    contact.project(substep);
    for (int p = below; p <= slave; ++p)
        QVERIFY2(places[p].y > 0.9 * thickness && places[p].y < 1.5 * thickness,
                 qPrintable(QString("%1: %2").arg(p).arg(places[p].y)));
}

void tst_SelfContact::equalStartsGiveEqualBits() {
    Cloth one = sheetOver(0.004), two = one;
    Run first(one), second(two);
    first.frames(10, gravity);
    second.frames(10, gravity);
    QVERIFY(one.state.positions == two.state.positions);
}

TOILE_TEST(tst_SelfContact)
#include "tst_SelfContact.moc"
