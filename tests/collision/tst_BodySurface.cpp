// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/collision/BodySurface.h"
#include "core/collision/ClosestPoint.h"
#include "tests/Suite.h"
#include "tests/collision/Shapes.h"
#include "tests/collision/Surfaces.h"

#include <QTest>

#include <limits>
#include <thread>

using namespace toile;
using collision::BodySurface;
using geometry::TriangleMesh;
using shapes::anywhere;
using shapes::surfaceOf;

namespace {

/// Nearest distance by trying many points of the triangle: from above, and good to the step of the lattice.
double sampledDistance(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c, int steps) {
    double best = anywhere;
    for (int i = 0; i <= steps; ++i)
        for (int j = 0; i + j <= steps; ++j)
            best = std::min(best, distance(p, a + (b - a) * (double(i) / steps) + (c - a) * (double(j) / steps)));
    return best;
}

double bruteDistance(const TriangleMesh& mesh, const Vec3& p) {
    double best = anywhere;
    for (const auto& t : mesh.triangles)
        best = std::min(
            best,
            distance(
                p,
                collision::closestOnTriangle(p, mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]).point));
    return best;
}

/// Signed distance to the box [−h, h]³, in closed form.
double boxDistance(const Vec3& p, double h) {
    const Vec3 q{std::abs(p.x) - h, std::abs(p.y) - h, std::abs(p.z) - h};
    const Vec3 outside{std::max(q.x, 0.0), std::max(q.y, 0.0), std::max(q.z, 0.0)};
    return length(outside) + std::min(std::max({q.x, q.y, q.z}), 0.0);
}

} // namespace

class tst_BodySurface : public QObject {
    Q_OBJECT
private slots:
    void theClosestPointOfATriangleBeatsEverySampledPoint();
    void theTreeFindsWhatBruteForceFinds_data();
    void theTreeFindsWhatBruteForceFinds();
    void theSignIsThatOfTheWindingNumber();
    void theDistanceToABoxFollowsItsClosedForm();
    void theSignHoldsBesideEdgesAndCornersOfABox();
    void atASpikeEveryFaceCountsByItsAngle();
    void theNormalIsTheGradientOfTheDistance();
    void onTheSurfaceTheNormalIsThatOfTheSurface();
    void nothingIsFoundBeyondTheSearchRadius();
    void aTriangleWithoutAreaDoesNoHarm();
    void aMeshSplitAtItsSeamsHasNoCracks();
    void anOpenMeshHasTheSignOfItsSide();
    void brokenMeshesAreRefused();
    void manyThreadsFindTheSame();
};

void tst_BodySurface::theClosestPointOfATriangleBeatsEverySampledPoint() {
    std::mt19937 random(3);
    for (int n = 0; n < 300; ++n) {
        const Vec3 a = shapes::randomPoint(random, 1), b = shapes::randomPoint(random, 1),
                   c = shapes::randomPoint(random, 1), p = shapes::randomPoint(random, 2);
        const double found = distance(p, collision::closestOnTriangle(p, a, b, c).point);
        const double sampled = sampledDistance(p, a, b, c, 60);
        QVERIFY(found <= sampled + 1e-14);
        QVERIFY(sampled - found < 0.06); // edges are shorter than 3.5, the lattice has 60 steps
    }
}

void tst_BodySurface::theTreeFindsWhatBruteForceFinds_data() {
    QTest::addColumn<double>("away"); // [m]; boxes are of single precision
    QTest::newRow("about the origin") << 0.0;
    QTest::newRow("far away") << 1000.0;
}

void tst_BodySurface::theTreeFindsWhatBruteForceFinds() {
    QFETCH(double, away);
    TriangleMesh mesh = shapes::bumpySphere();
    const Vec3 centre{away, -away, 0};
    for (Vec3& v : mesh.vertices) v += centre;
    const auto surface = surfaceOf(std::move(mesh));
    const double rounding = 1e-14 + 1e-15 * away;
    std::mt19937 random(1);
    for (int n = 0; n < 2000; ++n) {
        const Vec3 p = centre + shapes::randomPoint(random, 1.4);
        const auto found = surface.nearest(p, anywhere);
        QVERIFY(found);
        const double gap = std::abs(found->signedDistance);
        QVERIFY(std::abs(gap - bruteDistance(surface.mesh(), p)) < rounding);
        QVERIFY(std::abs(distance(found->point, p) - gap) < rounding);
        const auto barely = surface.nearest(p, gap + 1e-9);
        QVERIFY(barely && std::abs(std::abs(barely->signedDistance) - gap) < rounding);
        QVERIFY(!surface.nearest(p, gap - 1e-9));
    }
}

