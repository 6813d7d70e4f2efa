// SPDX-License-Identifier: GPL-3.0-or-later
#include "SmallScenes.h"
#include "core/simulation/CarryOver.h"
#include "core/simulation/MeshInputOf.h"
#include "tests/Suite.h"

#include <QTest>

using namespace toile;
using namespace toile::simulation;

namespace {

/// A piece with a slanted edge, so that its mesh has triangles too.
meshing::PieceMesh meshAt(double spacing) {
    pattern::Pattern pattern;
    pattern.fabrics.push_back(plainCloth());
    pattern.pieces.push_back(polygonPiece("piece", {{0, 0}, {0.30, 0}, {0.22, 0.21}, {0, 0.21}}, spacing));
    return meshing::meshGarment(*meshInputOf(pattern))->pieces[0];
}

Vec3 linear(Vec2 p) {
    return {0.1 + 2 * p.x - p.y, 0.5 * p.x + 3 * p.y, -0.2 - p.x + 0.25 * p.y};
}

std::vector<Vec3> linearField(const meshing::PieceMesh& mesh) {
    std::vector<Vec3> field;
    for (const Vec2 p : mesh.nodes) field.push_back(linear(p));
    return field;
}

constexpr double rounding = 1e-12; // of sums of three products of numbers below 1

} // namespace

class tst_CarryOver : public QObject {
    Q_OBJECT
private slots:
    void aConstantFieldStaysConstant();
    void onTheSameMeshEveryNodeKeepsItsPlace();
    void aLinearFieldIsReproducedOnAnotherMesh_data();
    void aLinearFieldIsReproducedOnAnotherMesh();
    void outsideTheOldOutlineALinearFieldGoesOn();
    void outsideItTheTriangleAtHandGoesOn();
    void aCurvedDrapeIsCarriedWithinTheErrorOfItsMesh();
    void sewnNodesComeTogetherWhereTheyAreNear();
};

/// Below the long side of a flat triangle, beside a small one that stands up and whose centre is nearer.
void tst_CarryOver::outsideItTheTriangleAtHandGoesOn() {
    meshing::PieceMesh mesh;
    mesh.nodes = {{0, 0}, {0.3, 0}, {0.15, 0.3}, {0.32, 0}, {0.3, 0.02}};
    mesh.display = {{0, 1, 2}, {1, 3, 4}};
    std::vector<Vec3> positions;
    for (const Vec2 p : mesh.nodes) positions.push_back({p.x, p.y, 0});
    positions[3] = {0.3, 0, 0.02};
    const DrapedPiece drape(mesh, positions);
    QVERIFY(geometry::distance(drape.at({0.28, -0.001}), {0.28, -0.001, 0}) < rounding);
}

/// Pairs of a seam are moved apart by more and more from its start; those within the gap meet in their middle.
void tst_CarryOver::sewnNodesComeTogetherWhereTheyAreNear() {
    constexpr double gap = 0.005;
    const Scene scene = twoSquares(0.02);
    const meshing::GarmentMesh mesh = *meshing::meshGarment(*meshInputOf(scene.pattern));
    const std::vector<bool> all{true}, none{false};
    const ParticleMap map = particleMap(mesh, none);
    std::vector<Vec3> nodes(map.particleOf.size());
    for (std::size_t k = 0; k < mesh.seams[0].pairs.size(); ++k)
        nodes[map.node(mesh.seams[0].pairs[k][1])] = {0.001 * static_cast<double>(k), 0, 1};
    for (std::size_t k = 0; k < mesh.seams[0].pairs.size(); ++k) nodes[map.node(mesh.seams[0].pairs[k][0])] = {0, 0, 1};
    const std::vector<Vec3> apart = nodes;

    joinSewn(mesh, none, gap, nodes);
    QVERIFY(nodes == apart);
    joinSewn(mesh, all, gap, nodes);
    QVERIFY(mesh.seams[0].pairs.size() > 6);
    for (std::size_t k = 0; k < mesh.seams[0].pairs.size(); ++k) {
        const int a = map.node(mesh.seams[0].pairs[k][0]), b = map.node(mesh.seams[0].pairs[k][1]);
        if (k <= 5) QVERIFY(distance(nodes[a], nodes[b]) == 0 && distance(nodes[a], (apart[a] + apart[b]) / 2) < 1e-15);
        else QVERIFY(nodes[a] == apart[a] && nodes[b] == apart[b]);
    }
}

