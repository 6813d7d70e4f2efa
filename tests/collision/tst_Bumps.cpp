// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/collision/Bumps.h"
#include "tests/Suite.h"

#include <QTest>
#include <cmath>
#include <numbers>

using namespace toile;
using namespace toile::collision;

namespace {

/// A ball by angles of latitude and longitude.
geometry::TriangleMesh ball(double radius) {
    geometry::TriangleMesh mesh;
    constexpr int bands = 24, around = 48;
    for (int i = 0; i <= bands; ++i)
        for (int k = 0; k < around; ++k) {
            const double up = std::numbers::pi * i / bands, turn = 2 * std::numbers::pi * k / around;
            mesh.vertices.push_back(Vec3{std::sin(up) * std::sin(turn), -std::cos(up), std::sin(up) * std::cos(turn)} *
                                    radius);
        }
    for (int i = 0; i < bands; ++i)
        for (int k = 0; k < around; ++k) {
            const int a = i * around + k, b = i * around + (k + 1) % around;
            mesh.triangles.push_back({a, b, b + around});
            mesh.triangles.push_back({a, b + around, a + around});
        }
    return mesh;
}

/// Facing inward: a hollow.
geometry::TriangleMesh turned(geometry::TriangleMesh mesh) {
    for (auto& t : mesh.triangles) std::swap(t[1], t[2]);
    return mesh;
}

/// Of the corners, against a ball of 25 mm. At the poles, a twelfth of them, faces have no area and tell nothing.
double shareOfBumps(const geometry::TriangleMesh& mesh) {
    return static_cast<double>(bumpsOf(mesh, 0.025).size()) / static_cast<double>(mesh.vertices.size());
}

} // namespace

class tst_Bumps : public QObject {
    Q_OBJECT
private slots:
    void aSmallBallIsABump();
    void aLargerBallIsNone();
    void aHollowIsNone();
};

void tst_Bumps::aSmallBallIsABump() {
    QVERIFY(shareOfBumps(ball(0.008)) > 0.9);
}

void tst_Bumps::aLargerBallIsNone() {
    QVERIFY(shareOfBumps(ball(0.04)) < 0.1);
}

void tst_Bumps::aHollowIsNone() {
    QVERIFY(shareOfBumps(turned(ball(0.008))) < 0.1);
}

TOILE_TEST(tst_Bumps)
#include "tst_Bumps.moc"
