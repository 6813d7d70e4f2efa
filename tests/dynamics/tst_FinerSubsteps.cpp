// SPDX-License-Identifier: GPL-3.0-or-later
#include "IdleStage.h"
#include "core/dynamics/FinerSubsteps.h"
#include "tests/Suite.h"
#include "tests/dynamics/Constants.h"

#include <QTest>
#include <limits>
#include <vector>

using namespace toile;
using dynamics::ParticleState;

namespace {

/// A force that is no number as long as substeps are longer than it can bear.
class TooStiff final : public dynamics::IdleStage {
public:
    explicit TooStiff(double longest) : longest_(longest) {}

    void project(dynamics::Substep& substep) override {
        if (substep.duration > longest_) substep.positions[0].x = std::numeric_limits<double>::quiet_NaN();
    }

private:
    double longest_; ///< substep [s]
};

constexpr int substeps = 10;

/// A particle that falls.
struct StiffDrop {
    cloth::ClothModel model{.mass = {0.01}};
    ParticleState state{.positions = {{0, 1, 0}}, .velocities = {{0, 0, 0}}};

    /// In substeps of which those are no numbers that are longer than so many in a frame step would be.
    Result<dynamics::StepReport> stepBearing(int needed) {
        dynamics::Xpbd xpbd(model, {});
        TooStiff stage(frame / needed * 1.001);
        dynamics::Stage* const stages[] = {&stage};
        return dynamics::stepOrFiner(xpbd, state, frame, substeps, {0, -9.81, 0}, stages);
    }
};

} // namespace

class tst_FinerSubsteps : public QObject {
    Q_OBJECT
private slots:
    void whatEndsInNumbersIsNotMadeAgain();
    void whatDoesNotIsMadeAgainInFinerSubsteps_data();
    void whatDoesNotIsMadeAgainInFinerSubsteps();
    void whatNeverDoesIsAnError();
};

void tst_FinerSubsteps::whatEndsInNumbersIsNotMadeAgain() {
    StiffDrop drop;
    const auto report = drop.stepBearing(substeps);
    QVERIFY(report);
    QCOMPARE(report->parts, substeps);
    QCOMPARE(report->repeated, 0);
}

void tst_FinerSubsteps::whatDoesNotIsMadeAgainInFinerSubsteps_data() {
    QTest::addColumn<int>("needed");
    QTest::addColumn<int>("repeated");
    QTest::newRow("twice as many") << 2 * substeps << substeps;
    QTest::newRow("four times as many") << 4 * substeps << 3 * substeps;
}

void tst_FinerSubsteps::whatDoesNotIsMadeAgainInFinerSubsteps() {
    QFETCH(int, needed);
    QFETCH(int, repeated);
    StiffDrop drop;
    const auto report = drop.stepBearing(needed);
    QVERIFY2(report, report ? "" : report.error().text.c_str());
    QCOMPARE(report->parts, needed);
    QCOMPARE(report->repeated, repeated);
    QVERIFY(drop.state.positions[0].y < 1);
    QCOMPARE(drop.state.time, frame);
}

void tst_FinerSubsteps::whatNeverDoesIsAnError() {
    StiffDrop drop;
    const auto report = drop.stepBearing(5 * substeps);
    QVERIFY(!report);
    QVERIFY(report.error().code == ErrorCode::notConverged);
    QCOMPARE(drop.state.positions[0].y, 1.0);
    QCOMPARE(drop.state.time, 0.0);
}

TOILE_TEST(tst_FinerSubsteps)
#include "tst_FinerSubsteps.moc"
