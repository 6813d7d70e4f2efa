// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/RegularFile.h"
#include "core/io/AssimpMesh.h"
#include "core/io/DrapeExport.h"
#include "core/io/DrapeFaces.h"
#include "core/io/GlbFile.h"
#include "core/io/PlyReader.h"
#include "tests/Suite.h"

#include <QTemporaryDir>
#include <QTest>

#include <cstring>
#include <limits>
#include <sstream>

using namespace toile;
using simulation::FrameTopology;
namespace fs = std::filesystem;

namespace {

/// Two pieces: a strip of two rectangles with a triangle at its end, and one rectangle.
struct Drape {
    FrameTopology topology;
    std::vector<Vec3> positions;
};

Drape sampleDrape() {
    Drape drape;
    FrameTopology& t = drape.topology;
    t.pieces = {{"p1", "Front", 0, 7, 0, 5}, {"p2", "Back\npanel", 7, 4, 5, 2}};
    t.material = {{0, 0},      {0.1, 0}, {0.2, 0}, {0, 0.1}, {0.1, 0.1}, {0.2, 0.1},
                  {0.3, 0.05}, {0, 0},   {0.2, 0}, {0, 0.3}, {0.2, 0.3}};
    t.triangles = {{0, 1, 4}, {0, 4, 3}, {1, 2, 4}, {2, 5, 4}, {2, 6, 5}, {7, 8, 10}, {7, 10, 9}};
    t.triangleRegion.assign(7, -1);
    t.meshLines = {{0, 1}, {1, 2}, {3, 4}, {4, 5},  {0, 3},  {1, 4}, {2, 5},
                   {2, 6}, {5, 6}, {7, 8}, {8, 10}, {9, 10}, {7, 9}};
    for (std::size_t i = 0; i < t.material.size(); ++i)
        drape.positions.push_back({t.material[i].x, 1 + t.material[i].y, i < 7 ? 0.1 * t.material[i].x : -0.2});
    return drape;
}

} // namespace

class tst_DrapeExport : public QObject {
    Q_OBJECT
private slots:
    void twoTrianglesOfARectangleAreOneFace();
    void theGlbHasANodePerPieceWithItsFlatPattern();
    void everyFormatIsReadBackByAnotherReader_data();
    void everyFormatIsReadBackByAnotherReader();
    void theObjHasAGroupPerPieceAndQuads();
    void nothingIsWrittenThatIsNoDrape();
    void anOldFileStaysWhenTheNewOneIsRefused();
};

void tst_DrapeExport::twoTrianglesOfARectangleAreOneFace() {
    const auto drape = sampleDrape();
    const auto faces = io::facesOf(drape.topology, drape.topology.pieces[0]);
    QVERIFY(faces == (std::vector<std::vector<int>>{{0, 1, 4, 3}, {1, 2, 5, 4}, {2, 6, 5}}));
    auto plain = drape.topology;
    plain.meshLines.clear(); // nothing is known of the mesh: triangles
    QCOMPARE(io::facesOf(plain, plain.pieces[0]).size(), std::size_t(5));
}

void tst_DrapeExport::theGlbHasANodePerPieceWithItsFlatPattern() {
    const auto drape = sampleDrape();
    const auto glb = io::parseGlb(io::drapeGlb(drape.topology, drape.positions));
    QVERIFY(glb);
    const auto& nodes = *glb->json.find("nodes")->asArray();
    QCOMPARE(nodes.size(), std::size_t(2));
    QCOMPARE(*nodes[0].find("name")->asString(), std::string("Front"));
    QCOMPARE(*nodes[1].find("extras")->find("toile")->find("piece")->asString(), std::string("p2"));
    QVERIFY(*glb->json.find("materials")->asArray()->front().find("doubleSided")->asBool());

    const auto front = io::firstMesh(*glb);
    QVERIFY(front);
    QCOMPARE(front->vertices.size(), std::size_t(7));
    QCOMPARE(front->triangles.size(), std::size_t(5));
    for (std::size_t i = 0; i < 7; ++i) QVERIFY(distance(front->vertices[i], drape.positions[i]) < 1e-7); // floats

    const auto& primitive = glb->json.find("meshes")->asArray()->front().find("primitives")->asArray()->front();
    const auto accessor = static_cast<std::size_t>(*primitive.find("attributes")->find("TEXCOORD_0")->asNumber());
    const auto view =
        static_cast<std::size_t>(*(*glb->json.find("accessors")->asArray())[accessor].find("bufferView")->asNumber());
    const auto offset =
        static_cast<std::size_t>(*(*glb->json.find("bufferViews")->asArray())[view].find("byteOffset")->asNumber());
    for (std::size_t i = 0; i < 7; ++i) {
        float uv[2];
        std::memcpy(uv, glb->binary.data() + offset + i * sizeof uv, sizeof uv);
        QVERIFY(std::abs(uv[0] - drape.topology.material[i].x) < 1e-7);
        QVERIFY(std::abs(1 - uv[1] - drape.topology.material[i].y) < 1e-7);
    }
}

