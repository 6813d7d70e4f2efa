// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/Openings.h"
#include "core/simulation/Worn.h"
#include "tests/Suite.h"

#include <QTest>
#include <cmath>
#include <numbers>

using namespace toile;
using namespace toile::simulation;

class tst_Openings : public QObject {
    Q_OBJECT
private slots:
    void aTubeHasTwo();
    void aClosedSurfaceHasNone();
    void degenerateTrianglesDoNotCount();
    void aLineThroughALoopCrossesItOnce();
    void aLineBesideALoopDoesNotCrossIt();
    void aLineThroughAndBackCrossesTwice();

private:
    static std::vector<std::array<int, 3>> tube(int around) {
        std::vector<std::array<int, 3>> triangles;
        for (int i = 0; i < around; ++i) {
            const int next = (i + 1) % around;
            triangles.push_back({i, next, around + i});
            triangles.push_back({next, around + next, around + i});
        }
        return triangles;
    }
    static std::vector<Vec3> circle(double height) {
        std::vector<Vec3> loop;
        for (int i = 0; i < 24; ++i) {
            const double angle = 2 * std::numbers::pi * i / 24 + 0.01;
            loop.push_back({std::cos(angle), height, std::sin(angle)});
        }
        return loop;
    }
};

void tst_Openings::aTubeHasTwo() {
    const auto openings = openingsOf(tube(8));
    QCOMPARE(openings.size(), std::size_t(2));
    QCOMPARE(openings[0].size(), std::size_t(8));
    QCOMPARE(openings[1].size(), std::size_t(8));
}

void tst_Openings::aClosedSurfaceHasNone() {
    const std::vector<std::array<int, 3>> tetrahedron{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
    QVERIFY(openingsOf(tetrahedron).empty());
}

void tst_Openings::degenerateTrianglesDoNotCount() {
    auto triangles = tube(8);
    triangles.push_back({3, 3, 9});
    QCOMPARE(openingsOf(triangles).size(), std::size_t(2));
}

void tst_Openings::aLineThroughALoopCrossesItOnce() {
    QCOMPARE(crossings(circle(0), {{0.2, 1, 0.1}, {0.1, -1, 0.2}}), 1);
}

void tst_Openings::aLineBesideALoopDoesNotCrossIt() {
    QCOMPARE(crossings(circle(0), {{2, 1, 0}, {2, -1, 0}}), 0);
}

void tst_Openings::aLineThroughAndBackCrossesTwice() {
    QCOMPARE(crossings(circle(0), {{0.2, 1, 0.1}, {0.3, -1, 0.1}, {0.5, 1, 0.3}}), 2);
}

TOILE_TEST(tst_Openings)
#include "tst_Openings.moc"
