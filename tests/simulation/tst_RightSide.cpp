// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest> // first: moc 6.4 stumbles over <compare> as the first header

#include "core/collision/Intersections.h"
#include "core/simulation/RightSide.h"
#include "tests/Suite.h"
#include "tests/simulation/Tubes.h"

#include <random>

using namespace toile;
using namespace toile::simulation;
using geometry::TriangleMesh;

namespace {

constexpr int pointsAround = 24;

TriangleMesh tube(double low = 0.6, double high = 1.0, double radius = 0.13) {
    std::vector<std::vector<Vec3>> rings;
    for (int r = 0; r <= 8; ++r) rings.push_back(tubes::ring({0, low + (high - low) * r / 8, 0}, radius, pointsAround));
    return tubes::throughRings(rings);
}

/// A skirt whose hem lies in folds like omegas: neighbouring folds almost touch outside and are wide inside, so that
/// much of it faces the middle line and the rim goes to and fro by more than it gets on, and up and down by `wave` [m].
TriangleMesh skirtInDeepFolds(double wave) {
    constexpr int points = 240, rows = 12, folds = 9;
    std::vector<std::vector<Vec3>> rings;
    for (int r = 0; r <= rows; ++r) {
        const double down = 1 - static_cast<double>(r) / rows; // 1 at the hem
        std::vector<Vec3> ring;
        for (int i = 0; i < points; ++i) {
            const double turn = 2 * std::numbers::pi * i / points;
            const double radius = 0.12 + 0.15 * down + 0.12 * down * std::cos(folds * turn);
            const double angle = turn + down * 0.16 * std::sin(2 * folds * turn);
            ring.push_back({radius * std::cos(angle), 0.5 + 0.5 * (1 - down) + wave * down * std::sin(folds * turn),
                            -radius * std::sin(angle)});
        }
        rings.push_back(std::move(ring));
    }
    return tubes::throughRings(rings);
}

void turnOver(TriangleMesh& mesh, std::size_t first, std::size_t last) {
    for (std::size_t t = first; t < last; ++t) std::swap(mesh.triangles[t][1], mesh.triangles[t][2]);
}

void append(TriangleMesh& mesh, const TriangleMesh& more) {
    const int first = static_cast<int>(mesh.vertices.size());
    for (const auto& [a, b, c] : more.triangles) mesh.triangles.push_back({a + first, b + first, c + first});
    mesh.vertices.insert(mesh.vertices.end(), more.vertices.begin(), more.vertices.end());
}

double shareOf(const TriangleMesh& mesh) {
    return rightSideOutShare(mesh.triangles, mesh.vertices);
}

double areaOf(const TriangleMesh& mesh, const geometry::TriangleIndices& t) {
    return 0.5 * length(cross(mesh.vertices[t[1]] - mesh.vertices[t[0]], mesh.vertices[t[2]] - mesh.vertices[t[0]]));
}

/// The share that faces away from the upright middle line: what a fold must not be judged by.
double shareFacingAway(const TriangleMesh& mesh) {
    double away = 0, whole = 0;
    for (const auto& t : mesh.triangles) {
        const Vec3 &a = mesh.vertices[t[0]], &b = mesh.vertices[t[1]], &c = mesh.vertices[t[2]];
        const Vec3 centre = (a + b + c) / 3;
        whole += areaOf(mesh, t);
        if (dot(cross(b - a, c - a), Vec3{centre.x, 0, centre.z}) > 0) away += areaOf(mesh, t);
    }
    return away / whole;
}

bool meets(const Vec3& from, const Vec3& to, const Vec3& a, const Vec3& b, const Vec3& c, int& sign) {
    const Vec3 way = to - from, normal = cross(b - a, c - a);
    const double before = dot(normal, from - a), after = dot(normal, to - a);
    if ((before < 0) == (after < 0)) return false;
    const Vec3 at = from + way * (before / (before - after));
    sign = after > before ? 1 : -1; // leaves through the front
    return dot(cross(b - a, at - a), normal) >= 0 && dot(cross(c - b, at - b), normal) >= 0 &&
           dot(cross(a - c, at - c), normal) >= 0;
}

/// The referee: a thread from just before each triangle to a place far away may not enter the garment more often than
/// it leaves it. It goes level, far from the openings above and below, which therefore need not be closed.
double shareByThreads(const TriangleMesh& mesh) {
    double right = 0, whole = 0;
    for (const auto& t : mesh.triangles) {
        const Vec3 &a = mesh.vertices[t[0]], &b = mesh.vertices[t[1]], &c = mesh.vertices[t[2]];
        const Vec3 from = (a + b + c) / 3 + 1e-7 * normalized(cross(b - a, c - a)), to = from + Vec3{3.1, 0.0007, 1.7};
        int out = 0;
        for (const auto& u : mesh.triangles)
            if (int sign = 0; meets(from, to, mesh.vertices[u[0]], mesh.vertices[u[1]], mesh.vertices[u[2]], sign))
                out += sign;
        whole += areaOf(mesh, t);
        if (out >= 0) right += areaOf(mesh, t);
    }
    return right / whole;
}

} // namespace

/// Which side of the cloth is the outside of the garment.
class tst_RightSide : public QObject {
    Q_OBJECT
private slots:
    void aTubeAndOneInsideOut();
    void foldsHoweverDeepAreRightSideOut();
    void aPleatRoundTheTubeIsRightSideOut();
    void aCollarTurnedDownIsRightSideOut();
    void aPanelSewnInTurnedIsItsShare();
    void aPieceDrawnThroughOthersIsFound();
    void theRefereeAgrees_data();
    void theRefereeAgrees();
    void partsDoNotDisturbEachOther();
    void degenerateTrianglesCountForNothing();
};

