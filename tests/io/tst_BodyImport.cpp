// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/AtomicFile.h"
#include "core/base/Contracts.h"
#include "core/io/BodyGlb.h"
#include "core/io/BodyImport.h"
#include "core/io/ChildProcess.h"
#include "tests/Suite.h"
#include "tests/collision/Shapes.h"

#include <QTemporaryDir>
#include <QTest>

#include <cstdio>
#include <fmt/format.h>
#include <sys/stat.h>

using namespace toile;
using geometry::TriangleMesh;
using io::readBodyMesh;
namespace fs = std::filesystem;

namespace {

/// An egg of the given height, standing on the floor.
TriangleMesh egg(double height) {
    auto mesh = shapes::starBody(8, 12, [](const Vec3& d) { return 1 / std::hypot(d.y, 3 * d.x, 4 * d.z); });
    for (Vec3& v : mesh.vertices) v = v * (height / 2) + Vec3{0, height / 2, 0};
    return mesh;
}

std::string objText(const TriangleMesh& mesh) {
    std::string text;
    for (const Vec3& v : mesh.vertices) text += fmt::format("v {} {} {}\n", v.x, v.y, v.z);
    for (const auto& [a, b, c] : mesh.triangles) text += fmt::format("f {} {} {}\n", a + 1, b + 1, c + 1);
    return text;
}

/// Every triangle with corners of its own, as STL files are.
std::string stlText(const TriangleMesh& mesh) {
    std::string text = "solid egg\n";
    for (const auto& t : mesh.triangles) {
        text += "facet normal 0 0 0\nouter loop\n";
        for (const int corner : t) {
            const Vec3& v = mesh.vertices[corner];
            text += fmt::format("vertex {} {} {}\n", v.x, v.y, v.z);
        }
        text += "endloop\nendfacet\n";
    }
    return text + "endsolid egg\n";
}

double heightOf(const TriangleMesh& mesh) {
    const auto box = geometry::boundsOf(mesh.vertices);
    return box.high.y - box.low.y;
}

/// Rounded to float. (volatile: GCC 12 at -O2 drops double → float → double where it vectorises.)
double asFloat(double x) {
    volatile float rounded = static_cast<float>(x);
    return rounded;
}

body::Body sampleBody() {
    body::Body body{"Ann", egg(1.7), {}, {}};
    double x = 0.1;
    for (Vec3* p : {&body.landmarks.nape, &body.landmarks.frontNeck, &body.landmarks.neckLeft,
                    &body.landmarks.neckRight, &body.landmarks.acromionLeft, &body.landmarks.acromionRight,
                    &body.landmarks.bustLeft, &body.landmarks.bustRight, &body.landmarks.waist, &body.landmarks.hip,
                    &body.landmarks.crotch, &body.landmarks.wristLeft, &body.landmarks.wristRight,
                    &body.landmarks.ankleLeft, &body.landmarks.ankleRight}) {
        *p = {x / 3, x / 7, -x / 11}; // numbers that no short text holds
        x += 0.1;
    }
    body.axes = {{body::Limb::neck, {{0, 1.4, 0}, {0, 1.8, 0.1 / 3}}}, {body::Limb::leftArm, {{0.2, 1.3, 0}}}};
    return body;
}

} // namespace

class tst_BodyImport : public QObject {
    Q_OBJECT
private slots:
    void aBodyIsTheSameAfterWritingAndReading();
    void someoneElsesProgramReadsOurGlb();
    void aPartCalledBodyIsTakenAlone_data();
    void aPartCalledBodyIsTakenAlone();
    void cornersOfTrianglesAreWelded();
    void theUnitIsJudgedByTheHeight_data();
    void theUnitIsJudgedByTheHeight();
    void aFormatThatSaysMetresIsTakenAtItsWord();
    void aUnitThatIsToldIsNotJudged();
    void aLyingBodyIsStoodUp();
    void trianglesThatFaceInwardAreTurnedRound();
    void aTableNeedsNoHumanHeight();
    void anOpenMeshIsReadWithAWarning();
    void filesThatAreNoFilesAreRefused();
    void damagedFilesAreRefused_data();
    void damagedFilesAreRefused();
    void randomDamageNeverStopsTheProgram();
    void aBrokenLandmarkIsNamed();
    void workInAChildMayCrashHangOrEatMemory();
    void bodiesOfTheTestDataAreRead();

private:
    QTemporaryDir folder;
    [[nodiscard]] fs::path put(const std::string& name, const std::string& bytes) const {
        const fs::path path = fs::path(folder.path().toStdString()) / name;
        expects(writeFileAtomically(path, bytes).has_value(), "a test writes its file");
        return path;
    }
};

