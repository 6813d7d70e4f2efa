// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/picture/Cavity.h"
#include "core/picture/SurfaceData.h"
#include "tests/Suite.h"

#include <QTest>

#include <cmath>
#include <limits>
#include <numbers>

using namespace toile;
using namespace toile::picture;

namespace {

/// A square net of (n+1)² points over [−half, half]², its height a function of the place; right side up (+z).
struct Net {
    std::vector<Vec3> positions;
    std::vector<geometry::TriangleIndices> triangles;
};
template <class Height>
Net netOver(int n, double half, Height height) {
    Net net;
    for (int j = 0; j <= n; ++j)
        for (int i = 0; i <= n; ++i) {
            const double x = half * (2.0 * i / n - 1), y = half * (2.0 * j / n - 1);
            net.positions.push_back({x, y, height(x, y)});
        }
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) {
            const int a = j * (n + 1) + i, b = a + 1, c = a + n + 1, d = c + 1;
            net.triangles.insert(net.triangles.end(), {{a, b, d}, {a, d, c}});
        }
    return net;
}

int middleOf(int n) {
    return (n / 2) * (n + 1) + n / 2;
}

/// Two triangles in a row, one of a sub-region, and a second piece.
simulation::FrameTopology threeTriangles() {
    simulation::FrameTopology topology;
    topology.triangles = {{0, 1, 2}, {1, 3, 2}, {4, 5, 6}};
    topology.triangleRegion = {-1, 0, -1};
    topology.pieces = {{"front", "", 0, 4, 0, 2}, {"back", "", 4, 3, 2, 1}};
    topology.seams = {{{1, 5}, {3, 6}, {0, 4}}};
    return topology;
}

} // namespace

class tst_SurfaceData : public QObject {
    Q_OBJECT
private slots:
    void normalsPointToTheRightSide();
    void aFlatSurfaceIsNeitherHollowNorRound();
    void cavityIsTheMeanCurvatureOfACylinder();
    void aFoldIsAsHollowOnEveryMesh();
    void shallowRipplesHideNoSky();
    void aSewnSeamIsSmoothUnlessItIsFolded();
    void brokenPositionsDoNotSpread();
    void coloursFollowPieceRegionAndSelection();
    void seamsRunAlongEdgesOnly();
    void bordersRunRoundEachPiece();
    void seamColoursDiffer();
    void boundsLeaveOutWhatIsNotDrawn();
};

void tst_SurfaceData::normalsPointToTheRightSide() {
    const Net net = netOver(4, 1, [](double x, double) { return x; });
    for (const SurfaceVertex& vertex : surfaceVertices(net.positions, net.triangles)) {
        QVERIFY(std::abs(vertex.normal[0] + std::sqrt(0.5f)) < 1e-6f);
        QVERIFY(std::abs(vertex.normal[2] - std::sqrt(0.5f)) < 1e-6f);
    }
}

void tst_SurfaceData::aFlatSurfaceIsNeitherHollowNorRound() {
    const Net net = netOver(4, 1, [](double, double) { return 0.3; });
    for (const SurfaceVertex& vertex : surfaceVertices(net.positions, net.triangles)) QCOMPARE(vertex.cavity, 0.0f);
}

void tst_SurfaceData::cavityIsTheMeanCurvatureOfACylinder() {
    const double radius = 0.1, mean = 1 / (2 * radius); // of the two principal curvatures 1/R and 0
    for (const double sign : {1.0, -1.0}) {             // a valley, a ridge
        const Net net = netOver(20, 0.02, [&](double x, double) { return sign * x * x / (2 * radius); });
        const float cavity =
            surfaceVertices(net.positions, net.triangles)[static_cast<std::size_t>(middleOf(20))].cavity;
        // The ring of six neighbours lies along the net and one diagonal, so that it weighs no direction
        // more.
        QVERIFY2(std::abs(cavity - sign * mean * cavityLength) < 0.02 * mean * cavityLength,
                 QByteArray::number(cavity));
    }
}

namespace {

/// Of the bottom of a valley −a·cos(2πx/λ) on a net of this spacing [–].
double cavityOfValley(double amplitude, double wave, double spacing) {
    const int n = 2 * static_cast<int>(std::round(0.15 / spacing));
    const Net net = netOver(n, n * spacing / 2,
                            [&](double x, double) { return -amplitude * std::cos(2 * std::numbers::pi * x / wave); });
    return surfaceVertices(net.positions, net.triangles)[static_cast<std::size_t>(middleOf(n))].cavity;
}

} // namespace

void tst_SurfaceData::aFoldIsAsHollowOnEveryMesh() {
    const double fine = cavityOfValley(0.004, 0.12, 0.004); // mean curvature 5.5 1/m, 0.11 before it is evened out
    QVERIFY2(fine > 0.08 && fine < 0.11, QByteArray::number(fine));
    for (const double spacing : {0.005, 0.01}) // the second differences of the coarser net are 2 % low
        QVERIFY2(std::abs(cavityOfValley(0.004, 0.12, spacing) - fine) < 0.05 * fine, QByteArray::number(spacing));
    QVERIFY(std::abs(cavityOfValley(0.004, 0.12, 0.02) - fine) < 0.15 * fine); // six nodes to a fold
}

