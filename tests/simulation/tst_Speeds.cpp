// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/Speeds.h"
#include "tests/Suite.h"

#include <QTest>

#include <vector>

using namespace toile;
using namespace toile::simulation;

namespace {

constexpr double frame = 1.0 / 60;

/// So many particles of equal mass of which the first `moving` move at this speed [m/s].
Speeds speedsWith(int particles, int moving, double speed) {
    const std::vector<double> mass(particles, 1e-5);
    const std::vector<Vec3> before(particles, Vec3{0.1, 1, 0});
    std::vector<Vec3> after = before;
    for (int i = 0; i < moving; ++i) after[i] += Vec3{0, 0.6, -0.8} * (speed * frame);
    return speedsOf(mass, before, after, frame);
}

} // namespace

class tst_Speeds : public QObject {
    Q_OBJECT
private slots:
    void theMeanIsByMass();
    void clothWhoseParticlesAllMoveSlowlyRests();
    void aFewThatTrembleAreNoMotionOfTheGarment();
    void aSleeveThatSwingsIsOne();
};

void tst_Speeds::theMeanIsByMass() {
    const std::vector<double> mass{1, 3};
    const std::vector<Vec3> before{{}, {}}, after{{0.3, 0, 0}, {0, 0.1, 0}};
    const Speeds speeds = speedsOf(mass, before, after, 0.5);
    QCOMPARE(speeds.largest, 0.6);
    QCOMPARE(speeds.mean, std::sqrt((1 * 0.36 + 3 * 0.04) / 4));
}

void tst_Speeds::clothWhoseParticlesAllMoveSlowlyRests() {
    QVERIFY(speedsWith(1000, 1000, 0.0049).areOfRest());
    QVERIFY(!speedsWith(1000, 1000, 0.0051).areOfRest());
}

void tst_Speeds::aFewThatTrembleAreNoMotionOfTheGarment() {
    QVERIFY(speedsWith(5000, 2, 0.009).areOfRest());
    QVERIFY(!speedsWith(5000, 4, 0.009).areOfRest()); // 0.25 mm/s in the mean
}

void tst_Speeds::aSleeveThatSwingsIsOne() {
    QVERIFY(!speedsWith(5000, 50, 0.006).areOfRest()); // a hundredth of it
}

TOILE_TEST(tst_Speeds)
#include "tst_Speeds.moc"
