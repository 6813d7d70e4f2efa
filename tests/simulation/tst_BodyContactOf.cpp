// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/Suite.h"
#include "tests/simulation/Sewn.h"
#include "tests/simulation/SmallScenes.h"

#include <QTest>

using namespace toile;
using namespace toile::simulation;

/// Contact with the body as a garment's scene asks for it.
class tst_BodyContactOf : public QObject {
    Q_OBJECT
private slots:
    void whatPressesHardRestsAtItsDistance();
};

void tst_BodyContactOf::whatPressesHardRestsAtItsDistance() {
    Scene scene = sheetOnTable(0.50325); // the box is 0.5 m high
    scene.settings.gravity = {0, -300 * 9.80665, 0};
    Simulation simulation = simulationOf(scene);
    const auto report = simulation.settle({});
    QVERIFY(report && report->newton.converged);
    const double target = 0.5 + scene.settings.skinOffset + scene.pattern.fabrics[0]->thickness / 2;
    for (const Vec3& x : simulation.state().positions)
        QVERIFY2(std::abs(x.y - target) < 5e-6, qPrintable(QString::number(x.y - target))); // dented by 0.3 mm else
}

TOILE_TEST(tst_BodyContactOf, QCoreApplication)
#include "tst_BodyContactOf.moc"
