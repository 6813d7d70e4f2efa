// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cloth/Forces.h"
#include "core/dynamics/Eliminated.h"
#include "core/dynamics/Statics.h"
#include "core/simulation/Garment.h"
#include "core/simulation/MeshInputOf.h"
#include "tests/Suite.h"
#include "tests/cloth/Fixtures.h"
#include "tests/simulation/SmallScenes.h"

#include <Eigen/SparseCholesky>
#include <QTest>
#include <set>

using namespace toile;
using namespace toile::simulation;

namespace {

constexpr double side = 0.4, spacing = 0.02, cell = spacing; // of the sheets [m]

pattern::Region boxAt(double x0, double y0, double x1, double y1, int refinement) {
    pattern::Region region;
    region.id = pattern::RegionId("box " + std::to_string(refinement));
    region.name = region.id.value;
    region.outline = {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
    region.refinement = refinement;
    return region;
}

pattern::Piece sheetWith(std::vector<pattern::Region> regions, double at = spacing) {
    pattern::Piece piece = polygonPiece("sheet", {{0, 0}, {side, 0}, {side, side}, {0, side}}, at);
    piece.regions = std::move(regions);
    return piece;
}

/// From 6 to 14 of 20 cells each way.
pattern::Region middleBox(int refinement) {
    return boxAt(6 * cell, 6 * cell, 14 * cell, 14 * cell, refinement);
}

/// Nothing parallel to the grain but the lower edge; one region within, one over the border.
pattern::Piece slantedPiece() {
    pattern::Piece piece = polygonPiece("slanted", {{0, 0}, {0.4, 0}, {0.36, 0.31}, {0.05, 0.42}}, spacing);
    piece.regions = {boxAt(0.11, 0.09, 0.25, 0.21, 2), boxAt(0.29, -0.1, 0.5, 0.1, 1)};
    return piece;
}

Garment garmentOf(const pattern::Piece& piece, material::Fabric fabric = fixtures::wovenFabric()) {
    pattern::Pattern pattern;
    fabric.id = material::FabricId("cloth");
    pattern.fabrics.push_back(fabric);
    pattern.pieces.push_back(piece);
    const auto input = meshInputOf(pattern);
    auto mesh = meshing::meshGarment(*input);
    if (!mesh) qFatal("%s", toString(mesh.error()).c_str());
    auto garment = makeGarment(pattern, Shared<meshing::GarmentMesh>(std::move(*mesh)), {});
    if (!garment) qFatal("%s", toString(garment.error()).c_str());
    return std::move(*garment);
}

const meshing::PieceMesh& meshOf(const Garment& garment) {
    return garment.mesh->pieces[0];
}

/// The particles of one piece are its nodes.
std::vector<Vec2> materialOf(const Garment& garment) {
    return meshOf(garment).material;
}

std::set<int> borderOf(const meshing::PieceMesh& mesh) {
    std::set<int> border;
    for (const auto& loop : mesh.loops)
        for (const meshing::EdgeNodes& edge : loop)
            for (const meshing::EdgeNode& node : edge) border.insert(node.node);
    return border;
}

struct PlaneMap {
    double xx = 1, xy = 0, yx = 0, yy = 1;
    [[nodiscard]] Vec3 operator()(Vec2 m) const { return {xx * m.x + xy * m.y, yx * m.x + yy * m.y, 0}; }
};

/// Largest force on an inner node that is no slave, over E·h: E the fabric's stiffness along warp, h the finest
/// spacing.
double largestForce(const Garment& garment, const PlaneMap& map, double finest) {
    std::vector<Vec3> positions, forces;
    for (const Vec2 m : materialOf(garment)) positions.push_back(map(m));
    forces.resize(positions.size());
    cloth::addForces(garment.model, positions, forces);
    cloth::gatherToMasters(garment.model, forces);
    const std::set<int> border = borderOf(meshOf(garment));
    double largest = 0;
    for (int p = 0; p < static_cast<int>(forces.size()); ++p)
        if (!border.contains(p)) largest = std::max(largest, geometry::length(forces[p]));
    return largest / (fixtures::wovenFabric().warpStiffness * finest);
}

/// Nodes that have rectangles of two sizes, and are no slaves.
std::vector<int> jointNodes(const meshing::PieceMesh& mesh) {
    std::vector<double> least(mesh.nodes.size(), 1e9), most(mesh.nodes.size(), 0);
    for (const meshing::Rectangle& r : mesh.rectangles) {
        const double width = mesh.material[r.nodes[1]].x - mesh.material[r.nodes[0]].x;
        for (const int node : r.nodes) {
            least[node] = std::min(least[node], width);
            most[node] = std::max(most[node], width);
        }
    }
    for (const meshing::SlaveNode& slave : mesh.slaves) most[slave.node] = 0;
    std::vector<int> joint;
    for (int node = 0; node < static_cast<int>(mesh.nodes.size()); ++node)
        if (most[node] > 1.5 * least[node]) joint.push_back(node);
    return joint;
}

/// The node at this place; −1 = none.
int nodeAt(const meshing::PieceMesh& mesh, Vec2 place) {
    for (int node = 0; node < static_cast<int>(mesh.nodes.size()); ++node)
        if (distance(mesh.material[node], place) < 1e-9) return node;
    return -1;
}

/// Of the circle through three points [1/m].
double curvatureThrough(Vec3 a, Vec3 b, Vec3 c) {
    return 2 * geometry::length(geometry::cross(b - a, c - b)) /
           (geometry::distance(a, b) * geometry::distance(b, c) * geometry::distance(a, c));
}

struct Range {
    double least = 1e9, most = -1e9;
    void add(double value) {
        least = std::min(least, value);
        most = std::max(most, value);
    }
};

/// Nearer than two cells to a corner of the region in the middle.
bool isNearCorner(Vec2 m) {
    const auto near = [](double a) { return std::min(std::abs(a - 6 * cell), std::abs(a - 14 * cell)) < 1.9 * cell; };
    return near(m.x) && near(m.y);
}

/// Lowest frequency across the plane of a sheet that is stretched by 1 % both ways and held all round [Hz].
double firstMode(const Garment& garment) {
    struct Sink : cloth::HessianSink {
        void add(int i, int j, const double (&block)[9]) override {
            for (const auto& [a, wa] : unknowns->termsOf(i))
                for (const auto& [b, wb] : unknowns->termsOf(j)) entries.emplace_back(a, b, wa * wb * block[8]);
        }
        const dynamics::Eliminated* unknowns = nullptr;
        std::vector<Eigen::Triplet<double>> entries; // of ∂²E/∂z∂z: flat, so z is coupled to nothing else
    };
    cloth::ClothModel model = garment.model;
    for (const int node : borderOf(meshOf(garment))) model.pinned.push_back(node);
    const dynamics::Eliminated unknowns(model);
    std::vector<Vec3> positions;
    for (const Vec2 m : materialOf(garment)) positions.push_back({1.01 * m.x, 1.01 * m.y, 0});
    Sink sink;
    sink.unknowns = &unknowns;
    cloth::addHessian(model, positions, cloth::HessianForm::exact, sink);
    const int n = unknowns.count();
    Eigen::SparseMatrix<double> stiffness(n, n);
    stiffness.setFromTriplets(sink.entries.begin(), sink.entries.end());
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor(stiffness);
    Eigen::VectorXd mass(n), mode = Eigen::VectorXd::Ones(n);
    for (int i = 0; i < n; ++i) mass[i] = model.mass[unknowns.free()[i]];
    double squared = 0;
    for (int i = 0; i < 60; ++i) { // inverse iteration; the second mode is 2.5 times as stiff: 0.4⁶⁰ is left of it
        mode = factor.solve(Eigen::VectorXd(mass.cwiseProduct(mode)));
        mode /= std::sqrt(mode.dot(mass.cwiseProduct(mode)));
        squared = mode.dot(stiffness * mode);
    }
    return std::sqrt(squared) / (2 * std::numbers::pi);
}

} // namespace

/// How smooth a joint between regions is, of cloth on the mesher's own meshes. Ref: docs/meshing.md
class tst_RegionJoints : public QObject {
    Q_OBJECT
private slots:
    void smallStrainsPullNoInnerNode_data();
    void smallStrainsPullNoInnerNode();
    void largeStrainsPullNoNodeWhereCellsAreAlike_data();
    void largeStrainsPullNoNodeWhereCellsAreAlike();
    void aRolledSheetIsRoundAcrossItsJoints_data();
    void aRolledSheetIsRoundAcrossItsJoints();
    void theFirstModeIsThatOfTheUniformFineMesh_data();
    void theFirstModeIsThatOfTheUniformFineMesh();
};

void tst_RegionJoints::smallStrainsPullNoInnerNode_data() {
    QTest::addColumn<pattern::Piece>("piece");
    QTest::addColumn<int>("refinement");
    QTest::addRow("half the spacing in the middle") << sheetWith({middleBox(1)}) << 1;
    QTest::addRow("a quarter, with a ring of halves") << sheetWith({middleBox(2)}) << 2;
    QTest::addRow("a 64th on one cell") << sheetWith({boxAt(9 * cell, 9 * cell, 10 * cell, 10 * cell, 6)}) << 6;
    QTest::addRow("a region in a region")
        << sheetWith({middleBox(1), boxAt(8 * cell, 8 * cell, 12 * cell, 12 * cell, 3)}) << 3;
    QTest::addRow("regions that share a corner") << sheetWith({boxAt(4 * cell, 4 * cell, 10 * cell, 10 * cell, 1),
                                                               boxAt(10 * cell, 10 * cell, 16 * cell, 16 * cell, 1)})
                                                 << 1;
    QTest::addRow("slanted edges, a region over the border") << slantedPiece() << 2;
}

void tst_RegionJoints::smallStrainsPullNoInnerNode() {
    QFETCH(pattern::Piece, piece);
    QFETCH(int, refinement);
    const Garment garment = garmentOf(piece);
    QVERIFY(!garment.model.slaves.empty());
    constexpr double e = 1e-6;
    const double finest = std::ldexp(spacing, -refinement);
    for (const PlaneMap& map : {PlaneMap{1 + e, 0, 0, 1}, PlaneMap{1, 0, 0, 1 + e}, PlaneMap{1, e, 0, 1},
                                PlaneMap{1 + e, -e, 0.5 * e, 1 - e}}) {
        const double force = largestForce(garment, map, finest);
        QVERIFY2(force <= 1e-9, qPrintable(QString::number(force)));
    }
}

void tst_RegionJoints::largeStrainsPullNoNodeWhereCellsAreAlike_data() {
    QTest::addColumn<pattern::Piece>("piece");
    QTest::addColumn<int>("refinement");
    QTest::addRow("half the spacing in the middle") << sheetWith({middleBox(1)}) << 1;
    QTest::addRow("a quarter, with a ring of halves") << sheetWith({middleBox(2)}) << 2;
    QTest::addRow("a 64th on one cell") << sheetWith({boxAt(9 * cell, 9 * cell, 10 * cell, 10 * cell, 6)}) << 6;
}

void tst_RegionJoints::largeStrainsPullNoNodeWhereCellsAreAlike() {
    QFETCH(pattern::Piece, piece);
    QFETCH(int, refinement);
    const Garment garment = garmentOf(piece);
    const std::vector<int> joint = jointNodes(meshOf(garment));
    QVERIFY(joint.size() > 8);
    const double finest = std::ldexp(spacing, -refinement);
    for (const PlaneMap& map :
         {PlaneMap{1.05, 0, 0, 1}, PlaneMap{1, 0, 0, 1.05}, PlaneMap{1, 0.05, 0, 1}, PlaneMap{1.05, 0.05, 0, 0.95}}) {
        const double force = largestForce(garment, map, finest);
        QVERIFY2(force <= 1e-9, qPrintable(QString::number(force)));
    }
}

void tst_RegionJoints::aRolledSheetIsRoundAcrossItsJoints_data() {
    QTest::addColumn<int>("refinement");
    QTest::addColumn<int>("axis");
    for (const int refinement : {1, 2}) {
        QTest::addRow("1 : %d, bent along weft", 1 << refinement) << refinement << 0;
        QTest::addRow("1 : %d, bent along warp", 1 << refinement) << refinement << 1;
    }
}

void tst_RegionJoints::aRolledSheetIsRoundAcrossItsJoints() {
    QFETCH(int, refinement);
    QFETCH(int, axis);
    constexpr double radius = 0.2;
    Garment garment = garmentOf(sheetWith({middleBox(refinement)}));
    const std::vector<Vec2> material = materialOf(garment);
    dynamics::ParticleState state;
    for (int p = 0; p < static_cast<int>(material.size()); ++p) {
        const double along = axis == 0 ? material[p].x : material[p].y,
                     across = axis == 0 ? material[p].y : material[p].x;
        state.positions.push_back({radius * std::sin(along / radius), across, radius * std::cos(along / radius)});
        // Two rows at either end keep place and direction.
        if (along < 1.5 * cell || along > side - 1.5 * cell) garment.model.pinned.push_back(p);
    }
    cloth::placeSlaves(garment.model, state.positions);
    const auto solved = dynamics::solveStatic(garment.model, state, {}, {}, {.tolerance = 1e-7});
    QVERIFY(solved && solved->newton.converged);
    const meshing::PieceMesh& mesh = meshOf(garment);
    const Vec2 step = axis == 0 ? Vec2{cell, 0} : Vec2{0, cell};
    Range sides, corners;
    for (const int node : jointNodes(mesh)) {
        const int before = nodeAt(mesh, mesh.material[node] - step), behind = nodeAt(mesh, mesh.material[node] + step);
        if (before < 0 || behind < 0) continue; // between two lines of the main mesh
        const double curvature =
            curvatureThrough(state.positions[before], state.positions[node], state.positions[behind]) * radius;
        (isNearCorner(mesh.material[node]) ? corners : sides).add(curvature);
    }
    qInfo("curvature along the joint %.4f … %.4f of 1/R, near its corners %.4f … %.4f", sides.least, sides.most,
          corners.least, corners.most);
    QVERIFY(sides.least > 0.98 && sides.most < 1.02);
    // Where two joints meet, a slave on its chord is missing to both directions of bending.
    QVERIFY(corners.least > 0.96 && corners.most < 1.04);
}

void tst_RegionJoints::theFirstModeIsThatOfTheUniformFineMesh_data() {
    QTest::addColumn<pattern::Piece>("piece");
    QTest::addColumn<int>("refinement");
    QTest::addRow("half the spacing in the middle") << sheetWith({middleBox(1)}) << 1;
    QTest::addRow("half the spacing in a corner") << sheetWith({boxAt(2 * cell, 2 * cell, 8 * cell, 8 * cell, 1)}) << 1;
    QTest::addRow("a quarter, with a ring of halves") << sheetWith({middleBox(2)}) << 2;
}

void tst_RegionJoints::theFirstModeIsThatOfTheUniformFineMesh() {
    QFETCH(pattern::Piece, piece);
    QFETCH(int, refinement);
    const double regions = firstMode(garmentOf(piece)),
                 fine = firstMode(garmentOf(sheetWith({}, std::ldexp(spacing, -refinement))));
    qInfo("first mode %.4f Hz, of the uniform fine mesh %.4f Hz", regions, fine);
    QVERIFY(std::abs(regions / fine - 1) < 0.01);
}

TOILE_TEST(tst_RegionJoints)
#include "tst_RegionJoints.moc"