void tst_CarryOver::aConstantFieldStaysConstant() {
    const meshing::PieceMesh mesh = meshAt(0.03), other = meshAt(0.013);
    const Vec3 place{0.4, 1.2, -0.1};
    const std::vector<Vec3> field(mesh.nodes.size(), place);
    const DrapedPiece drape(mesh, field);
    for (const Vec2 p : other.nodes) QVERIFY(geometry::distance(drape.at(p), place) < rounding);
}

void tst_CarryOver::onTheSameMeshEveryNodeKeepsItsPlace() {
    const meshing::PieceMesh mesh = meshAt(0.02);
    std::vector<Vec3> field;
    for (std::size_t node = 0; node < mesh.nodes.size(); ++node) // no two alike, nothing smooth
        field.push_back({std::sin(12.9 * double(node)), std::cos(78.2 * double(node)), double(node % 7)});
    const DrapedPiece drape(mesh, field);
    for (std::size_t node = 0; node < mesh.nodes.size(); ++node)
        QVERIFY(geometry::distance(drape.at(mesh.nodes[node]), field[node]) <
                1e-8); // −1e-9 counts as inside a triangle
}

void tst_CarryOver::aLinearFieldIsReproducedOnAnotherMesh_data() {
    QTest::addColumn<double>("from");
    QTest::addColumn<double>("to");
    QTest::newRow("from coarse to fine") << 0.04 << 0.011;
    QTest::newRow("from fine to coarse") << 0.011 << 0.04;
}

void tst_CarryOver::aLinearFieldIsReproducedOnAnotherMesh() {
    QFETCH(double, from);
    QFETCH(double, to);
    const meshing::PieceMesh mesh = meshAt(from), other = meshAt(to);
    const std::vector<Vec3> field = linearField(mesh);
    const DrapedPiece drape(mesh, field);
    for (const Vec2 p : other.nodes) QVERIFY(geometry::distance(drape.at(p), linear(p)) < rounding);
}

void tst_CarryOver::outsideTheOldOutlineALinearFieldGoesOn() {
    const meshing::PieceMesh mesh = meshAt(0.03);
    const std::vector<Vec3> field = linearField(mesh);
    const DrapedPiece drape(mesh, field);
    for (const Vec2 p : {Vec2{-0.02, 0.1}, Vec2{0.31, -0.01}, Vec2{0.1, 0.25}, Vec2{0.30, 0.21}})
        QVERIFY(geometry::distance(drape.at(p), linear(p)) < 1e-10); // thin triangles are continued far
}

void tst_CarryOver::aCurvedDrapeIsCarriedWithinTheErrorOfItsMesh() {
    const double spacing = 0.02, radius = 0.1;
    const meshing::PieceMesh mesh = meshAt(spacing), other = meshAt(0.007);
    const auto rolled = [&](Vec2 p) {
        return Vec3{radius * std::sin(p.x / radius), p.y, radius * std::cos(p.x / radius)};
    };
    std::vector<Vec3> field;
    for (const Vec2 p : mesh.nodes) field.push_back(rolled(p));
    const DrapedPiece drape(mesh, field);
    // Linear interpolation over an edge e of a circle is off by e²/8R at most; diagonals reach √2 spacings and rows may
    // be a quarter higher than the spacing.
    const double bound = std::pow(1.25 * std::sqrt(2.0) * spacing, 2) / (8 * radius);
    for (const Vec2 p : other.nodes) QVERIFY(geometry::distance(drape.at(p), rolled(p)) < bound);
}

TOILE_TEST(tst_CarryOver)
#include "tst_CarryOver.moc"