void tst_BodyImport::aBodyIsTheSameAfterWritingAndReading() {
    auto body = sampleBody();
    for (Vec3& v : body.mesh.vertices) v = {asFloat(v.x), asFloat(v.y), asFloat(v.z)};
    const fs::path path = put("ann.glb", "");
    QVERIFY(io::writeBody(path, body));
    const auto glb = io::parseGlb(io::toBytes(io::glbOf(body)));
    QVERIFY(glb);
    const auto again = io::bodyOf(*glb, "");
    QVERIFY(again && *again);
    QCOMPARE((*again)->name, body.name);
    QVERIFY((*again)->mesh == body.mesh);
    QVERIFY((*again)->landmarks == body.landmarks); // bit for bit
    QVERIFY((*again)->axes == body.axes);
    const auto mesh = readBodyMesh(path);
    QVERIFY(mesh);
    QVERIFY(*mesh == body.mesh);
}

void tst_BodyImport::someoneElsesProgramReadsOurGlb() {
    auto body = sampleBody();
    auto glb = io::glbOf(body);
    Json asset;
    asset.set("version", "2.0");
    glb.json.set("asset", asset); // without our extras it goes the way of foreign files: through assimp
    const auto mesh = readBodyMesh(put("foreign.glb", io::toBytes(glb)));
    QVERIFY2(mesh, mesh ? "" : toString(mesh.error()).c_str());
    QCOMPARE(mesh->triangles.size(), body.mesh.triangles.size());
    QVERIFY(std::abs(geometry::signedVolume(*mesh) - geometry::signedVolume(body.mesh)) < 1e-6); // floats
}

void tst_BodyImport::aPartCalledBodyIsTakenAlone_data() {
    QTest::addColumn<QString>("node");
    QTest::addColumn<QString>("mesh");
    QTest::addColumn<int>("primitives"); // of the part
    QTest::addColumn<bool>("alone");
    QTest::newRow("by its mesh") << "Ann"
                                 << "body" << 1 << true;
    QTest::newRow("by its node") << "Body"
                                 << "Mesh.001" << 1 << true;
    QTest::newRow("by a mesh of two primitives") << "Ann"
                                                 << "body" << 2 << true;
    QTest::newRow("by a node of two primitives") << "body"
                                                 << "Mesh.001" << 2 << true;
    QTest::newRow("not by a longer name") << "Ann"
                                          << "body-suit" << 1 << false;
}

void tst_BodyImport::aPartCalledBodyIsTakenAlone() {
    QFETCH(QString, node);
    QFETCH(QString, mesh);
    QFETCH(int, primitives);
    QFETCH(bool, alone);
    auto glb = io::glbOf({"Ann", egg(1.7), {}, {}});
    const auto named = [](const QString& name) { return Json(Json::Object{{"name", name.toStdString()}}); };
    const Json primitive = glb.json.find("meshes")->asArray()->front().find("primitives")->asArray()->front();
    Json part = named(mesh), hat = named("hat"), partNode = named(node), hatNode = named("hat"), asset;
    for (Json* each : {&part, &hat}) each->set("primitives", Json(Json::Array{primitive}));
    if (primitives == 2) part.set("primitives", Json(Json::Array{primitive, primitive}));
    hatNode.set("mesh", 1).set("translation", Json(Json::Array{0.5, 0.3, 0}));
    asset.set("version", "2.0"); // without our extras it goes through assimp
    glb.json.set("asset", asset).set("meshes", Json(Json::Array{part, hat}));
    glb.json.set("nodes", Json(Json::Array{partNode.set("mesh", 0), hatNode}));
    glb.json.set("scenes", Json(Json::Array{Json(Json::Object{{"nodes", Json(Json::Array{0, 1})}})}));
    std::vector<Warning> warnings;
    const auto read = readBodyMesh(put("parts.glb", io::toBytes(glb)), {}, &warnings);
    QVERIFY2(read, read ? "" : toString(read.error()).c_str());
    QVERIFY(std::abs(heightOf(*read) - (alone ? 1.7 : 2.0)) < 1e-6); // the hat is 0.3 m higher
    QCOMPARE(std::ranges::count_if(warnings,
                                   [](const Warning& said) { return said.text.find("\"body\"") != std::string::npos; }),
             alone ? 1 : 0);
}

