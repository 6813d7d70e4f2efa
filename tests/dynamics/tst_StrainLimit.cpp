// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/dynamics/StrainLimit.h"
#include "core/dynamics/Xpbd.h"
#include "tests/Suite.h"
#include "tests/cloth/Fixtures.h"

#include <QTest>

using namespace toile;
using namespace toile::fixtures;
using dynamics::ParticleState;
using dynamics::StrainLimit;

namespace {

/// Draws one particle along x by so much in every substep.
struct Pull : dynamics::Stage {
    int particle = 0;
    double way = 0;
    std::string_view name() const override { return "pull"; }
    std::size_t bytes() const override { return sizeof *this; }
    void beginStep(const ParticleState&, double) override {}
    void project(dynamics::Substep& substep) override { substep.positions[particle].x += way; }
    void beginIteration(std::span<const Vec3>) override {}
    double energy(std::span<const Vec3>) const override { return 0; }
    void addForces(std::span<const Vec3>, std::span<Vec3>) const override {}
    void addHessian(std::span<const Vec3>, dynamics::HessianSink&) const override {}
};

struct PulledSheet {
    cloth::ClothModel model;
    ParticleState state;
    explicit PulledSheet(const Fabric& fabric) {
        const Patch patch = gridPatch(evenLines(0.2, 8), evenLines(0.2, 8));
        if (!cloth::appendPatch(model, patch, fabric)) qFatal("a sheet is a cloth");
        for (const Vec3& p : flatPositions(patch)) state.positions.push_back(p);
        state.velocities.resize(state.positions.size());
    }
    [[nodiscard]] double longest() const {
        double most = 0;
        for (const auto& s : model.structural)
            most = std::max(most, distance(state.positions[s.a], state.positions[s.b]) / s.restLength - 1);
        return most;
    }
    /// Largest strain on the way, pinned at one side and pulled in the middle of the other.
    double pulled(bool limited) {
        model.pinned = {0, 9, 18, 27, 36, 45, 54, 63, 72};
        Pull pull;
        pull.particle = 44;
        pull.way = 0.02;
        const int held[]{pull.particle};
        StrainLimit limit(model, held);
        std::vector<dynamics::Stage*> stages{&pull};
        if (limited) stages.push_back(&limit);
        dynamics::Xpbd xpbd(model, {.damping = 5});
        double most = 0;
        for (int frame = 0; frame < 30; ++frame) {
            if (!xpbd.step(state, 1.0 / 60, 40, {}, stages)) qFatal("a sheet can be pulled");
            most = std::max(most, longest());
        }
        return most;
    }
};

} // namespace

class tst_StrainLimit : public QObject {
    Q_OBJECT
private slots:
    void clothThatIsPulledHardStretchesLittle();
    void whatMayBeAsLongStaysAsItIs_data();
    void whatMayBeAsLongStaysAsItIs();
    void momentumIsKept();
};

void tst_StrainLimit::clothThatIsPulledHardStretchesLittle() {
    const double free = PulledSheet(wovenFabric()).pulled(false), limited = PulledSheet(wovenFabric()).pulled(true);
    QVERIFY2(free > 1, qPrintable(QString::number(free)));
    QVERIFY2(limited < 0.25, qPrintable(QString::number(limited)));
}

void tst_StrainLimit::whatMayBeAsLongStaysAsItIs_data() {
    QTest::addColumn<bool>("isKnit");
    QTest::addColumn<double>("stretch");
    QTest::addColumn<bool>("isMoved");
    QTest::addRow("woven, below the limit") << false << 1.099 << false;
    QTest::addRow("woven, beyond it") << false << 1.101 << true;
    QTest::addRow("a knit, as it is meant to stretch") << true << 1.5 << false;
}

void tst_StrainLimit::whatMayBeAsLongStaysAsItIs() {
    QFETCH(const bool, isKnit);
    QFETCH(const double, stretch);
    QFETCH(const bool, isMoved);
    PulledSheet sheet(isKnit ? knitFabric() : wovenFabric());
    for (Vec3& p : sheet.state.positions) p *= stretch;
    const std::vector<Vec3> before = sheet.state.positions;
    const std::vector<double> inverseMass(before.size(), 1.0);
    StrainLimit limit(sheet.model, {});
    dynamics::Substep substep{sheet.state.positions, before, inverseMass, 1e-3};
    limit.project(substep);
    QCOMPARE(sheet.state.positions != before, isMoved);
}

void tst_StrainLimit::momentumIsKept() {
    PulledSheet sheet(wovenFabric());
    std::vector<double> inverseMass;
    for (std::size_t p = 0; p < sheet.state.positions.size(); ++p) {
        sheet.state.positions[p] *= 1.2 + 0.1 * std::sin(static_cast<double>(p));
        inverseMass.push_back(1 / sheet.model.mass[p]);
    }
    const std::vector<Vec3> before = sheet.state.positions;
    const int held[]{40};
    StrainLimit limit(sheet.model, held);
    dynamics::Substep substep{sheet.state.positions, before, inverseMass, 1e-3};
    limit.project(substep);
    QVERIFY(sheet.state.positions != before);
    Vec3 moved;
    for (std::size_t p = 0; p < before.size(); ++p)
        moved += sheet.model.mass[p] * (sheet.state.positions[p] - before[p]);
    QVERIFY(length(moved) < 1e-15);
}

TOILE_TEST(tst_StrainLimit)
#include "tst_StrainLimit.moc"
