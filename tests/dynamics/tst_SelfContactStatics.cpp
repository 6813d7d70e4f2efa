// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/dynamics/Statics.h"
#include "tests/Suite.h"
#include "tests/dynamics/DenseSink.h"
#include "tests/dynamics/LayeredCloth.h"

#include <QTest>
#include <limits>
#include <random>

using namespace toile;
using namespace toile::layers;
using dynamics::SelfContact;

namespace {

Vec3 randomStep(std::mt19937& random, double size) {
    std::uniform_real_distribution<double> any(-size, size);
    return {any(random), any(random), any(random)};
}

/// Two cells of 10 mm one above the other, at a part of their thickness, the upper one turned by an angle and moved
/// aside.
Cloth turnedCells(double height, double angle, double aside = 0.002) {
    Cloth cloth;
    append(cloth, 0.01, 1, 0.01, 1, 0.3, [](const Vec2& m) { return Vec3{m.x, 0, -m.y}; });
    append(cloth, 0.01, 1, 0.01, 1, 0.3, [&](const Vec2& m) {
        const Vec2 p = geometry::rotated(m, angle);
        return Vec3{p.x + aside, height, -p.y};
    });
    return cloth;
}

/// The same, shaken a little.
Cloth pressedCells(double height, std::mt19937& random, double angle = 0.4) {
    Cloth cloth = turnedCells(height, angle);
    for (Vec3& p : cloth.state.positions) p += randomStep(random, 2e-5);
    return cloth;
}

std::vector<Vec3> forcesOn(Cloth& cloth) {
    SelfContact contact(cloth.model, cloth.surface);
    contact.beginIteration(cloth.state.positions);
    std::vector<Vec3> forces(cloth.state.positions.size());
    contact.addForces(cloth.state.positions, forces);
    return forces;
}

/// With friction by the forces of the potential: what the first look finds is that of substeps before, of which there
/// were none.
void begin(SelfContact& contact, const std::vector<Vec3>& x) {
    contact.fixFriction(x);
    contact.fixFriction(x);
    contact.beginIteration(x);
}

double largestOf(const std::vector<Vec3>& forces) {
    double largest = 0;
    for (const Vec3& f : forces) largest = std::max(largest, length(f));
    return largest;
}

} // namespace

/// Self-contact as a potential: what Newton's method sees of it.
class tst_SelfContactStatics : public QObject {
    Q_OBJECT
private slots:
    void theForceIsMinusTheGradientOfTheEnergy_data();
    void theForceIsMinusTheGradientOfTheEnergy();
    void edgesThatPassThroughParallelAreNoKink();
    void theEnergyIsOneFunctionUntilFrictionIsFixedAgain();
    void theForcesSumToZero();
    void theHessianIsTheCurvatureAcrossTheLayersAndNeverNegative();
    void theEnergyIsInfiniteWhereLayersWouldCross();
    void layersThatSubstepsPressedToTheLeastDistanceCanMove();
    void layersThatSubstepsPressedToTheLeastDistanceCanTilt();
    void frictionGoesPartOfTheWayToTheForcesOfHere();
    void aSheetComesToRestOnAnother();
};

void tst_SelfContactStatics::theForceIsMinusTheGradientOfTheEnergy_data() {
    QTest::addColumn<double>("angle");
    QTest::addRow("askew") << 0.4;
    QTest::addRow("edges nearly parallel") << 0.015;
}

void tst_SelfContactStatics::theForceIsMinusTheGradientOfTheEnergy() {
    QFETCH(const double, angle);
    std::mt19937 random(5);
    for (int n = 0; n < 20; ++n) {
        Cloth cloth = pressedCells(0.7 * thickness, random, angle);
        SelfContact contact(cloth.model, cloth.surface);
        std::vector<Vec3> x = cloth.state.positions;
        begin(contact, x);
        for (Vec3& p : x) p += randomStep(random, n % 2 ? 2e-5 : 1e-4); // sticking and slipping
        std::vector<Vec3> forces(x.size());
        contact.addForces(x, forces);
        const double largest = largestOf(forces);
        QVERIFY(largest > 0);
        for (std::size_t i = 0; i < x.size(); ++i)
            for (int axis = 0; axis < 3; ++axis) {
                constexpr double step = 1e-8;
                auto more = x, less = x;
                more[i][axis] += step;
                less[i][axis] -= step;
                const double slope = (contact.energy(more) - contact.energy(less)) / (2 * step);
                // Central differences; the force turns by a part in 10⁴ where the nearest parts of two
                // elements change.
                QVERIFY(std::abs(forces[i][axis] + slope) < 1e-3 * largest);
            }
    }
}