void tst_SurfaceData::shallowRipplesHideNoSky() {
    const double amplitude = 0.3e-3, wave = 0.03; // mean curvature 6.6 1/m, 0.13 before it is evened out
    for (const double spacing : {0.005, 0.01})
        QVERIFY2(std::abs(cavityOfValley(amplitude, wave, spacing)) < 0.02,
                 QByteArray::number(cavityOfValley(amplitude, wave, spacing)));
}

void tst_SurfaceData::aSewnSeamIsSmoothUnlessItIsFolded() {
    // Two squares side by side along y, the right one turned about their common edge.
    const auto normalsAtTheSeam = [](double fold, double gap) {
        const double x = std::cos(fold), z = std::sin(fold);
        const std::vector<Vec3> positions{{-1, 0, 0},  {0, 0, 0},       {0, 1, 0},       {-1, 1, 0},
                                          {gap, 0, 0}, {gap + x, 0, z}, {gap + x, 1, z}, {gap, 1, 0}};
        const auto vertices =
            surfaceVertices(positions, {{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {4, 6, 7}}, {{{1, 4}, {2, 7}}});
        return std::array{vertices[1].normal, vertices[4].normal};
    };
    const auto smooth = normalsAtTheSeam(0.8, 0), folded = normalsAtTheSeam(1.7, 0), open = normalsAtTheSeam(0.8, 1e-4);
    QCOMPARE(smooth[0], smooth[1]);
    QVERIFY(smooth[0][0] < -0.1f && smooth[0][0] > -0.7f); // between the normals of both sides
    QCOMPARE(folded[0][0], 0.0f);                          // each side keeps its own
    QCOMPARE(open[0][0], 0.0f);
}

void tst_SurfaceData::brokenPositionsDoNotSpread() {
    Net net = netOver(4, 1, [](double, double) { return 0.0; });
    net.positions[3] = {std::numeric_limits<double>::quiet_NaN(), 0, 0};
    for (const SurfaceVertex& vertex : surfaceVertices(net.positions, net.triangles))
        for (const float value : {vertex.position[0], vertex.normal[0], vertex.normal[2], vertex.cavity})
            QVERIFY(std::isfinite(value));
}

void tst_SurfaceData::coloursFollowPieceRegionAndSelection() {
    RenderScene scene;
    scene.pieceColours["front"] = {1, 0, 0};
    scene.selectedPiece = "back";
    const auto plain = triangleColours(scene, threeTriangles());
    QCOMPARE(plain[0], (std::array<std::uint8_t, 4>{255, 0, 0, 255}));
    QCOMPARE(plain[1], plain[0]);
    QCOMPARE(plain[2][3], std::uint8_t{96}); // selected
    simulation::FrameTopology plied = threeTriangles();
    for (auto& piece : plied.pieces) piece.rightSidesOnly = true;
    QCOMPARE(triangleColours(scene, plied)[0], (std::array<std::uint8_t, 4>{255, 0, 0, 160}));
    QCOMPARE(triangleColours(scene, plied)[2][3], std::uint8_t{0});
    scene.options.regions = true;
    const auto tinted = triangleColours(scene, threeTriangles());
    QCOMPARE(tinted[0], plain[0]);
    QVERIFY(tinted[1] != plain[1]);
}

void tst_SurfaceData::seamsRunAlongEdgesOnly() {
    const auto lines = seamLines(threeTriangles());
    QCOMPARE(lines.size(), std::size_t{1});
    QCOMPARE(lines[0].across.size(), std::size_t{3});
    const std::vector<std::array<int, 2>> wanted{{1, 3}, {5, 6}, {6, 4}}; // 3–0 is no edge
    QVERIFY(lines[0].along == wanted);
}

void tst_SurfaceData::bordersRunRoundEachPiece() {
    const auto borders = pieceBorders(threeTriangles());
    QCOMPARE(borders.size(), std::size_t{2});
    const std::vector<std::array<int, 2>> front{{0, 1}, {0, 2}, {1, 3}, {2, 3}}; // 1–2 is inside
    QVERIFY(borders[0] == front);
    QCOMPARE(borders[1].size(), std::size_t{3});
}

void tst_SurfaceData::seamColoursDiffer() {
    for (std::size_t i = 0; i < 12; ++i)
        for (std::size_t j = i + 1; j < 12; ++j) {
            const Colour a = seamColour(i), b = seamColour(j);
            QVERIFY(std::abs(a.r - b.r) + std::abs(a.g - b.g) + std::abs(a.b - b.b) > 0.1f);
        }
}

void tst_SurfaceData::boundsLeaveOutWhatIsNotDrawn() {
    RenderScene scene;
    QVERIFY(!boundsOf(scene));
    scene.body = Shared(body::Body{.mesh = {{{0, 0, 0}, {1, 2, 3}}, {}}});
    simulation::Frame frame;
    frame.positions = {{-1, 0, 0}, {std::numeric_limits<double>::infinity(), 0, 0}};
    scene.frame = Shared(frame);
    QCOMPARE(boundsOf(scene)->low, (Vec3{-1, 0, 0}));
    QCOMPARE(boundsOf(scene)->high, (Vec3{1, 2, 3}));
    scene.options.body = false;
    QCOMPARE(boundsOf(scene)->high, (Vec3{-1, 0, 0}));
}

TOILE_TEST(tst_SurfaceData)
#include "tst_SurfaceData.moc"