void tst_BodySurface::theSignIsThatOfTheWindingNumber() {
    const auto surface = surfaceOf(shapes::bumpySphere(12, 16)); // coarse: sharp edges
    QVERIFY(surface.isClosed());
    std::mt19937 random(2);
    for (int n = 0; n < 4000; ++n) {
        Vec3 p = shapes::randomPoint(random, 1);
        if (n % 2) p = normalized(p) * (0.9 + 0.2 * (n % 100) / 100.0); // half of them near the surface
        const bool inside = shapes::windingNumber(surface.mesh(), p) > 0.5;
        QCOMPARE(surface.nearest(p, anywhere)->signedDistance < 0, inside);
    }
}

void tst_BodySurface::theDistanceToABoxFollowsItsClosedForm() {
    const auto surface = surfaceOf(shapes::box({-1, -1, -1}, {1, 1, 1}));
    std::mt19937 random(4);
    for (int n = 0; n < 5000; ++n) {
        const Vec3 p = shapes::randomPoint(random, 2);
        QVERIFY(std::abs(surface.nearest(p, anywhere)->signedDistance - boxDistance(p, 1)) < 1e-14);
    }
}

void tst_BodySurface::theSignHoldsBesideEdgesAndCornersOfABox() {
    const auto surface = surfaceOf(shapes::box({-1, -1, -1}, {1, 1, 1}));
    for (const double scale : {1e-3, 1e-6, 1e-9, 1e-12})
        for (int k = 0; k < 27; ++k) {
            const Vec3 side{k % 3 - 1.0, k / 3 % 3 - 1.0, k / 9 - 1.0}; // face, edge or corner; (0,0,0) = centre
            if (side == Vec3{}) continue;
            // the diagonals of the sides are edges too: stay on them and leave them
            for (const Vec3& along : {Vec3{}, Vec3{0.3, 0.3, 0.3}, Vec3{0.3, -0.1, 0.2}}) {
                Vec3 p = side;
                for (int axis = 0; axis < 3; ++axis)
                    if (side[axis] == 0) p[axis] = along[axis];
                QVERIFY(surface.nearest(p + side * scale, anywhere)->signedDistance > 0);
                QVERIFY(surface.nearest(p - side * scale, anywhere)->signedDistance < 0);
            }
        }
}

void tst_BodySurface::atASpikeEveryFaceCountsByItsAngle() {
    // a spike whose side towards +x is cut into many thin triangles: counted by number they would turn its tip's normal
    TriangleMesh spike{{{0, 1, 0}, {0, 0, 0}}, {}};
    std::vector<double> turns;
    for (int k = 0; k < 60; ++k) turns.push_back((k - 30) * 0.01);
    for (int k = 0; k < 12; ++k) turns.push_back(0.3 + k * (2 * std::numbers::pi - 0.6) / 12);
    for (const double turn : turns) spike.vertices.push_back({0.1 * std::cos(turn), 0, 0.1 * std::sin(turn)});
    const int rim = static_cast<int>(turns.size());
    for (int k = 0; k < rim; ++k) {
        const int here = 2 + k, next = 2 + (k + 1) % rim;
        spike.triangles.push_back({0, next, here});
        spike.triangles.push_back({1, here, next});
    }
    const auto surface = surfaceOf(spike);
    QVERIFY(surface.isClosed());
    for (const Vec3& direction : {Vec3{-0.99, 0.12, 0}, Vec3{0.99, 0.12, 0}, Vec3{0, 0.12, 0.99}, Vec3{0, 1, 0}}) {
        const auto found = surface.nearest(Vec3{0, 1, 0} + direction * 0.01, anywhere);
        QVERIFY(found->point == (Vec3{0, 1, 0}));
        QVERIFY(found->signedDistance > 0);
    }
}

void tst_BodySurface::theNormalIsTheGradientOfTheDistance() {
    const auto surface = surfaceOf(shapes::bumpySphere());
    std::mt19937 random(5);
    const double step = 1e-6;
    int compared = 0;
    for (int n = 0; n < 1000; ++n) {
        const Vec3 p = normalized(shapes::randomPoint(random, 1)) * 1.15; // outside: few points have two nearest ones
        const auto at = surface.nearest(p, anywhere);
        Vec3 gradient;
        for (int axis = 0; axis < 3; ++axis) {
            Vec3 more = p, less = p;
            more[axis] += step;
            less[axis] -= step;
            gradient[axis] =
                (surface.nearest(more, anywhere)->signedDistance - surface.nearest(less, anywhere)->signedDistance) /
                (2 * step);
        }
        QVERIFY(std::abs(length(at->normal) - 1) < 1e-12);
        if (std::abs(length(gradient) - 1) > 1e-3) continue; // two parts of the surface are equally near
        QVERIFY(distance(at->normal, gradient) < 1e-3);      // curvature of the distance at an edge: step / distance
        ++compared;
    }
    QVERIFY(compared > 900);
}

