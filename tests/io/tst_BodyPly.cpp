// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/AtomicFile.h"
#include "core/base/Contracts.h"
#include "core/io/BodyImport.h"
#include "core/io/PlyReader.h"
#include "tests/Suite.h"
#include "tests/collision/Shapes.h"

#include <QTemporaryDir>
#include <QTest>

#include <fmt/format.h>

using namespace toile;
using io::meshFromPly;

namespace {

const std::string header =
    "ply\nformat ascii 1.0\ncomment made by hand\nelement vertex 4\nproperty float x\n"
    "property float y\nproperty float z\nelement face 1\nproperty list uchar int vertex_indices\n"
    "end_header\n";
const std::string square = "0 0 0\n1 0 0\n1 1 0\n0 1 0.5\n4 0 1 2 3\n";

template <class T>
void append(std::string& bytes, T value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

std::string binary(const geometry::TriangleMesh& mesh) {
    std::string bytes = fmt::format("ply\nformat binary_little_endian 1.0\nelement vertex {}\nproperty double x\n"
                                    "property uchar red\nproperty double y\nproperty double z\nelement edge 2\n"
                                    "property list uchar short ends\nelement face {}\nproperty int flags\n"
                                    "property list uint uint vertex_index\nend_header\n",
                                    mesh.vertices.size(), mesh.triangles.size());
    for (const Vec3& v : mesh.vertices) {
        append(bytes, v.x);
        append(bytes, std::uint8_t(7));
        append(bytes, v.y);
        append(bytes, v.z);
    }
    for (int edge = 0; edge < 2; ++edge) {
        append(bytes, std::uint8_t(2));
        append(bytes, std::int16_t(0));
        append(bytes, std::int16_t(1));
    }
    for (const auto& t : mesh.triangles) {
        append(bytes, std::int32_t(-1));
        append(bytes, std::uint32_t(3));
        for (const int corner : t) append(bytes, std::uint32_t(corner));
    }
    return bytes;
}

} // namespace

class tst_BodyPly : public QObject {
    Q_OBJECT
private slots:
    void anAsciiPolygonBecomesAFan();
    void binaryNumbersAreReadBitForBitAndOtherElementsSkipped();
    void everyCutIsRefused();
    void brokenFilesAreRefused_data();
    void brokenFilesAreRefused();
    void randomDamageGivesASoundMeshOrAnError();
    void aPlyBodyIsImported();
};

void tst_BodyPly::anAsciiPolygonBecomesAFan() {
    const auto mesh = meshFromPly(header + square);
    QVERIFY2(mesh, mesh ? "" : mesh.error().text.c_str());
    QCOMPARE(mesh->vertices.size(), std::size_t(4));
    QVERIFY(mesh->vertices[3] == (Vec3{0, 1, 0.5}));
    QVERIFY(mesh->triangles == (std::vector<geometry::TriangleIndices>{{0, 1, 2}, {0, 2, 3}}));
    std::string dos = header + square; // lines of another system
    for (std::size_t at = 0; (at = dos.find('\n', at)) != std::string::npos; at += 2) dos.insert(at, 1, '\r');
    QVERIFY(meshFromPly(dos));
}

void tst_BodyPly::binaryNumbersAreReadBitForBitAndOtherElementsSkipped() {
    const auto sphere = shapes::bumpySphere(6, 8);
    const auto mesh = meshFromPly(binary(sphere));
    QVERIFY2(mesh, mesh ? "" : mesh.error().text.c_str());
    QVERIFY(*mesh == sphere);
}

void tst_BodyPly::everyCutIsRefused() {
    const std::string ascii = header + square, bytes = binary(shapes::box({0, 0, 0}, {1, 1, 1}));
    for (std::size_t n = 0; n + 2 < ascii.size(); ++n) QVERIFY(!meshFromPly(ascii.substr(0, n)));
    for (std::size_t n = 0; n < bytes.size(); ++n) QVERIFY(!meshFromPly(bytes.substr(0, n)));
}

void tst_BodyPly::brokenFilesAreRefused_data() {
    QTest::addColumn<QString>("text");
    const auto with = [](std::string text, const std::string& what, const std::string& by) {
        text.replace(text.find(what), what.size(), by);
        return QString::fromStdString(text);
    };
    const std::string whole = header + square;
    QTest::newRow("negative index") << with(whole, "4 0 1", "4 0 -1");
    QTest::newRow("index too large") << with(whole, "4 0 1", "4 0 4");
    QTest::newRow("index that is no number") << with(whole, "4 0 1", "4 0 x");
    QTest::newRow("index NaN") << with(whole, "4 0 1", "4 0 nan");
    QTest::newRow("4 billion vertices") << with(whole, "vertex 4", "vertex 4294967295");
    QTest::newRow("more vertices than can be counted") << with(whole, "vertex 4", "vertex 99999999999999999999999");
    QTest::newRow("4 billion faces") << with(whole, "face 1", "face 4294967295");
    QTest::newRow("a face of a billion corners") << with(whole, "4 0 1", "1000000000 0 1");
    QTest::newRow("a face of -1 corners") << with(whole, "4 0 1", "-1 0 1");
    QTest::newRow("an element without properties")
        << with(whole, "element vertex 4", "element ghost 4000000000\nelement vertex 4");
    QTest::newRow("big-endian") << with(whole, "ascii", "binary_big_endian");
    QTest::newRow("unknown type") << with(whole, "float y", "quad y");
    QTest::newRow("property before an element") << with(whole, "comment", "property float w\ncomment");
    QTest::newRow("no faces") << with(with(whole, "face 1", "face 0").toStdString(), "4 0 1 2 3\n", "");
    QTest::newRow("no end of the header") << with(whole, "end_header", "comment");
    QTest::newRow("another file") << QString("solid x\n");
    QTest::newRow("nothing") << QString();
}

void tst_BodyPly::brokenFilesAreRefused() {
    QFETCH(QString, text);
    const auto mesh = meshFromPly(text.toStdString(), "a.ply");
    QVERIFY(!mesh);
    QCOMPARE(mesh.error().place.file, std::string("a.ply"));
}

void tst_BodyPly::randomDamageGivesASoundMeshOrAnError() {
    const unsigned seed = 41;
    std::mt19937 random(seed);
    const std::string sound[]{header + square, binary(shapes::bumpySphere(6, 8))};
    for (int n = 0; n < 3000; ++n) {
        std::string bytes = sound[n % 2];
        for (unsigned k = random() % 30; k > 0; --k) bytes[random() % bytes.size()] = char(random());
        const auto mesh = meshFromPly(bytes);
        if (!mesh) continue;
        for (const auto& t : mesh->triangles)
            for (const int corner : t) QVERIFY(corner >= 0 && corner < int(mesh->vertices.size()));
    }
}

void tst_BodyPly::aPlyBodyIsImported() {
    QTemporaryDir folder;
    const auto path = std::filesystem::path(folder.path().toStdString()) / "body.ply";
    auto body = shapes::starBody(8, 12, [](const Vec3& d) { return 0.85 / std::hypot(d.y, 3 * d.x, 4 * d.z); });
    QVERIFY(writeFileAtomically(path, binary(body)));
    const auto mesh = io::readBodyMesh(path);
    QVERIFY2(mesh, mesh ? "" : toString(mesh.error()).c_str());
    QCOMPARE(mesh->triangles.size(), body.triangles.size());
    body.vertices[3].x = std::numeric_limits<double>::quiet_NaN(); // the numbers are judged by the import
    QVERIFY(writeFileAtomically(path, binary(body)));
    QVERIFY(!io::readBodyMesh(path));
}

TOILE_TEST(tst_BodyPly)
#include "tst_BodyPly.moc"
