// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/material/Interfacing.h"
#include "tests/Suite.h"

#include <QTest>
#include <cmath>
#include <limits>
#include <numbers>

using namespace toile::material;

class tst_Interfacing : public QObject {
    Q_OBJECT
private slots:
    void everyDirectionIsStifferAlike();
    void itsWeightIsAdded();
    void fusedClothShowsLongerFolds();
    void aWrongNumberIsNamed_data();
    void aWrongNumberIsNamed();
};

void tst_Interfacing::everyDirectionIsStifferAlike() {
    Fabric fabric;
    fabric.warpBending = 30e-6;
    fabric.weftBending = 10e-6;
    const Fabric stiff = fused(fabric, {.bendingFactor = 8, .arealDensity = 0.03});
    for (const double angle : {0.0, 0.3, std::numbers::pi / 4, 1.2, std::numbers::pi / 2})
        QVERIFY(std::abs(bendingStiffness(stiff, angle) / bendingStiffness(fabric, angle) - 8) < 1e-12);
}

void tst_Interfacing::itsWeightIsAdded() {
    const Fabric fabric, stiff = fused(fabric, {.bendingFactor = 8, .arealDensity = 0.03});
    QCOMPARE(stiff.arealDensity, fabric.arealDensity + 0.03);
    QCOMPARE(stiff.warpStiffness, fabric.warpStiffness);
    QVERIFY(fused(fabric, {.bendingFactor = 1, .arealDensity = 0}) == fabric);
}

void tst_Interfacing::fusedClothShowsLongerFolds() {
    Fabric fabric; // bending length (B/ρg)^(1/3)
    const Fabric stiff = fused(fabric, {.bendingFactor = 16, .arealDensity = fabric.arealDensity});
    QVERIFY(std::abs(bendingLength(stiff) / bendingLength(fabric) - 2) < 1e-12);
}

void tst_Interfacing::aWrongNumberIsNamed_data() {
    QTest::addColumn<double>("factor");
    QTest::addColumn<double>("density");
    QTest::addColumn<QString>("path");
    QTest::newRow("softer than the fabric alone") << 0.5 << 0.05 << "bendingFactor";
    QTest::newRow("stiff without end") << std::numeric_limits<double>::infinity() << 0.05 << "bendingFactor";
    QTest::newRow("lighter than nothing") << 10.0 << -0.01 << "arealDensity";
    QTest::newRow("of no weight that could be named") << 10.0 << std::nan("") << "arealDensity";
}

void tst_Interfacing::aWrongNumberIsNamed() {
    QFETCH(double, factor);
    QFETCH(double, density);
    QFETCH(QString, path);
    const auto ok = checked(Interfacing{factor, density});
    QVERIFY(!ok);
    QCOMPARE(QString::fromStdString(ok.error().place.path), path);
    QVERIFY(QString::fromStdString(ok.error().text).contains(path));
}

TOILE_TEST(tst_Interfacing)
#include "tst_Interfacing.moc"
