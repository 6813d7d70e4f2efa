// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/collision/ElementPair.h"
#include "tests/Suite.h"

#include <QTest>
#include <algorithm>
#include <array>
#include <cmath>
#include <random>

using namespace toile;
using namespace toile::collision;
using geometry::Vec3;

namespace {

using Corners = std::array<Vec3, 4>;

constexpr ElementPair edges{{0, 1, 2, 3}, 2}, cornerAndTriangle{{0, 1, 2, 3}, 1};

/// Two edges of 20 mm that cross in their middles, the second below the first.
Corners crossedEdges(double apart) {
    return {Vec3{-0.01, 0, apart}, Vec3{0.01, 0, apart}, Vec3{0, -0.01, 0}, Vec3{0, 0.01, 0}};
}

/// Many looks on the way, with no regard to how far it is.
double leastDistanceSeen(const ElementPair& pair, const Corners& from, const Corners& to) {
    constexpr int looks = 2000;
    double least = separationOf(pair, from).distance;
    for (int look = 1; look <= looks; ++look) {
        Corners now;
        for (int i = 0; i < 4; ++i) now[i] = lerp(from[i], to[i], static_cast<double>(look) / looks);
        least = std::min(least, separationOf(pair, now).distance);
    }
    return least;
}

} // namespace

/// Whether the elements of a pair keep a distance on straight ways.
class tst_StayApart : public QObject {
    Q_OBJECT
private slots:
    void ofRandomWaysItSaysWhatManyLooksSee();
    void edgesThatTiltNeedNoPlaneBetweenThem();
    void whatPassesThroughDoesNot();
    void aWayThatIsSharedBringsNothingNearer();
    void whatIsTooNearFromTheBeginningDoesNot();
};

void tst_StayApart::ofRandomWaysItSaysWhatManyLooksSee() {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> place(-1, 1), fraction(0.05, 0.95);
    const auto anywhere = [&](double size) { return size * Vec3{place(random), place(random), place(random)}; };
    int apart = 0, near = 0, doubted = 0;
    for (int trial = 0; trial < 4000; ++trial) {
        const ElementPair& pair = trial % 2 ? edges : cornerAndTriangle;
        Corners from, to;
        for (int i = 0; i < 4; ++i) {
            from[i] = anywhere(1);
            to[i] = from[i] + anywhere(1);
        }
        const double least = fraction(random) * separationOf(pair, from).distance;
        const bool stays = stayApart(pair, from, to, least);
        const double seen = leastDistanceSeen(pair, from, to);
        if (stays) QVERIFY2(seen >= least * (1 - 1e-12), qPrintable(QString("%1 %2").arg(seen).arg(least)));
        else if (seen > 1.02 * least) ++doubted;
        ++(stays ? apart : near);
    }
    QVERIFY2(apart > 800 && near > 800, qPrintable(QString("%1 %2").arg(apart).arg(near)));
    QVERIFY2(doubted < 40, qPrintable(QString::number(doubted)));
}

/// One end goes down by a hundred times the distance, while the place where they cross rises.
void tst_StayApart::edgesThatTiltNeedNoPlaneBetweenThem() {
    constexpr double distance = 1e-6;
    const Corners from = crossedEdges(distance);
    Corners to = from;
    to[0].z -= 100 * distance;
    to[1].z += 103 * distance;
    QVERIFY(gapAlong({0, 0, 1}, edges, from) > 0 && gapAlong({0, 0, 1}, edges, to) < 0);
    QVERIFY(stayApart(edges, from, to, 0.1 * distance));
    to[1].z -= 6 * distance; // the middle falls by one and a half distances
    QVERIFY(!stayApart(edges, from, to, 0.1 * distance));
}

void tst_StayApart::whatPassesThroughDoesNot() {
    const Corners above = crossedEdges(0.001), below = crossedEdges(-0.001);
    QVERIFY(!stayApart(edges, above, below, 1e-9));
    const Corners corner{Vec3{0, 0, 0.001}, Vec3{-1, -1, 0}, Vec3{1, -1, 0}, Vec3{0, 1, 0}};
    Corners through = corner;
    through[0].z = -0.001;
    QVERIFY(!stayApart(cornerAndTriangle, corner, through, 1e-9));
    through[0] = {3, 0, 0.001}; // above it, and away
    QVERIFY(stayApart(cornerAndTriangle, corner, through, 0.0009));
}

void tst_StayApart::aWayThatIsSharedBringsNothingNearer() {
    const Corners from = crossedEdges(1e-6);
    Corners to = from;
    for (Vec3& corner : to) corner += Vec3{1, 2, -3};
    QVERIFY(stayApart(edges, from, to, 0.9e-6));
    QVERIFY(stayApart(edges, from, from, 0.9e-6));
}

void tst_StayApart::whatIsTooNearFromTheBeginningDoesNot() {
    const Corners from = crossedEdges(0.001);
    QVERIFY(!stayApart(edges, from, crossedEdges(0.002), 0.001));
    QVERIFY(stayApart(edges, from, crossedEdges(0.002), 0.00098));
}

TOILE_TEST(tst_StayApart)
#include "tst_StayApart.moc"