/// The nearest points of two edges leap from end to end there.
void tst_SelfContactStatics::edgesThatPassThroughParallelAreNoKink() {
    Cloth one = turnedCells(0.5 * thickness, -1e-6), other = turnedCells(0.5 * thickness, 1e-6);
    const std::vector<Vec3> before = forcesOn(one), after = forcesOn(other);
    QVERIFY(largestOf(before) > 0);
    for (std::size_t p = 0; p < before.size(); ++p)
        QVERIFY2(geometry::distance(before[p], after[p]) < 0.01 * largestOf(before),
                 qPrintable(QString::number(geometry::distance(before[p], after[p]) / largestOf(before))));
}

/// Else Newton would take for a bad step what is a change of the question.
void tst_SelfContactStatics::theEnergyIsOneFunctionUntilFrictionIsFixedAgain() {
    std::mt19937 random(9);
    Cloth cloth = pressedCells(0.7 * thickness, random);
    SelfContact contact(cloth.model, cloth.surface);
    std::vector<Vec3> x = cloth.state.positions;
    begin(contact, x);
    for (int iteration = 0; iteration < 5; ++iteration) {
        for (Vec3& p : x) p += randomStep(random, 2e-5);
        const double energy = contact.energy(x);
        QVERIFY(energy > 0);
        contact.beginIteration(x);
        QVERIFY(std::abs(contact.energy(x) - energy) < 1e-12 * energy);
    }
    const double before = contact.energy(x);
    contact.fixFriction(x);
    QVERIFY(std::abs(contact.energy(x) - before) > 1e-6 * before);
}

void tst_SelfContactStatics::theForcesSumToZero() {
    std::mt19937 random(6);
    Cloth cloth = pressedCells(0.5 * thickness, random);
    SelfContact contact(cloth.model, cloth.surface);
    contact.beginIteration(cloth.state.positions);
    std::vector<Vec3> forces(cloth.state.positions.size());
    contact.addForces(cloth.state.positions, forces);
    Vec3 sum;
    double size = 0;
    for (const Vec3& f : forces) {
        sum += f;
        size += length(f);
    }
    QVERIFY(size > 0 && length(sum) < 1e-12 * size);
    for (int p = 0; p < 4; ++p) QVERIFY(forces[p].y <= 0 && forces[p + 4].y >= 0); // apart
}

void tst_SelfContactStatics::theHessianIsTheCurvatureAcrossTheLayersAndNeverNegative() {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> any(-1, 1);
    for (int n = 0; n < 20; ++n) {
        Cloth cloth = pressedCells(0.7 * thickness, random);
        SelfContact contact(cloth.model, cloth.surface);
        const std::vector<Vec3>& x = cloth.state.positions;
        begin(contact, x);
        fixtures::DenseSink sink(static_cast<int>(x.size()));
        contact.addHessian(x, sink);
        std::vector<double> v(3 * x.size());
        for (double& value : v) value = any(random);
        QVERIFY(sink.quadratic(v) >= 0);

        std::vector<double> apart(3 * x.size(), 0); // the upper cell moved up as a whole: ways turn nowhere
        for (int p = 4; p < 8; ++p) apart[3 * p + 1] = 1;
        constexpr double step = 1e-7;
        auto more = x, less = x;
        for (int p = 4; p < 8; ++p) more[p].y += step, less[p].y -= step;
        const double curvature = (contact.energy(more) - 2 * contact.energy(x) + contact.energy(less)) / (step * step);
        QVERIFY2(std::abs(sink.quadratic(apart) - curvature) < 0.05 * curvature,
                 qPrintable(QString("%1 %2").arg(sink.quadratic(apart)).arg(curvature)));
    }
}

void tst_SelfContactStatics::theEnergyIsInfiniteWhereLayersWouldCross() {
    std::mt19937 random(8);
    Cloth cloth = pressedCells(2 * thickness, random);
    SelfContact contact(cloth.model, cloth.surface);
    contact.beginIteration(cloth.state.positions);
    QCOMPARE(contact.energy(cloth.state.positions), 0.0);
    auto x = cloth.state.positions;
    for (int p = 4; p < 8; ++p) x[p].y -= 1.5 * thickness;
    QVERIFY(contact.energy(x) > 0 && std::isfinite(contact.energy(x)));
    for (int p = 4; p < 8; ++p) x[p].y -= thickness;
    QCOMPARE(contact.energy(x), std::numeric_limits<double>::infinity());
}

