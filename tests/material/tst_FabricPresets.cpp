// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest> // first: moc 6.4 stumbles over <compare> as the first header

#include "core/material/FabricPresets.h"
#include "tests/Suite.h"

#include <set>

using namespace toile;
using namespace toile::material;

class tst_FabricPresets : public QObject {
    Q_OBJECT
private slots:
    void everyFabricIsSoundAndNamesItsSource();
    void idsAreUnique();
    void bendingLengthsAreThoseOfTheTable();
    void knitsStiffenAsMeasured();
    void wovensAreWithinTheReachOfSpringCells();
};

namespace {

std::vector<Fabric> all() {
    std::vector<Fabric> fabrics = measuredFabrics();
    for (Fabric& fabric : everydayFabrics()) fabrics.push_back(std::move(fabric));
    return fabrics;
}

} // namespace

void tst_FabricPresets::everyFabricIsSoundAndNamesItsSource() {
    for (const Fabric& fabric : all()) {
        QVERIFY2(checked(fabric), fabric.name.c_str());
        QVERIFY2(membraneStiffness(fabric, fabric.kind == FabricKind::woven ? fabric.shearStiffness : fabric.coupling),
                 fabric.name.c_str());
        QVERIFY2(fabric.source.size() > 20, fabric.name.c_str());
    }
}

void tst_FabricPresets::idsAreUnique() {
    std::set<std::string> ids;
    for (const Fabric& fabric : all()) QVERIFY2(ids.insert(fabric.id.value).second, fabric.id.value.c_str());
    QCOMPARE(measuredFabrics().size(), std::size_t{10});
}

/// ℓ_b computed from the printed bending and density must be the printed ℓ_b: guards the table against slips.
/// The printed column is the mean over 0°, 45° and 90°, rounded to 0.1 mm.
void tst_FabricPresets::bendingLengthsAreThoseOfTheTable() {
    const double printed[] = {29.1, 23.4, 22.4, 23.7, 28.0, 34.0, 38.1, 25.7, 32.0, 30.5}; // [mm]
    const auto fabrics = measuredFabrics();
    for (std::size_t i = 0; i < fabrics.size(); ++i) {
        const Fabric& f = fabrics[i];
        const double mean = (f.warpBending + f.biasBending + f.weftBending) / 3;
        const double length = 1000 * std::cbrt(mean / (f.arealDensity * 9.81));
        QVERIFY2(std::abs(length - printed[i]) < 0.1, (f.id.value + " " + std::to_string(length)).c_str());
    }
}

void tst_FabricPresets::knitsStiffenAsMeasured() {
    const Fabric interlock = measuredFabrics()[2];
    QCOMPARE(interlock.warpStiffness * interlock.warpTension.back().modulusFactor, 93.0);
    QCOMPARE(interlock.weftStiffness * interlock.weftTension.back().modulusFactor, 812.0);
    for (const Fabric& fabric : {jersey(), rib()}) {
        QVERIFY(fabric.kind == FabricKind::knit);
        QVERIFY(fabric.warpTension.size() > 1 && fabric.weftTension.size() > 1);
        QCOMPARE(fabric.warpTension.front().modulusFactor, 1.0);
    }
}

/// Square cells need E ≥ G after the diagonals took their share; rows may be up to four times as high as wide.
void tst_FabricPresets::wovensAreWithinTheReachOfSpringCells() {
    for (const Fabric& fabric : {poplin(), chiffon(), twill()})
        QVERIFY2(std::min(fabric.warpStiffness, fabric.weftStiffness) >= 16 * fabric.shearStiffness,
                 fabric.name.c_str());
}

TOILE_TEST(tst_FabricPresets)
#include "tst_FabricPresets.moc"