void tst_BodyImport::cornersOfTrianglesAreWelded() {
    const auto whole = egg(1.7);
    const auto mesh = readBodyMesh(put("egg.stl", stlText(whole)));
    QVERIFY2(mesh, mesh ? "" : toString(mesh.error()).c_str());
    QCOMPARE(mesh->vertices.size(), whole.vertices.size());
    QVERIFY(geometry::isClosedManifold(*mesh));
}

void tst_BodyImport::theUnitIsJudgedByTheHeight_data() {
    QTest::addColumn<double>("height");
    QTest::addColumn<QString>("unit"); // empty: refused
    QTest::newRow("metres") << 1.7 << "metres";
    QTest::newRow("decimetres") << 17.0 << "decimetres";
    QTest::newRow("centimetres") << 170.0 << "centimetres";
    QTest::newRow("millimetres") << 1700.0 << "millimetres";
    QTest::newRow("inches") << 67.0 << "inches";
    QTest::newRow("a tenth of a body") << 0.17 << "";
    QTest::newRow("a house") << 5.0 << "";
}

void tst_BodyImport::theUnitIsJudgedByTheHeight() {
    QFETCH(double, height);
    QFETCH(QString, unit);
    std::vector<Warning> warnings;
    const auto mesh = readBodyMesh(put("egg.obj", objText(egg(height))), {}, &warnings);
    if (unit.isEmpty()) {
        QVERIFY(!mesh);
        QVERIFY(mesh.error().text.find("m high") != std::string::npos);
        return;
    }
    QVERIFY2(mesh, mesh ? "" : toString(mesh.error()).c_str());
    QVERIFY(std::abs(heightOf(*mesh) - (unit == "inches" ? 67 * 0.0254 : 1.7)) < 1e-6);
    QCOMPARE(warnings.size(), std::size_t(unit == "metres" ? 0 : 1));
    if (!warnings.empty()) QVERIFY(warnings[0].text.find(unit.toStdString()) != std::string::npos);
}

void tst_BodyImport::aFormatThatSaysMetresIsTakenAtItsWord() {
    for (const auto& [height, unit] : {std::pair(17.0, "decimetres"), std::pair(170.0, "centimetres")}) {
        auto glb = io::glbOf({"tall", egg(height), {}, {}});
        Json asset;
        asset.set("version", "2.0");
        glb.json.set("asset", asset);
        const auto mesh = readBodyMesh(put("tall.glb", io::toBytes(glb)));
        QVERIFY(!mesh);
        QVERIFY(mesh.error().text.find(unit) != std::string::npos);
    }
}

void tst_BodyImport::aUnitThatIsToldIsNotJudged() {
    const auto path = put("egg.obj", objText(egg(67)));
    io::BodyImportSettings settings;
    settings.unit = io::LengthUnit::centimetre;
    QVERIFY(!readBodyMesh(path, settings)); // 0.67 m
    settings.unit = io::LengthUnit::inch;
    std::vector<Warning> warnings;
    QVERIFY(readBodyMesh(path, settings, &warnings));
    QVERIFY(warnings.empty());
}

void tst_BodyImport::aLyingBodyIsStoodUp() {
    auto lying = egg(1.7);
    for (Vec3& v : lying.vertices) v = {v.x, -v.z, v.y};
    std::vector<Warning> warnings;
    const auto mesh = readBodyMesh(put("lying.obj", objText(lying)), {}, &warnings);
    QVERIFY(mesh);
    QVERIFY(std::abs(heightOf(*mesh) - 1.7) < 1e-6);
    QCOMPARE(warnings.size(), std::size_t(1));
    QVERIFY(geometry::signedVolume(*mesh) > 0); // turned, not mirrored
}

