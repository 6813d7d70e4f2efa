// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/collision/BodySurface.h"
#include "core/dynamics/BodyContact.h"
#include "tests/Suite.h"
#include "tests/collision/Shapes.h"
#include "tests/dynamics/Constants.h"
#include "tests/dynamics/LayeredCloth.h"

#include <QTest>

using namespace toile;
using namespace toile::layers;
using dynamics::Stage;

namespace {

/// Says after how many frames the cloth first meets itself; −1 = never.
int firstIntersection(Cloth& cloth, int frames, int substeps, std::span<Stage* const> stages) {
    dynamics::Xpbd xpbd(cloth.model, {.damping = 1, .speedLimit = 10});
    for (int f = 0; f < frames; ++f) {
        if (const auto done = xpbd.step(cloth.state, frame, substeps, gravity, stages); !done)
            qFatal("%s", toString(done.error()).c_str());
        if (cloth.intersections() > 0) return f;
    }
    return -1;
}

/// An upright strip over the floor, bent a little to either side by turns, so that it comes down in folds.
Cloth standingStrip() {
    Cloth cloth;
    append(cloth, 0.15, 15, 0.6, 60, 0.3, [](const Vec2& m) {
        return Vec3{m.x - 0.075, 0.05 + m.y, 0.01 * std::sin(25 * m.y) + 0.002 * m.x};
    });
    return cloth;
}

collision::BodySurface floorAt(double height) {
    return *collision::BodySurface::create(shapes::box({-1, height - 1, -1}, {1, height, 1}));
}

dynamics::BodyContact contactOf(const Cloth& cloth, const collision::BodySurface& body) {
    return {body, dynamics::particleSamples(cloth.model, cloth.surface.halfThickness, cloth.surface.friction, 0.3)};
}

} // namespace

/// Cloth that falls onto itself, looked at after every frame by a test that shares no code with the contact
/// stages.
class tst_FoldingSheet : public QObject {
    Q_OBJECT
private slots:
    void aStripThatComesDownInFoldsNeverMeetsItself();
    void withoutSelfContactItDoes();
    void aSheetOverASmallBallNeverMeetsItself();
};

void tst_FoldingSheet::aStripThatComesDownInFoldsNeverMeetsItself() {
    Cloth cloth = standingStrip();
    const auto floor = floorAt(0);
    auto onFloor = contactOf(cloth, floor);
    dynamics::SelfContact self(cloth.model, cloth.surface);
    Stage* stages[]{&onFloor, &self};
    QCOMPARE(firstIntersection(cloth, 60, 30, stages), -1);
    QVERIFY(self.nearPairs() > 1000); // it lies on itself
    QVERIFY(self.guaranteed());
    QVERIFY(onFloor.clearance(cloth.state.positions) > 0.001);
    double highest = 0;
    for (const Vec3& p : cloth.state.positions) highest = std::max(highest, p.y);
    QVERIFY(highest < 0.2);
}

void tst_FoldingSheet::withoutSelfContactItDoes() {
    Cloth cloth = standingStrip();
    const auto floor = floorAt(0);
    auto onFloor = contactOf(cloth, floor);
    Stage* stages[]{&onFloor};
    QVERIFY(firstIntersection(cloth, 60, 30, stages) >= 0);
}

void tst_FoldingSheet::aSheetOverASmallBallNeverMeetsItself() {
    Cloth cloth;
    append(cloth, 0.6, 30, 0.6, 30, 0.3, [](const Vec2& m) { return Vec3{m.x - 0.3, 0.1, 0.27 - m.y}; });
    const auto ball = *collision::BodySurface::create(shapes::starBody(16, 24, [](const Vec3&) { return 0.05; }));
    auto onBall = contactOf(cloth, ball);
    dynamics::SelfContact self(cloth.model, cloth.surface);
    Stage* stages[]{&onBall, &self};
    QCOMPARE(firstIntersection(cloth, 90, 30, stages), -1);
    QVERIFY(self.nearPairs() > 100);
    QVERIFY(onBall.clearance(cloth.state.positions) > 0.001);
}

TOILE_TEST(tst_FoldingSheet)
#include "tst_FoldingSheet.moc"
