// SPDX-License-Identifier: GPL-3.0-or-later
#include <QtTest>

#ifndef Q_MOC_RUN // moc stumbles over the library's concepts
#include "core/meshing/ConstrainedDelaunay.h"
#include "core/meshing/FlatTriangles.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <set>
#endif

using namespace toile::meshing;

class tst_ConstrainedDelaunay : public QObject {
    Q_OBJECT
private slots:
    void orientationIsExactAtTheLimitOfTheGrid();
    void noOtherPointLiesInACircle();
    void constraintsAreEdges();
    void collinearAndCocircularPointsAreFilled();
    void theOrderOfPointsDoesNotMatter();
    void aFlatTriangleOnTheBorderIsTurned();
};

namespace {

std::size_t at(int i) {
    return static_cast<std::size_t>(i);
}

/// A star-shaped polygon of n corners round the origin, then inner points.
std::vector<GridPoint> starPoints(std::mt19937& random, int n, int inner) {
    std::uniform_real_distribution<double> radius(4e4, 1e5), any(-2e4, 2e4);
    std::vector<GridPoint> points;
    for (int i = 0; i < n; ++i) {
        const double r = radius(random), angle = 2 * M_PI * i / n;
        points.push_back({static_cast<int>(r * std::cos(angle)), static_cast<int>(r * std::sin(angle))});
    }
    for (int i = 0; i < inner; ++i) points.push_back({static_cast<int>(any(random)), static_cast<int>(any(random))});
    return points;
}

std::vector<Constraint> ringOf(int n) {
    std::vector<Constraint> ring;
    for (int i = 0; i < n; ++i) ring.push_back({i, (i + 1) % n, true});
    return ring;
}

std::int64_t doubledArea(const std::vector<GridPoint>& points, const std::vector<std::array<int, 3>>& triangles) {
    std::int64_t sum = 0;
    for (const auto& t : triangles) sum += orientation(points[at(t[0])], points[at(t[1])], points[at(t[2])]);
    return sum;
}

std::int64_t doubledRingArea(const std::vector<GridPoint>& points, int n) {
    std::int64_t sum = 0;
    for (int i = 0; i < n; ++i) {
        const GridPoint p = points[at(i)], q = points[at((i + 1) % n)];
        sum += std::int64_t{p.x} * q.y - std::int64_t{p.y} * q.x;
    }
    return sum;
}

} // namespace

void tst_ConstrainedDelaunay::orientationIsExactAtTheLimitOfTheGrid() {
    constexpr int far = gridLimit - 1; // one unit beside a line as long as the grid
    static_assert(orientation({-far, -far}, {far, far}, {0, 0}) == 0);
    static_assert(orientation({-far, -far}, {far, far}, {0, 1}) > 0);
    static_assert(!inCircle({far, 0}, {0, far}, {-far, 0}, {0, -far})); // on the circle is not inside
    static_assert(inCircle({far, 0}, {0, far}, {-far, 0}, {0, -far + 1}));
}

void tst_ConstrainedDelaunay::noOtherPointLiesInACircle() {
    for (unsigned seed = 1; seed <= 20; ++seed) {
        std::mt19937 random(seed);
        const int n = 30;
        const std::vector<GridPoint> points = starPoints(random, n, 60);
        const auto triangles = constrainedDelaunay(points, ringOf(n));
        QCOMPARE(doubledArea(points, triangles), doubledRingArea(points, n));
        QCOMPARE(static_cast<int>(triangles.size()), n + 2 * 60 - 2); // Euler
        for (const auto& t : triangles)
            for (int p = n; p < static_cast<int>(points.size()); ++p) { // inner points see one another: brute force
                const bool inner = t[0] >= n && t[1] >= n && t[2] >= n;
                if (inner)
                    QVERIFY2(!inCircle(points[at(t[0])], points[at(t[1])], points[at(t[2])], points[at(p)]),
                             qPrintable(QString::number(seed)));
            }
    }
}

