// SPDX-License-Identifier: GPL-3.0-or-later
#include "WornScenes.h"

using namespace toile;
using namespace toile::simulation;

/// A garment so fine that coarse levels help it into its place comes to rest while they do: it does not tremble by
/// them.
class tst_FineBlouse : public QObject {
    Q_OBJECT
private slots:
    void restsByItsLevelsAndIsInEquilibrium();
};

void tst_FineBlouse::restsByItsLevelsAndIsInEquilibrium() {
    auto simulation = Simulation::create(onBlouseWearer(blouseAt(0.014)));
    QVERIFY(simulation);
    const auto report = sew(*simulation, {.limit = 6.5}); // the levels go 6 s after the seams are closed
    QVERIFY2(report, report ? "" : toString(report.error()).c_str());
    QCOMPARE(report->ending, std::string("at rest"));
    QVERIFY(std::ranges::none_of(report->leftOut, [](const LeftOut& part) { return part.stage == "coarse levels"; }));
    QVERIFY2(report->atRest, qPrintable(QString("residual %1").arg(*report->residual)));
    QVERIFY2(report->worn->worn, report->worn->worn ? "" : report->worn->why.front().c_str());
}

QTEST_APPLESS_MAIN(tst_FineBlouse)
#include "tst_FineBlouse.moc"
