// SPDX-License-Identifier: GPL-3.0-or-later
#include "WornScenes.h"
#include "tests/Suite.h"

using namespace toile;
using namespace toile::simulation;

/// A garment so fine that coarse levels help it into its place comes to rest while they do, also if a few of its
/// particles tremble by them, as at 14.6 mm.
class tst_FineBlouse : public QObject {
    Q_OBJECT
private slots:
    void restsByItsLevelsAndIsInEquilibrium_data();
    void restsByItsLevelsAndIsInEquilibrium();
};

void tst_FineBlouse::restsByItsLevelsAndIsInEquilibrium_data() {
    QTest::addColumn<double>("spacing");
    QTest::newRow("14 mm") << 0.014;
    QTest::newRow("14.6 mm") << 0.0146;
}

void tst_FineBlouse::restsByItsLevelsAndIsInEquilibrium() {
    QFETCH(double, spacing);
    auto simulation = Simulation::create(onBlouseWearer(blouseAt(spacing)));
    QVERIFY(simulation);
    const auto report = sew(*simulation, {.limit = 6.5}); // the levels go 6 s after the seams are closed
    QVERIFY2(report, report ? "" : toString(report.error()).c_str());
    QCOMPARE(report->ending, std::string("at rest"));
    QVERIFY(std::ranges::none_of(report->leftOut, [](const LeftOut& part) { return part.stage == "coarse levels"; }));
    QVERIFY2(report->atRest, qPrintable(QString("residual %1").arg(*report->residual)));
    QVERIFY2(report->worn->worn, report->worn->worn ? "" : report->worn->why.front().c_str());
}

TOILE_TEST(tst_FineBlouse)
#include "tst_FineBlouse.moc"
