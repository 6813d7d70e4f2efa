// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/body/BodyProfile.h"
#include "core/body/Mannequin.h"
#include "core/body/MeshSection.h"
#include "tests/Suite.h"
#include "tests/body/SampleMeasurements.h"

#include <QTest>
#include <cmath>
#include <fstream>
#include <sstream>

using namespace toile;
using namespace toile::body;
using geometry::TriangleMesh;

namespace {

/// Vertices and polygons of an OBJ file; polygons become fans.
TriangleMesh objMesh(const std::string& path) {
    TriangleMesh mesh;
    std::ifstream file(path);
    for (std::string line; std::getline(file, line);) {
        std::istringstream words(line);
        std::string kind, word;
        words >> kind;
        if (kind == "v") {
            Vec3& p = mesh.vertices.emplace_back();
            words >> p.x >> p.y >> p.z;
        } else if (kind == "f") {
            std::vector<int> corners;
            while (words >> word) corners.push_back(std::stoi(word) - 1);
            for (std::size_t i = 2; i < corners.size(); ++i)
                mesh.triangles.push_back({corners[0], corners[i - 1], corners[i]});
        }
    }
    return mesh;
}

TriangleMesh box(const Vec3& low, const Vec3& high) {
    TriangleMesh mesh;
    for (int c = 0; c < 8; ++c)
        mesh.vertices.push_back({c & 1 ? high.x : low.x, c & 2 ? high.y : low.y, c & 4 ? high.z : low.z});
    mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                      {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    return mesh;
}

void append(TriangleMesh& mesh, const TriangleMesh& other) {
    const int offset = static_cast<int>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), other.vertices.begin(), other.vertices.end());
    for (const auto& [a, b, c] : other.triangles) mesh.triangles.push_back({a + offset, b + offset, c + offset});
}

/// Four legs and a top, 0.75 m high.
TriangleMesh table() {
    TriangleMesh mesh = box({-0.6, 0.72, -0.4}, {0.6, 0.75, 0.4});
    for (const double x : {-0.55, 0.55})
        for (const double z : {-0.35, 0.35}) append(mesh, box({x - 0.03, 0, z - 0.03}, {x + 0.03, 0.72, z + 0.03}));
    return mesh;
}

TriangleMesh turnedRound(TriangleMesh mesh) {
    for (Vec3& p : mesh.vertices) p = {-p.x, p.y, -p.z};
    return mesh;
}

} // namespace

class tst_Recognition : public QObject {
    Q_OBJECT
private slots:
    void ourMannequinIsRecognised_data();
    void ourMannequinIsRecognised();
    void stretchedArmsAreFollowed();
    void heightAboveTheGroundDoesNotMatter();
    void bodiesFromElsewhereAreRecognised_data();
    void bodiesFromElsewhereAreRecognised();
    void whatIsNoBodyIsRefused_data();
    void whatIsNoBodyIsRefused();
};

void tst_Recognition::ourMannequinIsRecognised_data() {
    QTest::addColumn<Measurements>("measurements");
    QTest::addColumn<bool>("hasBust");
    for (const NamedMeasurements& m : sampleMeasurements())
        QTest::newRow(m.name.c_str()) << m.measurements << (m.measurements.bust > 1.1 * m.measurements.underBust);
}

