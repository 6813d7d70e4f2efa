// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/material/Fabric.h"
#include "tests/Suite.h"

#include <QTest>
#include <numbers>

using namespace toile::material;

class tst_Fabric : public QObject {
    Q_OBJECT
private slots:
    void aFreeStripShowsTheUniaxialModuli();
    void withoutCouplingTheModuliAreTheStiffnesses();
    void bendingIsWhatWasMeasuredInThreeDirections();
    void theBendingLengthFollowsItsFormula();
    void aWrongConstantIsNamed_data();
    void aWrongConstantIsNamed();
    void tensionCurvesMustRise();
};

void tst_Fabric::aFreeStripShowsTheUniaxialModuli() {
    Fabric fabric;
    fabric.warpStiffness = 1500;
    fabric.weftStiffness = 700;
    const auto c = membraneStiffness(fabric, 200);
    QVERIFY(c);
    // Pulled along one axis with free sides: E = C − C12² / C of the other axis.
    QVERIFY(std::abs(c->c22 - c->c12 * c->c12 / c->c11 - 1500) < 1e-9);
    QVERIFY(std::abs(c->c11 - c->c12 * c->c12 / c->c22 - 700) < 1e-9);
    QCOMPARE(c->c33, fabric.shearStiffness);
}

void tst_Fabric::withoutCouplingTheModuliAreTheStiffnesses() {
    Fabric fabric;
    fabric.warpStiffness = 1500;
    const auto c = membraneStiffness(fabric, 0);
    QCOMPARE(c->c22, 1500.0);
    QCOMPARE(c->c11, fabric.weftStiffness);
    fabric.warpStiffness = 0;
    QVERIFY(!membraneStiffness(fabric, 10));
}

void tst_Fabric::bendingIsWhatWasMeasuredInThreeDirections() {
    Fabric fabric;
    fabric.warpBending = 30e-6;
    fabric.weftBending = 10e-6;
    fabric.biasBending = 12e-6;
    constexpr double rounding = 1e-18;
    QVERIFY(std::abs(bendingStiffness(fabric, 0) - 30e-6) < rounding);
    QVERIFY(std::abs(bendingStiffness(fabric, std::numbers::pi / 2) - 10e-6) < rounding);
    QVERIFY(std::abs(bendingStiffness(fabric, std::numbers::pi / 4) - 12e-6) < rounding);
    QVERIFY(std::abs(bendingStiffness(fabric, 0.3) - bendingStiffness(fabric, 0.3 - std::numbers::pi)) < rounding);
}

void tst_Fabric::theBendingLengthFollowsItsFormula() {
    Fabric fabric;
    fabric.arealDensity = 0.1;
    fabric.warpBending = fabric.weftBending = 0.981e-6; // B/ρg = 1e-6 m³
    QVERIFY(std::abs(bendingLength(fabric) - 0.01) < 1e-15);
    QCOMPARE(proposedSpacing(fabric), 0.005);
    fabric.warpBending = fabric.weftBending = 1.2e-6; // bending length 10.7 mm
    QCOMPARE(proposedSpacing(fabric), 0.005);
    fabric.warpBending = fabric.weftBending = 0;
    QCOMPARE(proposedSpacing(fabric), 0.001);
}

void tst_Fabric::aWrongConstantIsNamed_data() {
    QTest::addColumn<double>("value");
    QTest::newRow("negative") << -1.0;
    QTest::newRow("not a number") << std::nan("");
    QTest::newRow("infinite") << std::numeric_limits<double>::infinity();
}

void tst_Fabric::aWrongConstantIsNamed() {
    QFETCH(double, value);
    QVERIFY(checked(Fabric{}));
    const std::pair<const char*, double Fabric::*> fields[] = {
        {"arealDensity", &Fabric::arealDensity},   {"warpStiffness", &Fabric::warpStiffness},
        {"weftStiffness", &Fabric::weftStiffness}, {"shearStiffness", &Fabric::shearStiffness},
        {"coupling", &Fabric::coupling},           {"warpBending", &Fabric::warpBending},
        {"weftBending", &Fabric::weftBending},     {"biasBending", &Fabric::biasBending},
        {"thickness", &Fabric::thickness},         {"friction", &Fabric::friction}};
    for (const auto& [name, field] : fields) {
        Fabric fabric;
        fabric.*field = value;
        const auto result = checked(fabric);
        QVERIFY2(!result, name);
        QCOMPARE(result.error().place.path, std::string(name));
    }
}

void tst_Fabric::tensionCurvesMustRise() {
    Fabric fabric;
    fabric.weftTension = {{0.1, 1}, {0.2, 3}};
    QVERIFY(checked(fabric));
    fabric.weftTension = {{0.2, 1}, {0.1, 3}};
    QCOMPARE(checked(fabric).error().place.path, std::string("weftTension"));
}

TOILE_TEST(tst_Fabric)
#include "tst_Fabric.moc"
