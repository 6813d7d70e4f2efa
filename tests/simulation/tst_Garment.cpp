// SPDX-License-Identifier: GPL-3.0-or-later
#include "SmallScenes.h"
#include "core/geometry/Polygon.h"
#include "core/pattern/PatternFabrics.h"
#include "tests/Suite.h"
#include "tests/simulation/Garments.h"

#include <QTest>
#include <numeric>

using namespace toile;
using namespace toile::simulation;

namespace {

/// Two pieces with slanted edges, of which one has a region at half the spacing: cells, triangles and slaves.
pattern::Pattern unevenPieces() {
    pattern::Pattern pattern = twoSquares(0.02).pattern;
    pattern::Piece left = *pattern.pieces[0];
    left.outline.vertices[3].position = {-0.03, 0.23};
    pattern::Region region;
    region.id = pattern::RegionId("r");
    region.outline = {{-0.05, -0.01}, {0.1, -0.01}, {0.1, 0.1}, {-0.05, 0.1}};
    left.regions.push_back(region);
    pattern.pieces[0] = left;
    return pattern;
}

double massOf(const Garment& garment) {
    return std::accumulate(garment.model.mass.begin(), garment.model.mass.end(), 0.0);
}

/// ρ times the area of the meshed outline of every piece.
double massOfOutlines(const pattern::Pattern& pattern) {
    double sum = 0;
    for (const auto& piece : pattern.pieces) {
        geometry::Polygon outline;
        for (const auto& vertex : piece->outline.vertices) outline.push_back(vertex.position);
        sum += pattern.fabrics[0]->arealDensity * geometry::signedArea(outline);
    }
    return sum;
}

pattern::Pin pinAt(const char* piece, const char* vertex) {
    return {pattern::PinId("pin"), pattern::PieceId(piece), pattern::VertexId(vertex)};
}

} // namespace

class tst_Garment : public QObject {
    Q_OBJECT
private slots:
    void massIsDensityTimesArea();
    void mergingKeepsTheMass();
    void mergingMakesPairsOneParticle();
    void fourPiecesThatMeetInAPointShareOneParticle();
    void aPinHoldsTheParticleAtItsVertex();
    void twoPinsOfOneMergedParticleAreOne();
    void aPinOfAnUnknownVertexIsNamed();
    void anUnknownFabricIsNamed();
    void aKnitHasMembraneCellsAndNoSprings();
    void wovenClothHasSpringsAndNoMembraneCells();
    void aStifferRegionHasStifferSprings();
    void aFusedPieceIsHeavierAndStiffer();
};

void tst_Garment::massIsDensityTimesArea() {
    const pattern::Pattern pattern = unevenPieces();
    const auto garment = tryGarmentOf(pattern);
    QVERIFY(garment);
    QVERIFY(!garment->model.slaves.empty() && !garment->model.triangles.empty());
    QVERIFY(std::abs(massOf(*garment) / massOfOutlines(pattern) - 1) < 1e-12);
}

void tst_Garment::mergingKeepsTheMass() {
    const pattern::Pattern pattern = unevenPieces();
    QVERIFY(std::abs(massOf(*tryGarmentOf(pattern, true)) / massOfOutlines(pattern) - 1) < 1e-12);
}

void tst_Garment::mergingMakesPairsOneParticle() {
    const auto open = tryGarmentOf(unevenPieces()), merged = tryGarmentOf(unevenPieces(), true);
    const auto& pairs = merged->mesh->seams[0].pairs;
    QCOMPARE(merged->particles.particleCount, open->particles.particleCount - static_cast<int>(pairs.size()));
    for (const auto& [a, b] : pairs) QCOMPARE(merged->particles.particle(a), merged->particles.particle(b));
}

void tst_Garment::fourPiecesThatMeetInAPointShareOneParticle() {
    pattern::Pattern pattern;
    pattern.fabrics = twoSquares().pattern.fabrics;
    for (const char* id : {"low left", "low right", "top left", "top right"})
        pattern.pieces.push_back(polygonPiece(id, {{0, 0}, {0.2, 0}, {0.2, 0.2}, {0, 0.2}}, 0.05));
    pattern.seams = {seamBetween("low", "low left", "e1", "low right", "e3"),
                     seamBetween("top", "top left", "e1", "top right", "e3"),
                     seamBetween("left", "low left", "e2", "top left", "e0"),
                     seamBetween("right", "low right", "e2", "top right", "e0")};
    const auto garment = tryGarmentOf(pattern, true);
    QVERIFY(garment);
    QCOMPARE(garment->particles.particleCount, 9 * 9); // one square of 8 × 8 cells
    const auto cornerOf = [&](int piece, std::size_t vertex) {
        return garment->particles.particle({piece, garment->mesh->pieces[piece].loops[0][vertex].front().node});
    };
    const int middle = cornerOf(0, 2);
    QVERIFY(middle == cornerOf(1, 3) && middle == cornerOf(2, 1) && middle == cornerOf(3, 0));
    QVERIFY(std::abs(garment->model.mass[middle] - pattern.fabrics[0]->arealDensity * 0.05 * 0.05) < 1e-15);
}

