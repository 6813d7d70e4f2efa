// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/Contracts.h"
#include "core/collision/MovingSurface.h"
#include "core/collision/SurfaceNormals.h"
#include "core/collision/SurfaceTracker.h"
#include "tests/Suite.h"
#include "tests/collision/Shapes.h"
#include "tests/collision/Surfaces.h"

#include <QTest>

using namespace toile;
using namespace toile::collision;
using geometry::VertexMotion;
using shapes::anywhere;

namespace {

/// Turned about the vertical, drawn out along it, and moved to the right.
std::vector<Vec3> bent(const std::vector<Vec3>& vertices, double turn, double stretch, double right) {
    std::vector<Vec3> out;
    for (const Vec3& v : vertices)
        out.push_back({std::cos(turn) * v.x + std::sin(turn) * v.z + right, stretch * v.y,
                       std::cos(turn) * v.z - std::sin(turn) * v.x});
    return out;
}

BodySurface freshly(const geometry::TriangleMesh& mesh) {
    auto surface = BodySurface::create(mesh);
    expects(surface.has_value(), "the shape of a test is sound");
    return std::move(*surface);
}

std::shared_ptr<const VertexMotion> motionOf(const geometry::TriangleMesh& mesh) {
    return std::make_shared<const VertexMotion>(
        VertexMotion{1, {mesh.vertices, bent(mesh.vertices, 0.4, 1.3, 0.5), bent(mesh.vertices, 1.5, 0.8, 2)}});
}

} // namespace

class tst_MovingSurface : public QObject {
    Q_OBJECT
private slots:
    void isTheSurfaceThatWouldBeMadeThere();
    void aTriangleMayBecomeASliverAndBack();
    void normalsOnDemandAreThoseOfTheTable();
    void everyPlaceKnowsItsWay();
    void pointsOffTheSurfaceAreCarriedAsByARigidBody();
    void trackedPointsAreFoundWhateverTheBodyDoes();
};

void tst_MovingSurface::isTheSurfaceThatWouldBeMadeThere() {
    const geometry::TriangleMesh mesh = shapes::bumpySphere();
    MovingSurface moving(mesh, motionOf(mesh), 10);
    std::mt19937 random(1);
    for (const double time : {9.0, 10.3, 11.2, 12.5, 10.7}) { // back in time, too
        moving.moveTo(time);
        const BodySurface fresh = freshly(moving.surface().mesh());
        for (int i = 0; i < 400; ++i) {
            const Vec3 p = shapes::randomPoint(random, 2);
            const auto there = moving.surface().nearest(p, anywhere), expected = fresh.nearest(p, anywhere);
            QVERIFY(std::abs(there->signedDistance - expected->signedDistance) < 1e-12);
            QVERIFY(geometry::distance(there->point, expected->point) < 1e-9);
            QVERIFY(geometry::distance(there->normal, expected->normal) < 1e-9);
        }
    }
    QCOMPARE(moving.ends(), 12.0);
    moving.moveTo(12);
    QVERIFY(moving.surface().mesh().vertices == motionOf(mesh)->poses.back());
}

void tst_MovingSurface::aTriangleMayBecomeASliverAndBack() {
    const geometry::TriangleMesh wide{{{0, 0, 0}, {1, 0, 0}, {0.3, 1, 0}}, {{0, 1, 2}}};
    geometry::TriangleMesh flat = wide;
    flat.vertices[2] = {0.7, 0, 0};
    BodySurface surface = freshly(wide);
    std::mt19937 random(2);
    for (const auto& mesh : {flat, wide, flat}) {
        surface.moveTo(mesh.vertices);
        const BodySurface fresh = freshly(mesh);
        for (int i = 0; i < 200; ++i) {
            const Vec3 p = shapes::randomPoint(random, 2);
            const auto there = surface.nearest(p, anywhere), expected = fresh.nearest(p, anywhere);
            QVERIFY(there->point == expected->point);
            QCOMPARE(std::abs(there->signedDistance), std::abs(expected->signedDistance));
        }
    }
}

void tst_MovingSurface::normalsOnDemandAreThoseOfTheTable() {
    geometry::TriangleMesh mesh = shapes::bumpySphere();
    mesh.vertices.push_back(mesh.vertices[5]); // split, as at a seam of its texture
    for (auto& triangle : mesh.triangles)
        if (std::ranges::find(triangle, 5) != triangle.end()) {
            *std::ranges::find(triangle, 5) = static_cast<int>(mesh.vertices.size()) - 1;
            break;
        }
    const SurfaceNormals table(mesh);
    const NormalsOnDemand asked(mesh);
    for (int f = 0; f < std::ssize(mesh.triangles); ++f)
        for (int part = 0; part < 7; ++part) {
            const auto at = static_cast<TrianglePart>(part);
            QVERIFY(geometry::distance(table.at(f, at), asked.at(mesh.vertices, f, at)) < 1e-12);
        }
}

