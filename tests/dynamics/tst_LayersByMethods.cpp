// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/dynamics/Method.h"
#include "tests/Suite.h"
#include "tests/dynamics/Constants.h"
#include "tests/dynamics/LayeredCloth.h"

#include <QTest>

using namespace toile;
using namespace toile::layers;
using dynamics::Method;
using dynamics::Stage;

namespace {

/// A sheet of 60 mm that flies askew at a pinned one of 120 mm [m/s].
Cloth thrownSheet(double speed) {
    Cloth cloth;
    append(cloth, 0.12, 8, 0.12, 8, 0.3, [](const Vec2& m) { return Vec3{m.x - 0.06, 0, 0.06 - m.y}; });
    pin(cloth, 0, cloth.model.particleCount());
    append(cloth, 0.06, 5, 0.06, 5, 0.3, [](const Vec2& m) {
        const Vec2 p = geometry::rotated(m - Vec2{0.03, 0.03}, 0.3);
        return Vec3{p.x, 0.012 + 0.1 * p.x, -p.y};
    });
    for (std::size_t p = cloth.model.pinned.size(); p < cloth.state.positions.size(); ++p)
        cloth.state.velocities[p] = {0.1 * speed, -speed, 0};
    return cloth;
}

} // namespace

/// Layers of one cloth by every method of time, looked at after each step by a test that shares no code with contact.
class tst_LayersByMethods : public QObject {
    Q_OBJECT
private slots:
    void aThrownSheetNeverPasses_data() { eachMethod(); }
    void aThrownSheetNeverPasses();
    void slavesAreHeldToo_data() { eachMethod(); }
    void slavesAreHeldToo();

private:
    static void eachMethod() {
        QTest::addColumn<Method>("method");
        for (const Method method : dynamics::allMethods()) QTest::addRow("%s", nameOf(method).data()) << method;
    }
};

void tst_LayersByMethods::aThrownSheetNeverPasses() {
    QFETCH(const Method, method);
    for (const double speed : {0.5, 6.0}) {
        Cloth cloth = thrownSheet(speed);
        dynamics::SelfContact contact(cloth.model, cloth.surface);
        Stage* stages[]{&contact};
        const auto integrator = dynamics::makeIntegrator(method, cloth.model, {.damping = 0.5});
        for (int step = 0; step < 10; ++step) {
            QVERIFY(integrator->step(cloth.state, 1.0 / 480, gravity, stages));
            QCOMPARE(cloth.intersections(), 0);
            QVERIFY(lowest(cloth) > 0);
        }
        QVERIFY(contact.guaranteed());
    }
}

void tst_LayersByMethods::slavesAreHeldToo() {
    QFETCH(const Method, method);
    Cloth cloth = sheetThrownAtTwoRegions(2);
    dynamics::SelfContact contact(cloth.model, cloth.surface);
    Stage* stages[]{&contact};
    const auto integrator = dynamics::makeIntegrator(method, cloth.model, {.damping = 0.5});
    for (int step = 0; step < 4; ++step) {
        QVERIFY(integrator->step(cloth.state, 1.0 / 120, {}, stages));
        QCOMPARE(cloth.intersections(), 0);
        QVERIFY(farthestSlave(cloth) < 1e-12);
    }
    QVERIFY(contact.guaranteed());
    QVERIFY(cloth.state.velocities.back() != Vec3{}); // of the sheet that was at rest
}

TOILE_TEST(tst_LayersByMethods)
#include "tst_LayersByMethods.moc"