void tst_Garment::aPinHoldsTheParticleAtItsVertex() {
    pattern::Pattern pattern = unevenPieces();
    pattern.pins = {pinAt("right", "v2")};
    const auto garment = tryGarmentOf(pattern);
    QVERIFY(garment);
    QCOMPARE(garment->model.pinned.size(), std::size_t(1));
    const auto& nodes = garment->mesh->pieces[1].nodes;
    const int node = garment->model.pinned[0] - garment->particles.firstNode[1]; // nothing is merged: particle = node
    QCOMPARE(nodes[node], (Vec2{0.2, 0.2}));
}

void tst_Garment::twoPinsOfOneMergedParticleAreOne() {
    pattern::Pattern pattern = twoSquares(0.05).pattern;
    pattern.pins = {pinAt("left", "v1"), pinAt("right", "v0")};
    QCOMPARE(tryGarmentOf(pattern)->model.pinned.size(), std::size_t(2));
    QCOMPARE(tryGarmentOf(pattern, true)->model.pinned.size(), std::size_t(1));
}

void tst_Garment::aPinOfAnUnknownVertexIsNamed() {
    pattern::Pattern pattern = twoSquares(0.05).pattern;
    pattern.pins = {pinAt("left", "v9")};
    const auto garment = tryGarmentOf(pattern);
    QVERIFY(!garment);
    QCOMPARE(garment.error().text, std::string("Piece \"left\" has no vertex \"v9\"."));
    QCOMPARE(garment.error().place.object, std::string("pin \"pin\""));
}

void tst_Garment::anUnknownFabricIsNamed() {
    pattern::Pattern pattern = twoSquares(0.05).pattern;
    pattern::Piece piece = *pattern.pieces[1];
    piece.fabric = material::FabricId("silk");
    pattern.pieces[1] = piece;
    const auto garment = tryGarmentOf(pattern);
    QVERIFY(!garment);
    QCOMPARE(garment.error().text, std::string("There is no fabric \"silk\"."));
    QCOMPARE(garment.error().place.object, std::string("piece \"right\""));
}

void tst_Garment::aKnitHasMembraneCellsAndNoSprings() {
    pattern::Pattern pattern = twoSquares(0.05).pattern;
    material::Fabric fabric = *pattern.fabrics[0];
    fabric.kind = material::FabricKind::knit;
    pattern.fabrics[0] = fabric;
    const auto garment = tryGarmentOf(pattern);
    QVERIFY(garment);
    QCOMPARE(garment->model.cells.size(), std::size_t(2 * 4 * 4));
    QVERIFY(garment->model.structural.empty() && garment->model.shear.empty());
}

void tst_Garment::wovenClothHasSpringsAndNoMembraneCells() {
    const auto garment = tryGarmentOf(twoSquares(0.05).pattern);
    QCOMPARE(garment->model.structural.size(), std::size_t(2 * 2 * 4 * 5)); // two squares, two directions, five lines
    QCOMPARE(garment->model.shear.size(), std::size_t(2 * 2 * 4 * 4));      // two diagonals a cell
    QVERIFY(garment->model.cells.empty());
    QCOMPARE(garment->model.clampedCells, 0);
}

void tst_Garment::aStifferRegionHasStifferSprings() {
    pattern::Pattern pattern = twoSquares(0.05).pattern;
    pattern::Piece piece = *pattern.pieces[0];
    pattern::Region region;
    region.id = pattern::RegionId("r");
    region.outline = {{-0.01, -0.01}, {0.21, -0.01}, {0.21, 0.21}, {-0.01, 0.21}}; // all of the piece
    region.refinement = 0;
    region.stiffness = {.stretch = 2, .shear = 5, .bending = 3};
    piece.regions = {region};
    pattern.pieces[0] = piece;
    const auto plain = tryGarmentOf(twoSquares(0.05).pattern), stiff = tryGarmentOf(pattern);
    const auto sum = [](const auto& elements) {
        double k = 0;
        for (const auto& element : elements) k += element.stiffness;
        return k;
    };
    // One of two equal pieces is stiffer. Of a square cell each structural spring has ½(E − G), each diagonal G.
    QVERIFY(std::abs(sum(stiff->model.bending) / sum(plain->model.bending) - (1 + 3) / 2.0) < 1e-12);
    QVERIFY(std::abs(sum(stiff->model.shear) / sum(plain->model.shear) - (1 + 5) / 2.0) < 1e-12);
    QVERIFY(sum(stiff->model.structural) > 1.4 * sum(plain->model.structural));
}

void tst_Garment::aFusedPieceIsHeavierAndStiffer() {
    const pattern::Pattern plain = twoSquares(0.05).pattern; // 0.2 × 0.2 m each, sewn along one side
    const pattern::Pattern fused = *setInterfacing(plain, plain.pieces[0]->id, pattern::Interfacing{9, 0.05});
    const auto before = tryGarmentOf(plain, true), after = tryGarmentOf(fused, true);
    QVERIFY(before && after);
    QVERIFY(std::abs(massOf(*after) - massOf(*before) - 0.05 * 0.04) < 1e-12);
    const auto sum = [](const auto& elements) {
        double k = 0;
        for (const auto& element : elements) k += element.stiffness;
        return k;
    };
    // One of two equal pieces is nine times as stiff, and the seam between them has the mean of both.
    QVERIFY(std::abs(sum(after->model.bending) / sum(before->model.bending) - 5) < 1e-12);
    QVERIFY(std::abs(sum(after->model.hinges) / sum(before->model.hinges) - 5) < 1e-12);
    QCOMPARE(sum(after->model.structural), sum(before->model.structural));
}

TOILE_TEST(tst_Garment)
#include "tst_Garment.moc"
