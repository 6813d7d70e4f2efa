// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/picture/Picking.h"
#include "tests/Suite.h"

#include <QTest>

#include <random>

using namespace toile;
using namespace toile::picture;

namespace {

constexpr double hitRounding = 1e-9;

/// Two squares of two triangles, one metre wide: piece "near" at z = 1, piece "far" at z = 0.
simulation::Frame twoSquares() {
    simulation::FrameTopology topology;
    simulation::Frame frame;
    for (const double z : {1.0, 0.0}) {
        const int v = static_cast<int>(frame.positions.size()), t = static_cast<int>(topology.triangles.size());
        frame.positions.insert(frame.positions.end(), {{0, 0, z}, {1, 0, z}, {1, 1, z}, {0, 1, z}});
        topology.triangles.insert(topology.triangles.end(), {{v, v + 1, v + 2}, {v, v + 2, v + 3}});
        topology.pieces.push_back({z > 0 ? "near" : "far", "", v, 4, t, 2});
    }
    frame.topology = Shared(std::move(topology));
    return frame;
}

} // namespace

class tst_Picking : public QObject {
    Q_OBJECT
private slots:
    void barycentricWeightsGiveThePoint();
    void bothSidesCount();
    void nothingBehindTheOriginIsHit();
    void aRayInThePlaneMisses();
    void theNearestPieceIsPicked();
    void beyondThePiecesNothingIsPicked();
};

void tst_Picking::barycentricWeightsGiveThePoint() {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> any(-1, 1), weight(0.05, 1);
    const auto point = [&] { return Vec3{any(random), any(random), any(random)}; };
    for (int i = 0; i < 1000; ++i) {
        const Vec3 a = point(), b = point(), c = point(), eye = point() * 5.0;
        const double wa = weight(random), wb = weight(random), wc = weight(random);
        const Vec3 wanted = (a * wa + b * wb + c * wc) / (wa + wb + wc);
        if (std::abs(dot(cross(b - a, c - a), normalized(wanted - eye))) < 1e-3) continue; // seen edge-on
        const auto hit = intersection({eye, normalized(wanted - eye)}, a, b, c);
        QVERIFY(hit);
        QVERIFY(std::abs(hit->distance - distance(eye, wanted)) < hitRounding);
        const auto [u, v, w] = hit->barycentric;
        QVERIFY(distance(a * u + b * v + c * w, wanted) < hitRounding);
        QVERIFY(std::abs(u + v + w - 1) < hitRounding);
    }
}

void tst_Picking::bothSidesCount() {
    QVERIFY(intersection({{0.2, 0.2, 1}, {0, 0, -1}}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}));
    QVERIFY(intersection({{0.2, 0.2, -1}, {0, 0, 1}}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}));
}

void tst_Picking::nothingBehindTheOriginIsHit() {
    QVERIFY(!intersection({{0.2, 0.2, 1}, {0, 0, 1}}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}));
}

void tst_Picking::aRayInThePlaneMisses() {
    QVERIFY(!intersection({{-1, 0.2, 0}, {1, 0, 0}}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}));
}

void tst_Picking::theNearestPieceIsPicked() {
    const simulation::Frame frame = twoSquares();
    const auto front = pickCloth({{0.25, 0.5, 3}, {0, 0, -1}}, frame);
    QVERIFY(front);
    QCOMPARE(front->piece, std::string("near"));
    QCOMPARE(front->triangle, 1);
    QVERIFY(distance(front->point, {0.25, 0.5, 1}) < hitRounding);
    QCOMPARE(pickCloth({{0.25, 0.5, -3}, {0, 0, 1}}, frame)->piece, std::string("far"));
}

void tst_Picking::beyondThePiecesNothingIsPicked() {
    QVERIFY(!pickCloth({{1.5, 0.5, 3}, {0, 0, -1}}, twoSquares()));
}

TOILE_TEST(tst_Picking)
#include "tst_Picking.moc"
