// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/collision/SmoothDistance.h"
#include "tests/Suite.h"
#include "tests/collision/Shapes.h"
#include "tests/collision/Surfaces.h"

#include <QTest>

using namespace toile;
using collision::BodySurface;
using collision::SmoothDistance;
using shapes::surfaceOf;

namespace {

/// Two slopes that meet at x = 0 and rise to both sides, y = |x|·tan(angle).
geometry::TriangleMesh groove(double angle) {
    geometry::TriangleMesh mesh = shapes::plane(0.5, 2);
    for (Vec3& v : mesh.vertices) v.y = std::abs(v.x) * std::tan(angle);
    return mesh;
}

double valueAt(SmoothDistance& distance, const Vec3& p) {
    SmoothDistance::Patch patch;
    return distance.at(p, patch).value;
}

constexpr double spacing = 0.0025;

} // namespace

class tst_SmoothDistance : public QObject {
    Q_OBJECT
private slots:
    void aboveAPlaneItIsTheHeight();
    void besideABallItIsTheDistanceAndTheStatedBias();
    void slopeAndCurvatureAreThoseOfTheValue();
    void itChangesNoFasterThanTheWay();
    void inAGrooveTheSlopeTurnsOverOneLatticeCell();
    void aRememberedPatchGivesWhatANewOneGives();
};

void tst_SmoothDistance::aboveAPlaneItIsTheHeight() {
    const auto body = surfaceOf(shapes::plane(1, 4, 0.3));
    SmoothDistance distance(body, spacing);
    std::mt19937 random(1);
    SmoothDistance::Patch patch;
    for (int n = 0; n < 100; ++n) {
        const Vec3 p = shapes::randomPoint(random, 0.4);
        const auto found = distance.at(p, patch);
        QVERIFY(std::abs(found.value - (p.y - 0.3)) < 1e-12);
        QVERIFY(geometry::distance(found.gradient, {0, 1, 0}) < 1e-9);
        for (const double second : found.hessian) QVERIFY(std::abs(second) < 1e-6);
    }
}

void tst_SmoothDistance::besideABallItIsTheDistanceAndTheStatedBias() {
    const double radius = 0.05;
    const auto body = surfaceOf(shapes::starBody(200, 400, [=](const Vec3&) { return radius; }));
    SmoothDistance distance(body, spacing);
    std::mt19937 random(2);
    const double faceted = radius * std::pow(std::numbers::pi / 200, 2) / 2; // sagitta of the triangles
    for (int n = 0; n < 200; ++n) {
        const Vec3 p = normalized(shapes::randomPoint(random, 1)) * (radius + 0.0034);
        const double bias = spacing * spacing / (3 * length(p)); // H = 1/R on the sphere through p
        SmoothDistance::Patch patch;
        const auto found = distance.at(p, patch);
        QVERIFY(std::abs(found.value - 0.0034 - bias) < 2 * faceted);
        QVERIFY(geometry::distance(found.gradient, normalized(p)) < 0.02);
    }
}

void tst_SmoothDistance::slopeAndCurvatureAreThoseOfTheValue() {
    const auto body = surfaceOf(shapes::box({-0.05, -0.05, -0.05}, {0.05, 0.05, 0.05}));
    SmoothDistance distance(body, spacing);
    std::mt19937 random(3);
    for (int n = 0; n < 200; ++n) {
        const Vec3 p = shapes::randomPoint(random, 0.06);
        SmoothDistance::Patch patch;
        const auto found = distance.at(p, patch);
        const double step = 1e-6;
        for (int axis = 0; axis < 3; ++axis) {
            Vec3 more = p, less = p;
            more[axis] += step;
            less[axis] -= step;
            SmoothDistance::Patch other;
            const auto up = distance.at(more, other), down = distance.at(less, other);
            QVERIFY(std::abs((up.value - down.value) / (2 * step) - found.gradient[axis]) < 1e-6);
            for (int row = 0; row < 3; ++row) // continuous, but with a kink at the faces of cells
                QVERIFY(std::abs((up.gradient[row] - down.gradient[row]) / (2 * step) - found.hessian[3 * row + axis]) <
                        step * 8 / (spacing * spacing));
        }
    }
}

void tst_SmoothDistance::itChangesNoFasterThanTheWay() {
    const auto body = surfaceOf(shapes::bumpySphere());
    SmoothDistance distance(body, 0.05);
    std::mt19937 random(4);
    for (int n = 0; n < 500; ++n) {
        const Vec3 p = normalized(shapes::randomPoint(random, 1)) * 1.1, q = p + shapes::randomPoint(random, 0.1);
        const double there = valueAt(distance, p);
        QVERIFY(std::abs(there - valueAt(distance, q)) <= geometry::distance(p, q) * (1 + 1e-12));
        QVERIFY(std::abs(there - body.nearest(p, 10)->signedDistance) <= 0.05);
    }
}

void tst_SmoothDistance::inAGrooveTheSlopeTurnsOverOneLatticeCell() {
    const double angle = 0.3;
    const auto body = surfaceOf(groove(angle));
    SmoothDistance distance(body, spacing);
    SmoothDistance::Patch patch;
    const auto sideways = [&](double x) { return distance.at({x, 0.004, 0.0007}, patch).gradient.x; };
    QVERIFY(std::abs(sideways(-2.1 * spacing) - std::sin(angle)) < 1e-9); // away from the wall that is nearer
    QVERIFY(std::abs(sideways(0)) < 1e-9);
    QVERIFY(std::abs(sideways(2.1 * spacing) + std::sin(angle)) < 1e-9);
    const double step = 1e-5;
    for (double x = -2.5 * spacing; x < 2.5 * spacing; x += step)
        QVERIFY(std::abs(sideways(x + step) - sideways(x)) < 2.01 * std::sin(angle) / spacing * step);
}

void tst_SmoothDistance::aRememberedPatchGivesWhatANewOneGives() {
    const auto body = surfaceOf(shapes::bumpySphere());
    SmoothDistance distance(body, 0.05);
    std::mt19937 random(5);
    SmoothDistance::Patch kept;
    Vec3 p{0, 1.1, 0};
    for (int n = 0; n < 300; ++n) {
        p += shapes::randomPoint(random, 0.02);
        QCOMPARE(distance.at(p, kept).value, valueAt(distance, p));
    }
}

TOILE_TEST(tst_SmoothDistance)
#include "tst_SmoothDistance.moc"