void tst_RightSide::aTubeAndOneInsideOut() {
    TriangleMesh mesh = tube();
    QCOMPARE(shareOf(mesh), 1.0);
    turnOver(mesh, 0, mesh.triangles.size());
    QCOMPARE(shareOf(mesh), 0.0);
}

void tst_RightSide::foldsHoweverDeepAreRightSideOut() {
    TriangleMesh mesh = skirtInDeepFolds(0.03);
    QVERIFY(collision::selfIntersectingTriangles(mesh).empty());
    QVERIFY2(shareFacingAway(mesh) < 0.9, qPrintable(QString::number(shareFacingAway(mesh)))); // they are deep
    QCOMPARE(shareOf(mesh), 1.0);
    turnOver(mesh, 0, mesh.triangles.size());
    QCOMPARE(shareOf(mesh), 0.0);
}

void tst_RightSide::aPleatRoundTheTubeIsRightSideOut() {
    // From the waist down to 0.6 m, up again to 0.8 m outside of that, and down to 0.5 m: three layers.
    const auto at = [](double height, double radius) { return tubes::ring({0, height, 0}, radius, pointsAround); };
    const TriangleMesh mesh =
        tubes::throughRings({at(0.5, 0.15), at(0.8, 0.15), at(0.6, 0.14), at(0.6, 0.13), at(1, 0.13)});
    QVERIFY(shareFacingAway(mesh) < 0.8);
    QCOMPARE(shareOf(mesh), 1.0);
}

/// Its right side lies on that of its stand.
void tst_RightSide::aCollarTurnedDownIsRightSideOut() {
    constexpr double top = 1.0, radius = 0.07;
    std::vector<std::vector<Vec3>> rings;
    for (int r = 0; r <= 8; ++r) rings.push_back(tubes::ring({0, 0.6 + (top - 0.6) * r / 8, 0}, radius, pointsAround));
    for (int r = 1; r <= 5; ++r)
        rings.push_back(tubes::ring({0, top - 0.01 * r, 0}, radius + 0.003 + 0.001 * r, pointsAround));
    TriangleMesh mesh = tubes::throughRings(rings);
    QCOMPARE(shareOf(mesh), 1.0);
    turnOver(mesh, 0, mesh.triangles.size());
    QCOMPARE(shareOf(mesh), 0.0);
}

void tst_RightSide::aPanelSewnInTurnedIsItsShare() {
    for (const std::size_t quarters : {1U, 2U, 3U}) {
        TriangleMesh mesh = tube();
        const std::size_t row = 2 * pointsAround;
        for (std::size_t r = 0; r < 8; ++r) turnOver(mesh, r * row, r * row + quarters * row / 4);
        QVERIFY(std::abs(shareOf(mesh) - (1 - 0.25 * static_cast<double>(quarters))) < 1e-12);
    }
}

void tst_RightSide::aPieceDrawnThroughOthersIsFound() {
    // Seen from above an eight: the left half of the ring lies in the right lobe turned over, sewn on without a fault.
    std::vector<std::vector<Vec3>> rings;
    for (const double height : {0.6, 0.7, 0.8, 0.9, 1.0}) {
        std::vector<Vec3> ring;
        for (int i = 0; i < 96; ++i) {
            const double turn = 2 * std::numbers::pi * (i + 0.5) / 96;
            ring.push_back({0.3 * std::cos(turn), height, -0.2 * std::sin(2 * turn)});
        }
        rings.push_back(std::move(ring));
    }
    QVERIFY(std::abs(shareOf(tubes::throughRings(rings)) - 0.5) < 1e-12);
}

void tst_RightSide::theRefereeAgrees_data() {
    QTest::addColumn<bool>("folded");
    QTest::addColumn<double>("disorder");
    QTest::newRow("a tube") << false << 0.0;
    QTest::newRow("a skirt in deep folds") << true << 0.0;
    QTest::newRow("a crumpled tube that passes through itself") << false << 0.08;
    QTest::newRow("a crumpled skirt that passes through itself") << true << 0.02;
}

void tst_RightSide::theRefereeAgrees() {
    QFETCH(bool, folded);
    QFETCH(double, disorder);
    constexpr unsigned seed = 3;
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> aside(-disorder, disorder);
    TriangleMesh mesh = folded ? skirtInDeepFolds(0) : tube();
    for (Vec3& p : mesh.vertices) p += Vec3{aside(random), 0, aside(random)};
    const double share = shareOf(mesh), byThreads = shareByThreads(mesh);
    QVERIFY2(std::abs(share - byThreads) < 1e-12,
             qPrintable(QString("%1, by threads %2, seed %3").arg(share).arg(byThreads).arg(seed)));
    QCOMPARE(share == 1, disorder == 0);
}

void tst_RightSide::partsDoNotDisturbEachOther() {
    TriangleMesh mesh = tube(0.6, 1.0, 0.13), turned = tube(0.5, 0.6, 0.13), inner = tube(0.2, 1.2, 0.05);
    turnOver(turned, 0, turned.triangles.size());
    append(mesh, turned); // a quarter of the first one's area
    append(mesh, inner);
    const double first = 0.4 * 0.13, second = 0.1 * 0.13, third = 1.0 * 0.05; // areas over the same factor
    QVERIFY(std::abs(shareOf(mesh) - (first + third) / (first + second + third)) < 1e-12);
}

void tst_RightSide::degenerateTrianglesCountForNothing() {
    TriangleMesh mesh = tube();
    mesh.triangles.push_back({0, 0, 1});
    mesh.triangles.push_back({5, 5, 5});
    QCOMPARE(shareOf(mesh), 1.0);
    QCOMPARE(rightSideOutShare({}, {}), 0.0);
}

TOILE_TEST(tst_RightSide)
#include "tst_RightSide.moc"
