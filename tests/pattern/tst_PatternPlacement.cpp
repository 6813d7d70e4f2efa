// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pattern/PatternPlacement.h"

#include <QtTest>

using namespace toile;
using namespace toile::pattern;

class tst_PatternPlacement : public QObject {
    Q_OBJECT
private slots:
    void aMirroredPlacementLiesOpposite_data();
    void aMirroredPlacementLiesOpposite();
};

void tst_PatternPlacement::aMirroredPlacementLiesOpposite_data() {
    QTest::addColumn<bool>("curled");
    QTest::newRow("flat") << false;
    QTest::newRow("curled about a slanting axis") << true;
}

void tst_PatternPlacement::aMirroredPlacementLiesOpposite() {
    QFETCH(bool, curled);
    Placement placement{{{0, 0, -1}, {0, 1, 0}, {1, 0, 0}, {0.3, 1.1, 0.05}}, {}}; // at the left, facing left
    if (curled) placement.curl = Curl{normalized(Vec2{0.3, 1}), 0.2};
    const Placement image = mirrored(placement);
    QVERIFY(isRigid(image.transform));
    for (const Vec2 p : {Vec2{0, 0}, {0.1, 0.2}, {-0.15, 0.05}}) {
        const Vec3 here = placed(placement, p), there = placed(image, {-p.x, p.y});
        QVERIFY(distance(there, {-here.x, here.y, here.z}) < 1e-12);
    }
}

QTEST_GUILESS_MAIN(tst_PatternPlacement)
#include "tst_PatternPlacement.moc"