void tst_BodySurface::onTheSurfaceTheNormalIsThatOfTheSurface() {
    const auto surface = surfaceOf(shapes::box({-1, -1, -1}, {1, 1, 1}));
    QVERIFY(distance(surface.nearest({0.2, 1, 0.3}, 1)->normal, {0, 1, 0}) < 1e-12);
    QVERIFY(distance(surface.nearest({0.2, 1 + 1e-14, 0.3}, 1)->normal, {0, 1, 0}) < 1e-12);
    QVERIFY(distance(surface.nearest({1, 1, 0.3}, 1)->normal, normalized(Vec3{1, 1, 0})) < 1e-12);
    QVERIFY(distance(surface.nearest({1, 1, 1}, 1)->normal, normalized(Vec3{1, 1, 1})) < 1e-12); // angles are equal
}

void tst_BodySurface::nothingIsFoundBeyondTheSearchRadius() {
    const auto surface = surfaceOf(shapes::box({-1, -1, -1}, {1, 1, 1}));
    QVERIFY(!surface.nearest({0, 1.5, 0}, 0.49));
    QVERIFY(surface.nearest({0, 1.5, 0}, 0.51));
    QVERIFY(!surface.nearest({0, 0, 0}, 0.99)); // inside, too
    QVERIFY(surface.nearest({0, 1, 0}, 0));
}

void tst_BodySurface::aTriangleWithoutAreaDoesNoHarm() {
    auto mesh = shapes::box({-1, -1, -1}, {1, 1, 1});
    mesh.triangles.push_back({3, 3, 3});
    mesh.triangles.push_back({0, 0, 1});
    mesh.vertices.push_back({0, 1, -1}); // on the edge between 2 and 3
    mesh.triangles.push_back({2, 3, 8});
    const auto surface = surfaceOf(mesh);
    std::mt19937 random(6);
    for (int n = 0; n < 1000; ++n) {
        const Vec3 p = shapes::randomPoint(random, 2);
        const auto found = surface.nearest(p, anywhere);
        QVERIFY(std::abs(std::abs(found->signedDistance) - std::abs(boxDistance(p, 1))) < 1e-14);
        QVERIFY(isFinite(found->normal));
    }
}

void tst_BodySurface::aMeshSplitAtItsSeamsHasNoCracks() {
    const auto whole = shapes::bumpySphere(12, 16);
    TriangleMesh split;
    for (const auto& t : whole.triangles) {
        const int n = static_cast<int>(split.vertices.size());
        for (const int corner : t) split.vertices.push_back(whole.vertices[corner]);
        split.triangles.push_back({n, n + 1, n + 2});
    }
    const auto a = surfaceOf(whole), b = surfaceOf(split);
    QVERIFY(b.isClosed());
    std::mt19937 random(7);
    for (int n = 0; n < 1000; ++n) {
        const Vec3 p = shapes::randomPoint(random, 1.3);
        QVERIFY(std::abs(a.nearest(p, anywhere)->signedDistance - b.nearest(p, anywhere)->signedDistance) < 1e-14);
    }
}

void tst_BodySurface::anOpenMeshHasTheSignOfItsSide() {
    const auto surface = surfaceOf(shapes::plane(1, 4));
    QVERIFY(!surface.isClosed());
    QCOMPARE(surface.nearest({0.1, 0.2, 0.3}, anywhere)->signedDistance, 0.2);
    QCOMPARE(surface.nearest({0.1, -0.2, 0.3}, anywhere)->signedDistance, -0.2);
}

void tst_BodySurface::brokenMeshesAreRefused() {
    QVERIFY(!BodySurface::create({}));
    auto mesh = shapes::box({0, 0, 0}, {1, 1, 1});
    mesh.triangles[3][1] = 8;
    QVERIFY(!BodySurface::create(mesh));
    mesh.triangles[3][1] = -1;
    QVERIFY(!BodySurface::create(mesh));
    mesh = shapes::box({0, 0, 0}, {1, 1, 1});
    mesh.vertices[5].y = std::numeric_limits<double>::quiet_NaN();
    QVERIFY(!BodySurface::create(mesh));
}

void tst_BodySurface::manyThreadsFindTheSame() {
    const auto surface = surfaceOf(shapes::bumpySphere());
    const auto distances = [&](std::vector<double>& out) {
        std::mt19937 random(8);
        for (int n = 0; n < 3000; ++n)
            out.push_back(surface.nearest(shapes::randomPoint(random, 1.3), anywhere)->signedDistance);
    };
    std::vector<std::vector<double>> found(4);
    {
        std::vector<std::jthread> threads;
        for (auto& out : found) threads.emplace_back([&] { distances(out); });
    }
    for (const auto& out : found) QCOMPARE(out, found[0]);
}

TOILE_TEST(tst_BodySurface)
#include "tst_BodySurface.moc"
