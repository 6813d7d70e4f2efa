// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/collision/ExactGeometry.h"
#include "core/collision/Intersections.h"
#include "tests/Suite.h"
#include "tests/collision/Shapes.h"

#include <QTest>

#include <array>

using namespace toile;
using collision::intersectingTriangles;
using collision::selfIntersectingTriangles;
using geometry::TriangleMesh;
using Pairs = std::vector<std::pair<int, int>>;

using Nine = std::array<double, 9>;

namespace {

TriangleMesh triangle(const Vec3& a, const Vec3& b, const Vec3& c) {
    return {{a, b, c}, {{0, 1, 2}}};
}

bool meet(const TriangleMesh& a, const TriangleMesh& b) {
    const bool found = !intersectingTriangles(a, b).empty();
    const bool turned = !intersectingTriangles(b, a).empty();
    if (found != turned) qFatal("the answer depends on the order of the triangles");
    return found;
}

/// Whether two convex sets of points are apart, by the axes on which their shadows may part: a referee of another kind.
bool separable(const std::array<Vec3, 3>& a, const std::array<Vec3, 3>& b) {
    const Vec3 normalA = cross(a[1] - a[0], a[2] - a[0]), normalB = cross(b[1] - b[0], b[2] - b[0]);
    std::vector<Vec3> axes{normalA, normalB};
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
            const Vec3 edgeA = a[(i + 1) % 3] - a[i], edgeB = b[(j + 1) % 3] - b[j];
            axes.insert(axes.end(), {cross(edgeA, edgeB), cross(normalA, edgeA), cross(normalB, edgeB)});
        }
    for (const Vec3& axis : axes) {
        double lowA = 1e300, highA = -1e300, lowB = 1e300, highB = -1e300;
        for (int k = 0; k < 3; ++k) {
            lowA = std::min(lowA, dot(axis, a[k])), highA = std::max(highA, dot(axis, a[k]));
            lowB = std::min(lowB, dot(axis, b[k])), highB = std::max(highB, dot(axis, b[k]));
        }
        if (highA < lowB || highB < lowA) return true;
    }
    return false;
}

std::array<Vec3, 3> cornersOf(const TriangleMesh& mesh, int f) {
    const auto& t = mesh.triangles[f];
    return {mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]};
}

TriangleMesh moved(TriangleMesh mesh, const Vec3& by) {
    for (Vec3& v : mesh.vertices) v += by;
    return mesh;
}

} // namespace

class tst_Intersections : public QObject {
    Q_OBJECT
private slots:
    void crossingTrianglesMeetAndPartedOnesDoNot();
    void touchingCounts_data();
    void touchingCounts();
    void onTheGridEveryAnswerIsThatOfSeparatingAxes();
    void aNanometreDecides();
    void theSweepFindsWhatAllPairsFind();
    void spheresThatOverlapMeetAndNestedOnesDoNot();
    void aFoldedStripCrossesItselfOnlyWhenPushedThrough();
    void neighboursAreNotCompared();
    void farAwayMeshesKeepAnExactGrid();
};

void tst_Intersections::crossingTrianglesMeetAndPartedOnesDoNot() {
    const auto flat = triangle({0, 0, 0}, {1, 0, 0}, {0, 0, 1});
    QVERIFY(meet(flat, triangle({0.2, -1, 0.2}, {0.2, 1, 0.2}, {0.3, 1, 0.3})));
    QVERIFY(!meet(flat, triangle({0.2, 0.1, 0.2}, {0.2, 1, 0.2}, {0.3, 1, 0.3})));
    QVERIFY(!meet(flat, triangle({0.8, -1, 0.8}, {0.8, 1, 0.8}, {0.9, 1, 0.9}))); // crosses the plane beside it
}