/// Of many that are, some come nearer where others part.
void tst_SelfContactStatics::layersThatSubstepsPressedToTheLeastDistanceCanMove() {
    const double least = dynamics::SelfContactSettings{}.closest;
    Cloth cloth = turnedCells(least, 0.4);
    SelfContact contact(cloth.model, cloth.surface);
    contact.beginIteration(cloth.state.positions);
    const double before = contact.energy(cloth.state.positions);
    QVERIFY(before > 0);
    auto x = cloth.state.positions;
    for (int p = 4; p < 8; ++p) x[p].y = 0.2 * least;
    QVERIFY(contact.energy(x) > before && std::isfinite(contact.energy(x)));
    for (int p = 4; p < 8; ++p) x[p].y = 0.05 * least;
    QCOMPARE(contact.energy(x), std::numeric_limits<double>::infinity());
}

/// By more than their distance, where no plane between them would do for the start and the end of the way.
void tst_SelfContactStatics::layersThatSubstepsPressedToTheLeastDistanceCanTilt() {
    const double least = dynamics::SelfContactSettings{}.closest, slope = 500 * least; // [1/m]
    Cloth cloth = turnedCells(least, 0.1, 0.0095); // over a border of the lower, and on beyond it
    SelfContact contact(cloth.model, cloth.surface);
    contact.beginIteration(cloth.state.positions);
    const auto tilted = [&](double height) { // over the border of the lower cell, lower at the far end
        auto x = cloth.state.positions;
        for (int p = 4; p < 8; ++p) x[p].y = height - slope * (x[p].x - 0.01);
        return x;
    };
    const std::vector<Vec3> apart = tilted(0.9 * least), through = tilted(-0.1 * least);
    QVERIFY(apart[5].y < -3 * least);
    QVERIFY(std::isfinite(contact.energy(apart)));
    QCOMPARE(contact.energy(through), std::numeric_limits<double>::infinity());
}

/// The upper cell is let go a little and moved aside.
void tst_SelfContactStatics::frictionGoesPartOfTheWayToTheForcesOfHere() {
    Cloth cloth = turnedCells(0.5 * thickness, 0.4);
    std::vector<Vec3> less = cloth.state.positions;
    for (int p = 4; p < 8; ++p) less[p].y += 0.1 * thickness;
    std::vector<Vec3> aside = less;
    for (int p = 4; p < 8; ++p) aside[p].x += 1e-5;
    const auto frictionAfter = [&](auto ease) {
        SelfContact contact(cloth.model, cloth.surface);
        begin(contact, cloth.state.positions);
        ease(contact);
        return contact.energy(aside) - contact.energy(less);
    };
    const auto going = [&](double part) {
        return frictionAfter([&](SelfContact& contact) {
            contact.fixFriction(less);
            contact.easeFriction(part);
        });
    };
    const double before = frictionAfter([](SelfContact&) {}), none = going(0), whole = going(1);
    QVERIFY(whole > 0 && before > 1.2 * whole);
    QVERIFY(std::abs(whole - frictionAfter([&](SelfContact& contact) { contact.fixFriction(less); })) < 1e-9 * whole);
    QVERIFY(std::abs(none - before) < 0.05 * before); // forces of before, along directions of here
    QVERIFY(std::abs(going(0.25) - std::lerp(none, whole, 0.25)) < 1e-6 * before);
}

void tst_SelfContactStatics::aSheetComesToRestOnAnother() {
    Cloth cloth = sheetOverPinnedSheet(10, 8, 0.0006);
    SelfContact contact(cloth.model, cloth.surface);
    dynamics::Stage* stages[]{&contact};
    const auto rest = dynamics::solveStatic(cloth.model, cloth.state, {0, -9.81, 0}, stages);
    QVERIFY(rest);
    QVERIFY2(rest->newton.converged, qPrintable(QString::number(rest->newton.residual)));
    QCOMPARE(cloth.intersections(), 0);
    for (int p = static_cast<int>(cloth.model.pinned.size()); p < cloth.model.particleCount(); ++p) {
        QVERIFY(cloth.state.positions[p].y < thickness);
        QVERIFY(cloth.state.positions[p].y > 0.8 * thickness); // it weighs 1.5 Pa
    }
}

TOILE_TEST(tst_SelfContactStatics)
#include "tst_SelfContactStatics.moc"