void tst_Recognition::ourMannequinIsRecognised() {
    QFETCH(Measurements, measurements);
    QFETCH(bool, hasBust);
    const auto made = makeMannequin(measurements);
    QVERIFY(made);
    const auto found = recognizedBody("found", made->body.mesh);
    QVERIFY2(found, found ? "" : toString(found.error()).c_str());
    const Landmarks &truth = made->body.landmarks, &l = found->landmarks;
    const auto compare = [](const char* name, const Vec3& a, const Vec3& b) {
        // A landmark guessed from a smooth shape: a tape measurer's reach of 15–20 mm.
        QVERIFY2(distance(a, b) < 0.018,
                 qPrintable(QStringLiteral("%1 is %2 mm off").arg(name).arg(distance(a, b) * 1e3)));
    };
    compare("nape", l.nape, truth.nape);
    compare("frontNeck", l.frontNeck, truth.frontNeck);
    compare("neckLeft", l.neckLeft, truth.neckLeft);
    compare("neckRight", l.neckRight, truth.neckRight);
    compare("acromionLeft", l.acromionLeft, truth.acromionLeft);
    compare("acromionRight", l.acromionRight, truth.acromionRight);
    compare("hip", l.hip, truth.hip);
    compare("crotch", l.crotch, truth.crotch);
    compare("wristLeft", l.wristLeft, truth.wristLeft);
    compare("wristRight", l.wristRight, truth.wristRight);
    compare("ankleLeft", l.ankleLeft, truth.ankleLeft);
    compare("ankleRight", l.ankleRight, truth.ankleRight);
    if (!hasBust) return; // a straight body shows neither bust points nor a waist
    compare("bustLeft", l.bustLeft, truth.bustLeft);
    compare("bustRight", l.bustRight, truth.bustRight);
    compare("waist", l.waist, truth.waist);
}

void tst_Recognition::stretchedArmsAreFollowed() {
    const auto made = makeMannequin({.armAngle = 0.05});
    QVERIFY2(made, made ? "" : toString(made.error()).c_str());
    const auto found = recognizedBody("stretched", made->body.mesh);
    QVERIFY2(found, found ? "" : toString(found.error()).c_str());
    QVERIFY(distance(found->landmarks.wristLeft, made->body.landmarks.wristLeft) < 0.03);
    QVERIFY(distance(found->landmarks.acromionLeft, made->body.landmarks.acromionLeft) < 0.05); // no kink tells where
    QVERIFY(distance(found->landmarks.nape, made->body.landmarks.nape) < 0.018);
}

void tst_Recognition::heightAboveTheGroundDoesNotMatter() {
    const auto made = makeMannequin({});
    TriangleMesh lifted = made->body.mesh;
    for (Vec3& p : lifted.vertices) p += Vec3{0.3, 0.5, -0.2};
    const auto low = recognizedBody("low", made->body.mesh), high = recognizedBody("high", lifted);
    QVERIFY(low && high);
    QVERIFY(distance(low->landmarks.nape + Vec3{0.3, 0.5, -0.2}, high->landmarks.nape) < 1e-3); // one step of a search
    QVERIFY(distance(low->landmarks.wristLeft + Vec3{0.3, 0.5, -0.2}, high->landmarks.wristLeft) < 1e-3);
}

void tst_Recognition::bodiesFromElsewhereAreRecognised_data() {
    QTest::addColumn<QString>("file");
    QTest::addColumn<double>("waist"); // girth and heights as their licence page states them [m]
    QTest::addColumn<double>("waistHeight");
    QTest::addColumn<double>("hip");
    QTest::newRow("average woman") << "mh_female_adult.obj" << 0.652 << 1.028 << 0.946;
    QTest::newRow("woman of bust 98") << "mh_female_bust98.obj" << 0.784 << 1.086 << 1.046;
    QTest::newRow("woman of bust 100") << "mh_female_bust100_gc.obj" << 0.840 << 1.124 << 1.035;
    QTest::newRow("average man") << "mh_male_adult.obj" << 0.746 << 1.076 << 0.948;
    QTest::newRow("man of chest 102") << "mh_male_chest102.obj" << 0.857 << 1.113 << 1.010;
}