void tst_ConstrainedDelaunay::constraintsAreEdges() {
    for (unsigned seed = 1; seed <= 50; ++seed) {
        std::mt19937 random(seed);
        const int n = 80; // spiky: many sides are no Delaunay edges
        const std::vector<GridPoint> points = starPoints(random, n, 5);
        std::set<std::pair<int, int>> edges;
        for (const auto& t : constrainedDelaunay(points, ringOf(n)))
            for (std::size_t i = 0; i < 3; ++i) edges.insert({t[i], t[(i + 1) % 3]});
        for (int i = 0; i < n; ++i) QVERIFY(edges.contains({i, (i + 1) % n}) && !edges.contains({(i + 1) % n, i}));
    }
}

void tst_ConstrainedDelaunay::collinearAndCocircularPointsAreFilled() {
    std::vector<GridPoint> points; // a 9 × 9 grid; its border is the ring
    std::vector<int> ring;
    for (int y = 0; y < 9; ++y)
        for (int x = 0; x < 9; ++x) points.push_back({x * 1000, y * 1000});
    for (int i = 0; i < 8; ++i) ring.push_back(i);
    for (int i = 0; i < 8; ++i) ring.push_back(i * 9 + 8);
    for (int i = 8; i > 0; --i) ring.push_back(72 + i);
    for (int i = 8; i > 0; --i) ring.push_back(i * 9);
    std::vector<Constraint> constraints;
    for (std::size_t i = 0; i < ring.size(); ++i) constraints.push_back({ring[i], ring[(i + 1) % ring.size()], true});
    const auto triangles = constrainedDelaunay(points, constraints);
    QCOMPARE(triangles.size(), std::size_t{128});
    QCOMPARE(doubledArea(points, triangles), std::int64_t{2} * 8000 * 8000);
}

void tst_ConstrainedDelaunay::theOrderOfPointsDoesNotMatter() {
    std::mt19937 random(7);
    const std::vector<GridPoint> points = starPoints(random, 20, 40);
    std::vector<int> order(points.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<int>(i);
    std::shuffle(order.begin(), order.end(), random);
    std::vector<GridPoint> shuffled;
    std::vector<int> placeOf(points.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        placeOf[at(order[i])] = static_cast<int>(i);
        shuffled.push_back(points[at(order[i])]);
    }
    std::vector<Constraint> ring;
    for (int i = 0; i < 20; ++i) ring.push_back({placeOf[at(i)], placeOf[at((i + 1) % 20)], true});
    const auto a = constrainedDelaunay(points, ringOf(20)), b = constrainedDelaunay(shuffled, ring);
    QCOMPARE(a.size(), b.size());
    for (std::size_t t = 0; t < a.size(); ++t)
        for (std::size_t i = 0; i < 3; ++i) QCOMPARE(placeOf[at(a[t][i])], b[t][i]);
}

void tst_ConstrainedDelaunay::aFlatTriangleOnTheBorderIsTurned() {
    // The middle node of a straight edge lies one unit beside it.
    const std::vector<GridPoint> points{{0, 0}, {1000, -1}, {2000, 0}, {1000, 1500}};
    std::vector<std::array<int, 3>> triangles{{0, 1, 2}, {0, 2, 3}};
    turnFlatTriangles(points, triangles);
    for (const auto& t : triangles) {
        QVERIFY(orientation(points[static_cast<std::size_t>(t[0])], points[static_cast<std::size_t>(t[1])],
                            points[static_cast<std::size_t>(t[2])]) > 1000000);
        QVERIFY(std::find(t.begin(), t.end(), 1) != t.end() && std::find(t.begin(), t.end(), 3) != t.end());
    }
    triangles = {{0, 1, 3}, {1, 2, 3}}; // nothing flat: nothing changes
    const auto before = triangles;
    turnFlatTriangles(points, triangles);
    QVERIFY(triangles == before);
}

QTEST_APPLESS_MAIN(tst_ConstrainedDelaunay)
#include "tst_ConstrainedDelaunay.moc"
