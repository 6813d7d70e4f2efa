// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/Glide.h"
#include "tests/Suite.h"

#include <QTest>

using namespace toile;
using toile::simulation::Glide;

class tst_Glide : public QObject {
    Q_OBJECT
private slots:
    void noPictureJumps_data();
    void noPictureJumps();
    void whatHardlyMovesIsNotShown();
    void aLongWayIsShownInHalfASecond();
    void allVerticesArriveAtOnce();
};

namespace {

/// Of one vertex [m].
Glide over(double way) {
    return {{{0, 0, 0}}, {{way, 0, 0}}};
}

} // namespace

void tst_Glide::noPictureJumps_data() {
    QTest::addColumn<double>("way");
    for (const double way : {0.001, 0.002, 0.004, 0.01, 0.015}) QTest::addRow("%g mm", 1000 * way) << way;
}

/// Half as fast again as on the average where the way is fastest, in its middle.
void tst_Glide::noPictureJumps() {
    QFETCH(double, way);
    const Glide glide = over(way);
    QVERIFY(glide.pictures() > 0);
    const double each = std::chrono::duration<double>(Glide::each).count();
    double before = 0, farthest = 0;
    for (int i = 1; i <= glide.pictures() + 1; ++i) {
        const double now = i <= glide.pictures() ? glide.picture(i)[0].x : way;
        QVERIFY(now > before);
        farthest = std::max(farthest, now - before);
        before = now;
    }
    QVERIFY2(farthest <= 1.5 * way / (glide.pictures() + 1), qPrintable(QString::number(farthest / way)));
    QVERIFY2(farthest < 2 * 1.5 * 0.03 * each, qPrintable(QString::number(farthest))); // the last may be cut off
}

void tst_Glide::whatHardlyMovesIsNotShown() {
    QCOMPARE(over(0).pictures(), 0);
    QCOMPARE(over(0.0004).pictures(), 0);
}

void tst_Glide::aLongWayIsShownInHalfASecond() {
    const double each = std::chrono::duration<double>(Glide::each).count();
    for (const double way : {0.02, 0.5, 10.0}) {
        const double shown = (over(way).pictures() + 1) * each;
        QVERIFY(shown > 0.5 - each && shown <= 0.5);
    }
}

/// The one that goes farthest says how long it takes.
void tst_Glide::allVerticesArriveAtOnce() {
    const Glide glide({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 0.01, 0}, {1, 0, 0.002}, {2, 0, 0}});
    QCOMPARE(glide.pictures(), over(0.01).pictures());
    for (int i = 1; i <= glide.pictures(); ++i) {
        const std::vector<Vec3> between = glide.picture(i);
        QVERIFY(std::abs(between[1].z - 0.2 * between[0].y) < 1e-12);
        QCOMPARE(between[2].x, 2.0);
    }
}

TOILE_TEST(tst_Glide)
#include "tst_Glide.moc"
