// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pattern/PatternPlacement.h"
#include "tests/Suite.h"

#include <QTest>
#include <cmath>
#include <optional>

using namespace toile;
using namespace toile::pattern;

class tst_PatternPlacement : public QObject {
    Q_OBJECT
private slots:
    void aMirroredPlacementLiesOpposite_data();
    void aMirroredPlacementLiesOpposite();
    void aCurlFacesItsRightSideOutwardOrInward();
    void aPieceMovedOutwardIsWiderAboutTheSameMiddle();
};

void tst_PatternPlacement::aMirroredPlacementLiesOpposite_data() {
    QTest::addColumn<std::optional<Curl>>("curl");
    QTest::newRow("flat") << std::optional<Curl>();
    QTest::newRow("curled about a slanting axis") << std::optional(Curl{normalized(Vec2{0.3, 1}), 0.2});
    QTest::newRow("rolled along a bent line")
        << std::optional(Curl{{0, 1}, 0.1, BentLine{-0.1, {{0, -0.1, 0}, {0, 0.05, 0}, {0.06, 0.15, -0.03}}}});
}

void tst_PatternPlacement::aMirroredPlacementLiesOpposite() {
    QFETCH(std::optional<Curl>, curl);
    const Placement placement{{{0, 0, -1}, {0, 1, 0}, {1, 0, 0}, {0.3, 1.1, 0.05}}, curl}; // at the left, facing left
    const Placement image = mirrored(placement);
    QVERIFY(isRigid(image.transform));
    for (const Vec2 p : {Vec2{0, 0}, {0.1, 0.2}, {-0.15, 0.05}}) {
        const Vec3 here = placed(placement, p), there = placed(image, {-p.x, p.y});
        QVERIFY(distance(there, {-here.x, here.y, here.z}) < 1e-12);
    }
}

void tst_PatternPlacement::aCurlFacesItsRightSideOutwardOrInward() {
    for (const double radius : {0.2, -0.2}) { // the piece's x and y axes are the world's: its right side faces +z
        const Placement placement{{}, Curl{{0, 1}, radius}};
        for (const double s : {-0.1, 0.05, 0.3}) {
            const Vec3 p = placed(placement, {s, 0.1});
            QVERIFY(std::abs(std::hypot(p.x, p.z + radius) - 0.2) < 1e-12); // round a middle behind it, or before it
            QVERIFY(std::abs(p.x - 0.2 * std::sin(s / 0.2)) < 1e-12);
        }
    }
}

void tst_PatternPlacement::aPieceMovedOutwardIsWiderAboutTheSameMiddle() {
    for (const double radius : {0.2, -0.2}) {
        const Placement placement{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 1, 0}}, Curl{{0, 1}, radius}};
        const Placement moved = movedOutward(placement, 0.03);
        QCOMPARE(std::abs(moved.curl->radius), 0.23);
        const Vec3 middle = placement.transform.origin - Vec3{0, 0, radius};
        QVERIFY(distance(moved.transform.origin - Vec3{0, 0, moved.curl->radius}, middle) < 1e-12);
    }
    const Placement flat = movedOutward({{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {}}, {}}, 0.03);
    QVERIFY(distance(flat.transform.origin, {0, 0, 0.03}) < 1e-12);
}

TOILE_TEST(tst_PatternPlacement, QCoreApplication)
#include "tst_PatternPlacement.moc"