void tst_MovingSurface::everyPlaceKnowsItsWay() {
    const geometry::TriangleMesh mesh = shapes::bumpySphere();
    MovingSurface moving(mesh, motionOf(mesh), 0);
    std::mt19937 random(2);
    moving.moveTo(0.25);
    const std::vector<Vec3> before = moving.surface().mesh().vertices;
    moving.moveTo(0.75);
    const std::vector<Vec3>& now = moving.surface().mesh().vertices;
    double farthest = 0;
    for (std::size_t v = 0; v < now.size(); ++v) farthest = std::max(farthest, geometry::distance(before[v], now[v]));
    QCOMPARE(moving.farthestWay(), farthest);
    QVERIFY(std::abs(moving.farthestBetween(0.25, 0.75) - farthest) < 1e-12); // in one straight way
    for (int f = 0; f < std::ssize(mesh.triangles); ++f) {
        std::uniform_real_distribution<double> share(0, 1);
        const double a = share(random), b = share(random) * (1 - a), c = 1 - a - b;
        const auto& [i, j, k] = mesh.triangles[f];
        const SurfacePoint place{0, now[i] * a + now[j] * b + now[k] * c, {}, f};
        const Vec3 way = place.point - (before[i] * a + before[j] * b + before[k] * c);
        QVERIFY(geometry::distance(moving.wayOf(place), way) < 1e-9);
    }
}

void tst_MovingSurface::pointsOffTheSurfaceAreCarriedAsByARigidBody() {
    const geometry::TriangleMesh mesh = shapes::bumpySphere();
    const auto turned = [&](const std::vector<Vec3>& points, int pose) {
        return bent(points, 0.7 * pose, 1, 0.3 * pose);
    };
    MovingSurface moving(mesh,
                         std::make_shared<const VertexMotion>(
                             VertexMotion{1, {mesh.vertices, turned(mesh.vertices, 1), turned(mesh.vertices, 2)}}),
                         10);
    std::mt19937 random(4);
    for (int i = 0; i < 300; ++i) {
        const Vec3 point = shapes::randomPoint(random, 1.5);
        const CarriedPlace place = moving.carried(point);
        for (int pose = 0; pose <= 2; ++pose)
            QVERIFY(geometry::distance(moving.at(place, 10 + pose), turned({point}, pose)[0]) < 1e-12);
        QVERIFY(moving.at(place, 5) == moving.at(place, 10) && moving.at(place, 20) == moving.at(place, 12));
    }
    QVERIFY(moving.surface().mesh().vertices == mesh.vertices); // it was only asked

    const geometry::TriangleMesh sliver{{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}}};
    std::vector<Vec3> lifted = sliver.vertices;
    for (Vec3& v : lifted) v.y += 1;
    const MovingSurface line(sliver, std::make_shared<const VertexMotion>(VertexMotion{1, {sliver.vertices, lifted}}),
                             0);
    QVERIFY(geometry::distance(line.at(line.carried({0.9, 0.5, 0.2}), 1), {0.9, 1.5, 0.2}) < 1e-12);
}

void tst_MovingSurface::trackedPointsAreFoundWhateverTheBodyDoes() {
    const geometry::TriangleMesh mesh = shapes::bumpySphere();
    MovingSurface moving(mesh, motionOf(mesh), 0);
    constexpr std::size_t count = 200;
    constexpr double reach = 0.2;
    SurfaceTracker tracker(moving.surface(), count, 1e-3);
    std::mt19937 random(3);
    std::vector<Vec3> points;
    for (std::size_t i = 0; i < count; ++i) points.push_back(shapes::randomPoint(random, 2.5));
    int far = 0;
    for (int step = 0; step <= 40; ++step) {
        moving.moveTo(0.05 * step);
        tracker.bodyMoved(moving.farthestWay());
        for (std::size_t i = 0; i < count; ++i) {
            points[i] += shapes::randomPoint(random, 0.01);
            const double distance = moving.surface().nearest(points[i], anywhere)->signedDistance;
            if (tracker.stillFar(i, points[i], reach)) {
                ++far;
                QVERIFY(distance > reach);
                continue;
            }
            const auto* plane = tracker.near(i, points[i], reach);
            QCOMPARE(plane != nullptr, distance <= reach);
            if (plane) QVERIFY(std::abs(plane->distance(points[i]) - distance) < 1e-9);
        }
    }
    QVERIFY(far > 1000); // or it would ask for everything
}

TOILE_TEST(tst_MovingSurface)
#include "tst_MovingSurface.moc"