void tst_BodyImport::trianglesThatFaceInwardAreTurnedRound() {
    auto inward = egg(1.7);
    for (auto& t : inward.triangles) std::swap(t[0], t[1]);
    std::vector<Warning> warnings;
    const auto mesh = readBodyMesh(put("inward.obj", objText(inward)), {}, &warnings);
    QVERIFY(mesh);
    QVERIFY(geometry::signedVolume(*mesh) > 0);
    QCOMPARE(warnings.size(), std::size_t(1));
}

void tst_BodyImport::aTableNeedsNoHumanHeight() {
    const auto path = put("table.obj", objText(shapes::box({-0.4, 0.7, -0.4}, {0.4, 0.75, 0.4})));
    QVERIFY(!readBodyMesh(path));
    io::BodyImportSettings settings;
    settings.isHuman = false;
    const auto mesh = readBodyMesh(path, settings);
    QVERIFY(mesh);
    QVERIFY(std::abs(heightOf(*mesh) - 0.05) < 1e-6);
}

void tst_BodyImport::anOpenMeshIsReadWithAWarning() {
    auto open = egg(1.7);
    open.triangles.resize(open.triangles.size() - 3);
    std::vector<Warning> warnings;
    QVERIFY(readBodyMesh(put("open.obj", objText(open)), {}, &warnings));
    QCOMPARE(warnings.size(), std::size_t(1));
}

void tst_BodyImport::filesThatAreNoFilesAreRefused() {
    const fs::path at = folder.path().toStdString();
    QCOMPARE(readBodyMesh(at / "missing.obj").error().code, ErrorCode::notFound);
    fs::create_directory(at / "folder.obj");
    QVERIFY(!readBodyMesh(at / "folder.obj"));
    for (const char* name : {"pipe.obj", "pipe.ply", "pipe.glb"}) {
        QCOMPARE(::mkfifo((at / name).c_str(), 0600), 0);
        const auto mesh = readBodyMesh(at / name);
        QVERIFY(!mesh);
        QCOMPARE(mesh.error().place.file, (at / name).string());
    }
    QVERIFY(!readBodyMesh(put("empty.stl", "")));
    QCOMPARE(readBodyMesh(put("body.docx", "x")).error().code, ErrorCode::unsupported);
    io::BodyImportSettings settings;
    settings.largestFile = 100;
    QCOMPARE(readBodyMesh(put("big.obj", std::string(101, ' ')), settings).error().code, ErrorCode::tooLarge);
}

void tst_BodyImport::damagedFilesAreRefused_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<QByteArray>("bytes");
    const auto row = [](const char* what, const char* name, const std::string& bytes) {
        QTest::newRow(what) << name << QByteArray(bytes.data(), qsizetype(bytes.size()));
    };
    const std::string obj = objText(egg(1.7)), stl = stlText(egg(1.7));
    row("OBJ cut off after its vertices", "a.obj", obj.substr(0, obj.find("f ")));
    row("OBJ with an index beyond the end", "a.obj", obj + "f 1 2 99999\n");
    row("OBJ with NaN", "a.obj", "v nan 0 0\n" + obj + "f 1 2 3\n");
    row("OBJ with infinity", "a.obj", "v 1e999 0 0\nv inf 0 0\n" + obj + "f 1 2 3\n");
    row("OBJ of noise", "a.obj", std::string("\x8f\x01\xfe lorem \0 ipsum", 18));
    row("STL cut off", "a.stl", stl.substr(0, 40));
    row("STL of 4 billion triangles", "a.stl", std::string(80, 'x').append(4, '\xff').append(50, 'y'));
    row("glTF that is no JSON", "a.gltf", "{\"asset\": ");
    row("COLLADA cut off", "a.dae", "<?xml version=\"1.0\"?><COLLADA><library_geometries><geometry id=\"a\">");
    row("FBX of noise", "a.fbx", "Kaydara FBX Binary  \0\x1a\0 and nothing more");
    const std::string glb = io::toBytes(io::glbOf(sampleBody()));
    row("GLB cut off in its head", "a.glb", glb.substr(0, 15));
    row("GLB cut off in its JSON", "a.glb", glb.substr(0, 300));
    row("GLB cut off in its numbers", "a.glb", glb.substr(0, glb.size() / 2));
}