void tst_Intersections::touchingCounts_data() {
    QTest::addColumn<Nine>("other");
    QTest::addColumn<bool>("expected");
    const auto row = [](const char* what, Nine other, bool expected) { QTest::newRow(what) << other << expected; };
    row("corner on the inside", {0.25, 0, 0.25, 0.25, 1, 0.25, 0.5, 1, 0.25}, true);
    row("corner on an edge", {0.5, 0, 0, 0.5, 1, 0, 0.75, 1, 0}, true);
    row("corner on a corner", {1, 0, 0, 1, 1, 0, 2, 1, 0}, true);
    row("edges cross", {0.5, -1, -0.5, 0.5, 1, 0.5, 2, 0, -2}, true);
    row("edge on edge", {0.25, 0, 0, 0.75, 0, 0, 0.5, 1, 0}, true);
    row("the same triangle", {0, 0, 0, 1, 0, 0, 0, 0, 1}, true);
    row("in the plane, one within the other", {0.125, 0, 0.125, 0.25, 0, 0.125, 0.125, 0, 0.25}, true);
    row("in the plane, round the other", {-4, 0, -4, 16, 0, -4, -4, 0, 16}, true);
    row("in the plane, overlapping", {0.25, 0, -0.25, 0.25, 0, 2, 2, 0, 0.25}, true);
    row("in the plane, beside it", {2, 0, 0, 3, 0, 0, 2, 0, 1}, false);
    row("parallel above", {0, 0.5, 0, 1, 0.5, 0, 0, 0.5, 1}, false);
    row("a needle through it", {0.25, -1, 0.25, 0.25, 1, 0.25, 0.25, 0.5, 0.25}, true);
    row("a needle beside it", {0.75, -1, 0.75, 0.75, 1, 0.75, 0.75, 0.5, 0.75}, false);
    row("a needle in its plane", {-1, 0, 0.25, 2, 0, 0.25, 0, 0, 0.25}, true);
    row("a point on it", {0.25, 0, 0.25, 0.25, 0, 0.25, 0.25, 0, 0.25}, true);
    row("a point above it", {0.25, 0.5, 0.25, 0.25, 0.5, 0.25, 0.25, 0.5, 0.25}, false);
}

void tst_Intersections::touchingCounts() {
    QFETCH(Nine, other);
    QFETCH(bool, expected);
    const auto flat = triangle({0, 0, 0}, {1, 0, 0}, {0, 0, 1});
    const Vec3 a{other[0], other[1], other[2]}, b{other[3], other[4], other[5]}, c{other[6], other[7], other[8]};
    QCOMPARE(meet(flat, triangle(a, b, c)), expected);
    QCOMPARE(meet(flat, triangle(c, b, a)), expected);
}

void tst_Intersections::onTheGridEveryAnswerIsThatOfSeparatingAxes() {
    // corners on a 5 x 5 x 5 lattice: every special position comes up, and doubles are exact
    std::mt19937 random(11);
    std::uniform_int_distribution<int> step(0, 4);
    const auto corner = [&] {
        const int x = step(random), y = step(random), z = step(random);
        return Vec3(x, y, z);
    };
    int meeting = 0, compared = 0;
    for (int n = 0; n < 40000; ++n) {
        const std::array a{corner(), corner(), corner()}, b{corner(), corner(), corner()};
        if (cross(a[1] - a[0], a[2] - a[0]) == Vec3{} || cross(b[1] - b[0], b[2] - b[0]) == Vec3{}) continue;
        const bool found = meet(triangle(a[0], a[1], a[2]), triangle(b[0], b[1], b[2]));
        QCOMPARE(found, !separable(a, b));
        meeting += found;
        ++compared;
    }
    QVERIFY(meeting > compared / 10 && meeting < compared * 9 / 10); // both answers were really asked for
}

void tst_Intersections::aNanometreDecides() {
    const double nanometre = std::ldexp(1.0, -30);
    const auto flat = triangle({-1, 0, -1}, {1, 0, -1}, {0, 0, 1});
    QVERIFY(meet(flat, triangle({0, 0, 0}, {0.1, 1, 0}, {-0.1, 1, 0})));
    QVERIFY(!meet(flat, triangle({0, nanometre, 0}, {0.1, 1, 0}, {-0.1, 1, 0})));
    QVERIFY(meet(flat, triangle({0, -nanometre, 0}, {0.1, 1, 0}, {-0.1, 1, 0})));
}

