// SPDX-License-Identifier: GPL-3.0-or-later
#include "IdleStage.h"
#include "core/dynamics/GuardedStep.h"
#include "core/dynamics/Method.h"
#include "tests/Suite.h"
#include "tests/dynamics/Constants.h"

#include <QTest>
#include <limits>

using namespace toile;
using dynamics::Method;
using dynamics::ParticleState;

namespace {

/// A force that is no number for so many steps, and none after that.
class BrokenForSteps final : public dynamics::IdleStage {
public:
    explicit BrokenForSteps(int broken) : broken_(broken) {}

    void beginStep(const ParticleState&, double) override { --broken_; }
    void addForces(std::span<const Vec3>, std::span<Vec3> forces) const override {
        if (broken_ >= 0) forces[0].x = std::numeric_limits<double>::quiet_NaN();
    }

private:
    int broken_;
};

/// A particle that falls.
struct GuardedDrop {
    cloth::ClothModel model{.mass = {0.01}};
    ParticleState state{.positions = {{0, 1, 0}}, .velocities = {{0, 0, 0}}};
    int asked = 0; ///< for the safe method

    Result<dynamics::GuardedReport> stepWhile(int broken, Method method) {
        const auto integrator = dynamics::makeIntegrator(method, model, {.damping = 0});
        const auto safe = dynamics::makeIntegrator(Method::backwardEuler, model, {.damping = 0});
        BrokenForSteps stage(broken);
        dynamics::Stage* const stages[] = {&stage};
        const auto ask = [&]() -> dynamics::Integrator& {
            ++asked;
            return *safe;
        };
        return dynamics::guardedStep({*integrator, ask, nullptr}, state, frame, gravity, stages);
    }
};

void explicitMethods() {
    QTest::addColumn<Method>("method");
    for (const Method method : {Method::symplecticEuler, Method::rk4})
        QTest::newRow(std::string(nameOf(method)).c_str()) << method;
}

} // namespace

class tst_GuardedStep : public QObject {
    Q_OBJECT
private slots:
    void whatEndsInNumbersIsLeftAlone_data() { explicitMethods(); }
    void whatEndsInNumbersIsLeftAlone();
    void whatDoesNotIsMadeAgain_data() { explicitMethods(); }
    void whatDoesNotIsMadeAgain();
    void whatNeverDoesIsAnError();
};

void tst_GuardedStep::whatEndsInNumbersIsLeftAlone() {
    QFETCH(Method, method);
    GuardedDrop drop;
    const auto report = drop.stepWhile(0, method);
    QVERIFY(report);
    QVERIFY(!report->redone);
    QCOMPARE(report->step.repeated, 0);
    QCOMPARE(drop.asked, 0);
}

void tst_GuardedStep::whatDoesNotIsMadeAgain() {
    QFETCH(Method, method);
    GuardedDrop drop;
    const auto report = drop.stepWhile(1, method);
    QVERIFY2(report, report ? "" : report.error().text.c_str());
    QVERIFY(report->redone);
    QVERIFY(report->step.accurate);
    QVERIFY(report->step.repeated >= 1);
    QCOMPARE(drop.state.time, frame);
    QVERIFY(std::abs(drop.state.velocities[0].y + 9.81 * frame) < 1e-4); // as Newton solves it
}

void tst_GuardedStep::whatNeverDoesIsAnError() {
    GuardedDrop drop;
    const auto report = drop.stepWhile(1000, Method::symplecticEuler);
    QVERIFY(!report);
    QVERIFY(report.error().code == ErrorCode::notConverged);
    QCOMPARE(drop.state.positions[0].y, 1.0);
    QCOMPARE(drop.state.time, 0.0);
}

TOILE_TEST(tst_GuardedStep)
#include "tst_GuardedStep.moc"
