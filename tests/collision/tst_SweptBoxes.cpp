// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/collision/FourSweptBoxes.h"
#include "tests/Suite.h"

#include <QTest>
#include <random>

using namespace toile;
using namespace toile::collision;

namespace {

SweptBox boxAnywhere(std::mt19937& random) {
    std::uniform_real_distribution<double> place(-1, 1), size(0, 0.4);
    const auto vector = [&] { return geometry::Vec3{place(random), place(random), place(random)}; };
    const geometry::Vec3 low = vector();
    const SweptBox box({low, low + geometry::Vec3{size(random), size(random), size(random)}}, 0.01, vector());
    return random() % 2 ? box : around(box, SweptBox({low, low}, 0.01, vector()));
}

} // namespace

/// Boxes that go their ways, one by one and four at once.
class tst_SweptBoxes : public QObject {
    Q_OBJECT
private slots:
    void whatPassesMeets();
    void fourAtOnceAreAsOneByOne();
    void whatIsNowhereMeetsNothing();
};

void tst_SweptBoxes::whatPassesMeets() {
    const SweptBox still({{0, 0, 0}, {1, 1, 1}}, 0), coming({{2, 0, 0}, {3, 1, 1}}, 0, {-1.5, 0, 0});
    const SweptBox going({{2, 0, 0}, {3, 1, 1}}, 0, {1, 0, 0}), alike({{0, 0, 0}, {1, 1, 1}}, 0, {-1.5, 0, 0});
    QVERIFY(meet(still, coming) && meet(coming, still));
    QVERIFY(!meet(still, going) && !meet(going, still));
    QVERIFY(!meet(alike, coming)); // they go together
}

void tst_SweptBoxes::fourAtOnceAreAsOneByOne() {
    std::mt19937 random(1);
    int met = 0;
    for (int trial = 0; trial < 2000; ++trial) {
        FourSweptBoxes four;
        SweptBox boxes[FourSweptBoxes::width];
        for (int lane = 0; lane < FourSweptBoxes::width; ++lane) four.set(lane, boxes[lane] = boxAnywhere(random));
        const SweptBox other = boxAnywhere(random);
        const unsigned found = bitsOf(meeting(four, other));
        for (int lane = 0; lane < FourSweptBoxes::width; ++lane) {
            QCOMPARE((found >> lane & 1) != 0, meet(boxes[lane], other));
            met += meet(boxes[lane], other);
        }
        QVERIFY(found < 16);
    }
    QVERIFY(met > 500 && met < 7500);
}

void tst_SweptBoxes::whatIsNowhereMeetsNothing() {
    constexpr double far = 1e6;
    const SweptBox everywhere({{-far, -far, -far}, {far, far, far}}, 0, {far, -far, far});
    FourSweptBoxes four;
    QCOMPARE(bitsOf(meeting(four, everywhere)), 0U);
    four.set(2, SweptBox({{0, 0, 0}, {1, 1, 1}}, 0));
    QCOMPARE(bitsOf(meeting(four, everywhere)), 4U);
}

TOILE_TEST(tst_SweptBoxes)
#include "tst_SweptBoxes.moc"