void tst_BodyImport::damagedFilesAreRefused() {
    QFETCH(QString, name);
    QFETCH(QByteArray, bytes);
    const auto mesh = readBodyMesh(put(name.toStdString(), bytes.toStdString()));
    QVERIFY(!mesh);
    QVERIFY(!mesh.error().text.empty());
    QVERIFY(!mesh.error().place.file.empty());
}

void tst_BodyImport::randomDamageNeverStopsTheProgram() {
    const unsigned seed = 31;
    std::mt19937 random(seed);
    const std::vector<std::pair<std::string, std::string>> sound{
        {"a.obj", objText(egg(1.7))}, {"a.stl", stlText(egg(1.7))}, {"a.glb", io::toBytes(io::glbOf(sampleBody()))}};
    int refused = 0;
    for (int n = 0; n < 60; ++n) {
        auto [name, bytes] = sound[n % sound.size()];
        if (n % 2) bytes.resize(random() % bytes.size());
        for (int k = 0; k < 20 && !bytes.empty(); ++k) bytes[random() % bytes.size()] = char(random());
        const auto mesh = readBodyMesh(put(name, bytes));
        refused += !mesh;
        if (!mesh) continue;
        for (const Vec3& v : mesh->vertices) QVERIFY2(isFinite(v), qPrintable(QString("seed %1").arg(seed)));
        for (const auto& t : mesh->triangles)
            for (const int corner : t) QVERIFY(corner >= 0 && corner < int(mesh->vertices.size()));
    }
    QVERIFY(refused > 0);
}

void tst_BodyImport::aBrokenLandmarkIsNamed() {
    auto glb = io::glbOf(sampleBody());
    std::string text = toLine(glb.json);
    const auto at = text.find("\"waist\"");
    QVERIFY(at != std::string::npos);
    text.replace(at, 7, "\"vaist\"");
    glb.json = *parseJson(text);
    const auto mesh = readBodyMesh(put("a.glb", io::toBytes(glb)));
    QVERIFY(!mesh);
    QVERIFY(mesh.error().text.find("waist") != std::string::npos);
}

void tst_BodyImport::workInAChildMayCrashHangOrEatMemory() {
    QCOMPARE(*io::runInChild([] { return std::string(3'000'000, 'x'); }), std::string(3'000'000, 'x'));
    QVERIFY(!io::runInChild([]() -> std::string { std::abort(); }));
    QVERIFY(!io::runInChild([]() -> std::string { throw 1; }));
    QVERIFY(!io::runInChild(
        []() -> std::string {
            for (volatile bool on = true; on;) {
            }
            return "";
        },
        {.seconds = 0.2}));
    QVERIFY(!io::runInChild([] { return std::string(1'000'000, 'x'); }, {.answer = 1000}));
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
    QVERIFY(!io::runInChild([] { return std::string(std::size_t(8) << 30, 'x'); })); // 8 GiB against 4
#endif
}

void tst_BodyImport::bodiesOfTheTestDataAreRead() {
    const char* data = std::getenv("TOILE_TEST_DATA");
    if (!data || !*data) {
        std::puts("NOT RUN: needs TOILE_TEST_DATA (a folder with bodies/*.obj and *.glb)");
        QSKIP("NOT RUN: needs TOILE_TEST_DATA");
    }
    int read = 0;
    for (const auto& entry : fs::directory_iterator(fs::path(data) / "bodies")) {
        const std::string extension = entry.path().extension().string();
        if (extension != ".obj" && extension != ".glb") continue;
        std::vector<Warning> warnings;
        const auto mesh = readBodyMesh(entry.path(), {}, &warnings);
        QVERIFY2(mesh, mesh ? "" : toString(mesh.error()).c_str());
        QVERIFY2(geometry::isClosedManifold(*mesh), entry.path().c_str());
        const double height = heightOf(*mesh);
        QVERIFY(height > 1.5 && height < 1.9);
        const bool foreign = entry.path().stem() == "makehuman_hm08_base_full"; // decimetres, 138 helper groups
        QCOMPARE(warnings.size(), std::size_t(foreign ? 2 : 0));
        std::printf("%s: %zu vertices, %zu triangles, %.3f m\n", entry.path().filename().c_str(), mesh->vertices.size(),
                    mesh->triangles.size(), height);
        ++read;
    }
    QVERIFY(read > 0);
}

TOILE_TEST(tst_BodyImport)
#include "tst_BodyImport.moc"