void tst_DrapeExport::everyFormatIsReadBackByAnotherReader_data() {
    QTest::addColumn<QString>("name");
    for (const char* name : {"drape.glb", "drape.obj", "drape.stl", "drape.ply", "DRAPE.OBJ"})
        QTest::newRow(name) << name;
}

void tst_DrapeExport::everyFormatIsReadBackByAnotherReader() {
    QFETCH(QString, name);
    const auto drape = sampleDrape();
    QTemporaryDir folder;
    const fs::path path = fs::path(folder.path().toStdString()) / name.toStdString();
    const auto written = io::writeDrape(path, drape.topology, drape.positions);
    QVERIFY2(written, written ? "" : toString(written.error()).c_str());

    geometry::TriangleMesh mesh;
    if (name.endsWith(".ply")) {
        const auto read = io::meshFromPly(*readRegularFile(path, 1 << 20));
        QVERIFY2(read, read ? "" : toString(read.error()).c_str());
        mesh = *read;
    } else {
        const auto read = io::meshThroughAssimp(path);
        QVERIFY2(read, read ? "" : toString(read.error()).c_str());
        mesh = read->mesh;
    }
    QCOMPARE(mesh.triangles.size(), drape.topology.triangles.size());
    Vec3 area, expected; // vector area: right sides and positions are kept, whatever the order of triangles
    const auto areaOf = [](const std::vector<Vec3>& v, const auto& t) {
        return cross(v[t[1]] - v[t[0]], v[t[2]] - v[t[0]]) / 2;
    };
    for (const auto& t : mesh.triangles) area += areaOf(mesh.vertices, t);
    for (const auto& t : drape.topology.triangles) expected += areaOf(drape.positions, t);
    QVERIFY(distance(area, expected) < 1e-7);
    const auto box = geometry::boundsOf(mesh.vertices);
    QVERIFY(distance(box.low, {0, 1, -0.2}) < 1e-6 && distance(box.high, {0.3, 1.3, 0.03}) < 1e-6);
}

void tst_DrapeExport::theObjHasAGroupPerPieceAndQuads() {
    const auto drape = sampleDrape();
    std::istringstream text(io::drapeObj(drape.topology, drape.positions));
    std::vector<std::string> groups;
    int quads = 0, triangles = 0, coordinates = 0;
    for (std::string line; std::getline(text, line);) {
        if (line.starts_with("g ")) groups.push_back(line.substr(2));
        if (line.starts_with("vt ")) ++coordinates;
        if (line.starts_with("f ")) ++(std::ranges::count(line, ' ') == 4 ? quads : triangles);
    }
    QVERIFY(groups == (std::vector<std::string>{"Front", "Back panel"})); // a name cannot break the file
    QCOMPARE(quads, 3);
    QCOMPARE(triangles, 1);
    QCOMPARE(coordinates, 11);
}

void tst_DrapeExport::nothingIsWrittenThatIsNoDrape() {
    auto drape = sampleDrape();
    QTemporaryDir folder;
    const fs::path at = folder.path().toStdString();
    QCOMPARE(io::writeDrape(at / "a.fbx", drape.topology, drape.positions).error().code, ErrorCode::unsupported);
    QVERIFY(!io::writeDrape(at / "nowhere" / "a.glb", drape.topology, drape.positions));
    QVERIFY(!io::writeDrape(at / "a.glb", {}, {}));
    QVERIFY(!io::writeDrape(at / "a.glb", drape.topology, std::span(drape.positions).first(5)));
    drape.positions[2].y = std::numeric_limits<double>::infinity();
    QVERIFY(!io::writeDrape(at / "a.glb", drape.topology, drape.positions));
    QVERIFY(fs::is_empty(at));
}

void tst_DrapeExport::anOldFileStaysWhenTheNewOneIsRefused() {
    auto drape = sampleDrape();
    QTemporaryDir folder;
    const fs::path path = fs::path(folder.path().toStdString()) / "a.stl";
    QVERIFY(io::writeDrape(path, drape.topology, drape.positions));
    const auto before = *readRegularFile(path, 1 << 20);
    drape.positions[2].y = std::numeric_limits<double>::quiet_NaN();
    QVERIFY(!io::writeDrape(path, drape.topology, drape.positions));
    QVERIFY(*readRegularFile(path, 1 << 20) == before);
}

TOILE_TEST(tst_DrapeExport)
#include "tst_DrapeExport.moc"