void tst_Recognition::bodiesFromElsewhereAreRecognised() {
    if (!qEnvironmentVariableIsSet("TOILE_TEST_DATA"))
        QSKIP("NOT RUN: needs TOILE_TEST_DATA (a folder with bodies/*.obj)");
    QFETCH(QString, file);
    QFETCH(double, waist);
    QFETCH(double, waistHeight);
    QFETCH(double, hip);
    const auto body = recognizedBody(
        "imported", objMesh((qEnvironmentVariable("TOILE_TEST_DATA") + "/bodies/" + file).toStdString()));
    QVERIFY2(body, body ? "" : toString(body.error()).c_str());
    const Landmarks& l = body->landmarks;
    const double h = profileOf(body->mesh).height;
    // Order from top to bottom and from back to front, where anatomy puts them.
    QVERIFY(l.nape.y > 0.82 * h && l.nape.y < 0.88 * h);
    QVERIFY(l.nape.y > l.acromionLeft.y && l.acromionLeft.y > l.bustLeft.y && l.bustLeft.y > l.waist.y);
    QVERIFY(l.waist.y > l.hip.y && l.hip.y > l.crotch.y && l.crotch.y > l.ankleLeft.y);
    QVERIFY(l.nape.z < l.neckLeft.z && l.neckLeft.z < l.frontNeck.z);
    QVERIFY(std::abs(l.nape.x) < 0.005);
    QVERIFY(l.acromionLeft.x > 0.10 * h && l.acromionLeft.x < 0.14 * h);
    QVERIFY(l.wristLeft.x > 0.2 * h);
    // Waist and hip by the tape.
    QVERIFY(std::abs(l.waist.y - waistHeight) < 0.01);
    QVERIFY(std::abs(tapeGirth(*trunkAt(body->mesh, profileOf(body->mesh), l.waist.y)) - waist) < 0.005);
    QVERIFY(std::abs(tapeGirth(*trunkAt(body->mesh, profileOf(body->mesh), l.hip.y)) - hip) < 0.005);
    // Left and right.
    const auto isMirrored = [](const Vec3& a, const Vec3& b) { return distance(a, {-b.x, b.y, b.z}) < 0.01; };
    QVERIFY(isMirrored(l.neckLeft, l.neckRight));
    QVERIFY(isMirrored(l.acromionLeft, l.acromionRight));
    QVERIFY(isMirrored(l.bustLeft, l.bustRight));
    QVERIFY(isMirrored(l.wristLeft, l.wristRight));
    QVERIFY(isMirrored(l.ankleLeft, l.ankleRight));
    QCOMPARE(body->axes.size(), std::size_t{6});
    // The arm's axis stays inside the arm: round each of its inner points there is a section no wider than an
    // arm.
    const auto& arm = body->axes[2].points;
    QVERIFY(arm.size() >= 5);
    for (std::size_t i = 1; i + 2 < arm.size(); ++i) {
        const auto loop = sectionRound(body->mesh, {arm[i], normalized(arm[i + 1] - arm[i - 1])});
        QVERIFY(loop && tapeGirth(*loop) < 0.45);
    }
}

void tst_Recognition::whatIsNoBodyIsRefused_data() {
    QTest::addColumn<TriangleMesh>("mesh");
    QTest::addColumn<QString>("said");
    const TriangleMesh mannequin = makeMannequin({})->body.mesh;
    TriangleMesh lying = mannequin;
    for (Vec3& p : lying.vertices) p = {p.x, -p.z, p.y};
    TriangleMesh huge = mannequin;
    for (Vec3& p : huge.vertices) p *= 10;
    QTest::newRow("nothing") << TriangleMesh{} << "does not look like a body";
    QTest::newRow("a table") << table() << "does not look like a body";
    QTest::newRow("a crate") << box({-0.4, 0, -0.4}, {0.4, 1.7, 0.4}) << "does not look like a body";
    QTest::newRow("lying down") << lying << "does not look like a body";
    QTest::newRow("in decimetres") << huge << "m high";
    QTest::newRow("facing away") << turnedRound(mannequin) << "−z";
}

void tst_Recognition::whatIsNoBodyIsRefused() {
    QFETCH(TriangleMesh, mesh);
    QFETCH(QString, said);
    const auto body = recognizedBody("thing", mesh);
    QVERIFY(!body);
    QVERIFY2(QString::fromStdString(body.error().text).contains(said), body.error().text.c_str());
    QCOMPARE(body.error().place.object, "thing");
}

TOILE_TEST(tst_Recognition)
#include "tst_Recognition.moc"
