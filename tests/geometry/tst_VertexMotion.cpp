// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/VertexMotion.h"
#include "tests/Suite.h"

#include <QTest>

using namespace toile;
using geometry::VertexMotion;

class tst_VertexMotion : public QObject {
    Q_OBJECT
private slots:
    void posesAreJoinedByStraightWays();
    void theFarthestWayIsThatOfTheFastestVertexInEveryPose();
    void whatNoBodyCanDoIsRefused_data();
    void whatNoBodyCanDoIsRefused();

private:
    /// Two vertices: one goes 1 m to the right and 2 m up, the other stays and goes 3 m up.
    VertexMotion motion_{0.5, {{{0, 0, 0}, {5, 0, 0}}, {{1, 0, 0}, {5, 0, 0}}, {{1, 2, 0}, {5, 3, 0}}}};
    geometry::TriangleMesh mesh_{{{0, 0, 0}, {5, 0, 0}}, {}};
};

void tst_VertexMotion::posesAreJoinedByStraightWays() {
    QCOMPARE(motion_.duration(), 1.0);
    std::vector<Vec3> at;
    motion_.at(-1, at);
    QVERIFY(at == motion_.poses[0]);
    motion_.at(0.25, at);
    QVERIFY(at == (std::vector<Vec3>{{0.5, 0, 0}, {5, 0, 0}}));
    motion_.at(0.75, at);
    QVERIFY(at == (std::vector<Vec3>{{1, 1, 0}, {5, 1.5, 0}}));
    for (const double time : {-1.0, 0.1, 0.3, 0.77, 3.0}) {
        motion_.at(time, at);
        QVERIFY(motion_.vertexAt(0, time) == at[0] && motion_.vertexAt(1, time) == at[1]);
    }
    motion_.at(7, at);
    QVERIFY(at == motion_.poses[2]);
}

void tst_VertexMotion::theFarthestWayIsThatOfTheFastestVertexInEveryPose() {
    QCOMPARE(motion_.farthest(0, 0.5), 1.0);
    QCOMPARE(motion_.farthest(0.1, 0.2), 0.2);
    QCOMPARE(motion_.farthest(0.25, 0.75), 0.5 + 1.5);
    QCOMPARE(motion_.farthest(0.9, 2), 0.6);
    QCOMPARE(motion_.farthest(1, 2), 0.0);
}

void tst_VertexMotion::whatNoBodyCanDoIsRefused_data() {
    QTest::addColumn<int>("what");
    QTest::addColumn<QString>("says");
    QTest::newRow("one pose") << 0 << "two poses";
    QTest::newRow("no time") << 1 << "takes time";
    QTest::newRow("a vertex too few") << 2 << "Pose 2 has 1 vertices, the body has 2";
    QTest::newRow("no number") << 3 << "pose 3 is not a finite number";
    QTest::newRow("another place") << 4 << "off by 20.0 mm";
}

void tst_VertexMotion::whatNoBodyCanDoIsRefused() {
    QFETCH(int, what);
    QFETCH(QString, says);
    QVERIFY(checkedMotion(motion_, mesh_, 0.01).has_value());
    VertexMotion wrong = motion_;
    if (what == 0) wrong.poses.resize(1);
    if (what == 1) wrong.step = 0;
    if (what == 2) wrong.poses[1].pop_back();
    if (what == 3) wrong.poses[2][1].z = std::nan("");
    if (what == 4) wrong.poses[0][0].y = 0.02;
    const auto checked = checkedMotion(wrong, mesh_, 0.01);
    QVERIFY(!checked);
    QVERIFY2(QString::fromStdString(checked.error().text).contains(says), checked.error().text.c_str());
}

TOILE_TEST(tst_VertexMotion)
#include "tst_VertexMotion.moc"