void tst_Intersections::theSweepFindsWhatAllPairsFind() {
    const auto a = shapes::bumpySphere(14, 18), b = moved(shapes::bumpySphere(13, 17), {0.7, 0.31, -0.23});
    Pairs expected;
    for (int i = 0; i < int(a.triangles.size()); ++i)
        for (int j = 0; j < int(b.triangles.size()); ++j)
            if (!separable(cornersOf(a, i), cornersOf(b, j))) expected.emplace_back(i, j);
    QVERIFY(expected.size() > 20);
    QCOMPARE(intersectingTriangles(a, b), expected); // generic position: rounding of the referee does not matter
}

void tst_Intersections::spheresThatOverlapMeetAndNestedOnesDoNot() {
    const auto sphere = [](double r) { return shapes::starBody(20, 30, [r](const Vec3&) { return r; }); };
    QVERIFY(intersectingTriangles(sphere(1), sphere(0.9)).empty());
    QVERIFY(!intersectingTriangles(sphere(1), moved(sphere(0.9), {0.3, 0, 0})).empty());
    QVERIFY(intersectingTriangles(sphere(1), moved(sphere(1), {2.5, 0, 0})).empty());
    QVERIFY(selfIntersectingTriangles(shapes::bumpySphere()).empty());
}

void tst_Intersections::aFoldedStripCrossesItselfOnlyWhenPushedThrough() {
    // a strip of ten cells, the last three folded back over the first ones at a height
    const auto strip = [](double height) {
        TriangleMesh mesh;
        for (int i = 0; i <= 10; ++i)
            for (const double z : {0.0, 0.1}) {
                const double x = i <= 5 ? 0.1 * i : 0.1 * (10.37 - i);
                const double y = i <= 5 ? 0 : i == 10 ? height : 0.05;
                mesh.vertices.push_back({x, y, z});
            }
        for (int i = 0; i < 10; ++i) {
            mesh.triangles.push_back({2 * i, 2 * i + 1, 2 * i + 2});
            mesh.triangles.push_back({2 * i + 1, 2 * i + 3, 2 * i + 2});
        }
        return mesh;
    };
    QVERIFY(selfIntersectingTriangles(strip(0.01)).empty());
    const auto crossing = selfIntersectingTriangles(strip(-0.01));
    QVERIFY(!crossing.empty());
    for (const auto& [a, b] : crossing) QVERIFY(a < 2 && b >= 18); // the first cell and the last
}

void tst_Intersections::neighboursAreNotCompared() {
    TriangleMesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 0, 1}, {1, 0, 1}}, {{0, 1, 2}, {1, 3, 2}}};
    QVERIFY(selfIntersectingTriangles(mesh).empty());
    // two pieces sewn together: other vertices at the same place
    mesh = {{{0, 0, 0}, {1, 0, 0}, {0, 0, 1}, {1, 0, 0}, {0, 0, 1}, {1, 0, 1}}, {{0, 1, 2}, {3, 5, 4}}};
    QVERIFY(selfIntersectingTriangles(mesh).empty());
}

void tst_Intersections::farAwayMeshesKeepAnExactGrid() {
    const Vec3 far{3e6, -2e6, 1e6}; // the grid there is 2⁻¹⁷ m
    const auto flat = moved(triangle({-1, 0, -1}, {1, 0, -1}, {0, 0, 1}), far);
    QVERIFY(meet(flat, moved(triangle({0, -0.5, 0}, {0.1, 1, 0}, {-0.1, 1, 0}), far)));
    QVERIFY(!meet(flat, moved(triangle({0, 0.001, 0}, {0.1, 1, 0}, {-0.1, 1, 0}), far)));
}

TOILE_TEST(tst_Intersections)
#include "tst_Intersections.moc"
