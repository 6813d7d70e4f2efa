// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/body/Mannequin.h"
#include "tests/Suite.h"

#include "core/body/MeshSection.h"
#include "tests/body/SampleMeasurements.h"

#include <QTest>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

using namespace toile;
using namespace toile::body;

namespace {

constexpr double promise = 0.005; // of girths and lengths [m]

/// Each sample is computed once for all slots.
const Mannequin& mannequinOf(std::size_t sample) {
    static std::map<std::size_t, Mannequin> made;
    if (const auto found = made.find(sample); found != made.end()) return found->second;
    auto mannequin = makeMannequin(sampleMeasurements()[sample].measurements);
    if (!mannequin) qFatal("%s", toString(mannequin.error()).c_str());
    return made.emplace(sample, std::move(*mannequin)).first->second;
}

double distanceToMesh(const Vec3& p, const geometry::TriangleMesh& mesh) {
    double best = 1e9;
    for (const auto& [a, b, c] : mesh.triangles) { // corners, edge middles and centroid: fine enough for 10 mm edges
        const Vec3 &u = mesh.vertices[a], &v = mesh.vertices[b], &w = mesh.vertices[c];
        const Vec3 normal = normalized(cross(v - u, w - u)), centroid = (u + v + w) / 3;
        if (distance(p, centroid) < 0.012) best = std::min(best, std::abs(dot(p - u, normal)));
    }
    return best;
}

/// How often a polyline goes through the surface. Shifted a little, off the edges in the plane of symmetry.
int crossings(const std::vector<Vec3>& line, const geometry::TriangleMesh& mesh) {
    int count = 0;
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        const Vec3 from = line[i] + Vec3{1.3e-4, 0, 1.7e-4}, along = line[i + 1] - line[i];
        for (const auto& [a, b, c] : mesh.triangles) {
            const Vec3 e1 = mesh.vertices[b] - mesh.vertices[a], e2 = mesh.vertices[c] - mesh.vertices[a];
            const Vec3 h = cross(along, e2), s = from - mesh.vertices[a], q = cross(s, e1);
            const double f = dot(e1, h), u = dot(s, h) / f, v = dot(along, q) / f, t = dot(e2, q) / f;
            count += f != 0 && u >= 0 && v >= 0 && u + v <= 1 && t >= 0 && t < 1;
        }
    }
    return count;
}

} // namespace

class tst_Mannequin : public QObject {
    Q_OBJECT
private slots:
    void isClosedAndManifold_data() { bodies(); }
    void isClosedAndManifold();
    void everyVertexHasOneFan_data() { bodies(); }
    void everyVertexHasOneFan();
    void isItsOwnMirrorImage_data() { bodies(); }
    void isItsOwnMirrorImage();
    void itsTrianglesAreWellShaped_data() { bodies(); }
    void itsTrianglesAreWellShaped();
    void girthsAreAsAsked_data() { bodies(); }
    void girthsAreAsAsked();
    void lengthsAreAsAsked_data() { bodies(); }
    void lengthsAreAsAsked();
    void landmarksLieOnTheSkin_data() { bodies(); }
    void landmarksLieOnTheSkin();
    void hipIsTheFullestLevelBelowTheWaist_data() { bodies(); }
    void hipIsTheFullestLevelBelowTheWaist();
    void axesLeaveTheBodyAtTheEndOfTheirLimb_data() { bodies(); }
    void axesLeaveTheBodyAtTheEndOfTheirLimb();
    void armsAreClearOfTheTorso_data() { bodies(); }
    void armsAreClearOfTheTorso();
    void isTheSameEachTime();
    void shorterEdgesGiveTheSameBody();
    void impossibleMeasurementsAreNamed_data();
    void impossibleMeasurementsAreNamed();

private:
    static void bodies() {
        QTest::addColumn<int>("sample");
        int n = 0;
        for (const NamedMeasurements& body : sampleMeasurements()) QTest::newRow(body.name.c_str()) << n++;
    }
    static const Mannequin& current() {
        QFETCH(int, sample);
        return mannequinOf(static_cast<std::size_t>(sample));
    }
};

void tst_Mannequin::isClosedAndManifold() {
    const auto& mesh = current().body.mesh;
    QVERIFY(geometry::isClosedManifold(mesh));
    QVERIFY(geometry::signedVolume(mesh) > 0.03); // an adult weighs more than 30 kg
    const auto edges = mesh.triangles.size() * 3 / 2;
    QCOMPARE(mesh.vertices.size() + mesh.triangles.size() - edges, std::size_t{2}); // Euler: one sphere
}

void tst_Mannequin::everyVertexHasOneFan() {
    const auto& mesh = current().body.mesh;
    std::vector<std::map<int, int>> next(mesh.vertices.size()); // round each vertex: neighbour → neighbour
    for (const auto& t : mesh.triangles)
        for (std::size_t i = 0; i < 3; ++i) next[static_cast<std::size_t>(t[i])][t[(i + 1) % 3]] = t[(i + 2) % 3];
    for (const auto& fan : next) {
        int at = fan.begin()->first;
        std::size_t steps = 0;
        do {
            at = fan.at(at), ++steps;
        } while (at != fan.begin()->first && steps <= fan.size());
        QCOMPARE(steps, fan.size());
    }
}

void tst_Mannequin::isItsOwnMirrorImage() {
    std::map<std::array<double, 3>, int> places;
    const auto& vertices = current().body.mesh.vertices;
    for (const Vec3& p : vertices) ++places[{p.x, p.y, p.z}];
    for (const Vec3& p : vertices) QVERIFY(places.contains({p.x == 0 ? 0 : -p.x, p.y, p.z})); // to the last bit
}

void tst_Mannequin::itsTrianglesAreWellShaped() {
    const auto& mesh = current().body.mesh;
    double sharpest = std::numbers::pi, edges = 0;
    for (const auto& t : mesh.triangles)
        for (std::size_t i = 0; i < 3; ++i) {
            const Vec3 a = mesh.vertices[t[i]], b = mesh.vertices[t[(i + 1) % 3]], c = mesh.vertices[t[(i + 2) % 3]];
            sharpest = std::min(sharpest, std::atan2(length(cross(b - a, c - a)), dot(b - a, c - a)));
            edges += distance(a, b);
        }
    QVERIFY2(sharpest > 5 * std::numbers::pi / 180, qPrintable(QString::number(sharpest * 180 / std::numbers::pi)));
    const double mean = edges / (3.0 * static_cast<double>(mesh.triangles.size()));
    QVERIFY(mean > 0.009 && mean < 0.012); // what the cloth of 10 mm wants to lie on
    QVERIFY(mesh.triangles.size() > 20000 && mesh.triangles.size() < 45000);
}

void tst_Mannequin::girthsAreAsAsked() {
    const Mannequin& mannequin = current();
    QCOMPARE(mannequin.girths.size(), std::size_t{8});
    for (const Girth& girth : mannequin.girths) {
        const QString told = QStringLiteral("%1: asked %2, hull %3, section %4 mm")
                                 .arg(QString::fromStdString(girth.name))
                                 .arg(girth.asked * 1e3)
                                 .arg(girth.hull * 1e3)
                                 .arg(girth.section * 1e3);
        qInfo("%s", qPrintable(told));
        QVERIFY2(std::abs(girth.hull - girth.asked) <= promise, qPrintable(told));
        QVERIFY2(girth.section >= girth.hull - 1e-9, qPrintable(told)); // a hull is never longer
    }
    // The tape again, laid by this test round the waist and the bust.
    const double waist = mannequin.body.landmarks.waist.y;
    const auto loop = sectionRound(mannequin.body.mesh, {{0, waist, 0}, {0, 1, 0}});
    QVERIFY(loop && std::abs(tapeGirth(*loop) - mannequin.measurements.waist) <= promise);
    const auto bust = sectionRound(mannequin.body.mesh, {{0, mannequin.body.landmarks.bustLeft.y, 0}, {0, 1, 0}});
    QVERIFY(bust && std::abs(tapeGirth(*bust) - mannequin.measurements.bust) <= promise);
}

void tst_Mannequin::lengthsAreAsAsked() {
    const Measurements& m = current().measurements;
    const Landmarks& l = current().body.landmarks;
    const auto isNear = [](double a, double b) { return std::abs(a - b) <= promise; };
    const auto box = geometry::boundsOf(current().body.mesh.vertices);
    QCOMPARE(box.low.y, 0.0);
    QVERIFY(isNear(box.high.y, m.height));
    QVERIFY(isNear(distance(l.acromionLeft, l.acromionRight), m.shoulderWidth));
    QVERIFY(isNear(l.nape.y - l.waist.y, m.napeToWaist));
    QVERIFY(isNear(distance(l.neckLeft, l.bustLeft), m.bustHeight));
    QVERIFY(isNear(distance(l.acromionLeft, l.wristLeft), m.arm));
    QVERIFY(isNear(l.crotch.y, m.insideLeg));
    const double slope = std::atan2(l.neckLeft.y - l.acromionLeft.y, l.acromionLeft.x - l.neckLeft.x);
    const double shoulder = distance(l.neckLeft, l.acromionLeft);
    QVERIFY(std::abs(slope - m.shoulderSlope) * shoulder <= promise);
}

void tst_Mannequin::landmarksLieOnTheSkin() {
    const Landmarks& l = current().body.landmarks;
    const double flatness =
        0.0015; // how far 10 mm triangles lie from a curve of 10 mm radius, and the floor's shift [m]
    for (const Vec3& p : {l.nape, l.frontNeck, l.neckLeft, l.neckRight, l.acromionLeft, l.acromionRight, l.bustLeft,
                          l.bustRight, l.crotch}) {
        const double off = distanceToMesh(p, current().body.mesh);
        QVERIFY2(off < flatness,
                 qPrintable(QStringLiteral("%1 mm at (%2, %3, %4)").arg(off * 1e3).arg(p.x).arg(p.y).arg(p.z)));
    }
    QVERIFY(l.neckRight == (Vec3{-l.neckLeft.x, l.neckLeft.y, l.neckLeft.z}));
    QVERIFY(l.nape.z < l.neckLeft.z && l.neckLeft.z < l.frontNeck.z && l.frontNeck.y < l.nape.y);
}

void tst_Mannequin::hipIsTheFullestLevelBelowTheWaist() {
    const Body& body = current().body;
    const double hip = current().measurements.hip;
    for (double y = body.landmarks.crotch.y + 0.03; y < body.landmarks.waist.y; y += 0.01)
        if (const auto loop = sectionRound(body.mesh, {{0, y, body.landmarks.hip.z}, {0, 1, 0}}))
            QVERIFY2(tapeGirth(*loop) < hip + promise,
                     qPrintable(QStringLiteral("%1 at %2").arg(tapeGirth(*loop)).arg(y)));
}

void tst_Mannequin::axesLeaveTheBodyAtTheEndOfTheirLimb() {
    const Body& body = current().body;
    QCOMPARE(body.axes.size(), std::size_t{6});
    for (const LimbAxis& axis : body.axes)
        QCOMPARE(crossings(axis.points, body.mesh), 1); // from inside, out at the end
    const auto endOf = [&](Limb limb) { return std::ranges::find(body.axes, limb, &LimbAxis::limb)->points.back(); };
    QVERIFY(endOf(Limb::leftArm).x > 0.5 && endOf(Limb::rightArm).x < -0.5);
    QVERIFY(endOf(Limb::leftLeg).x > 0 && endOf(Limb::leftLeg).y < 0);
    QVERIFY(endOf(Limb::neck).y > current().measurements.height);
    QVERIFY(endOf(Limb::torso).y < body.landmarks.crotch.y);
}

void tst_Mannequin::armsAreClearOfTheTorso() {
    const Body& body = current().body; // 20 cm down from the acromion the arm is a section of its own
    const auto sections = sectionsOf(body.mesh, {{0, body.landmarks.acromionLeft.y - 0.20, 0}, {0, 1, 0}});
    QCOMPARE(sections.size(), std::size_t{3});
}

void tst_Mannequin::isTheSameEachTime() {
    const auto again = makeMannequin(sampleMeasurements().front().measurements);
    QVERIFY(again);
    QVERIFY(again->body == mannequinOf(0).body);
}

void tst_Mannequin::shorterEdgesGiveTheSameBody() {
    const auto fine = makeMannequin({}, 0.0066);
    QVERIFY(fine);
    QVERIFY(fine->body.mesh.triangles.size() >= 100000);
    QVERIFY(geometry::isClosedManifold(fine->body.mesh));
    for (const Girth& girth : fine->girths) QVERIFY(std::abs(girth.hull - girth.asked) < promise);
    for (const double edge : {0.001, 0.1, std::nan("")}) {
        const auto refused = makeMannequin({}, edge);
        QVERIFY(!refused);
        QCOMPARE(refused.error().place.path, "edge");
    }
}

void tst_Mannequin::impossibleMeasurementsAreNamed_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<Measurements>("measurements");
    QTest::newRow("a wasp's waist") << "waist" << Measurements{.waist = 0.10};
    QTest::newRow("no number") << "bust" << Measurements{.bust = std::nan("")};
    QTest::newRow("under-bust wider than bust") << "underBust" << Measurements{.underBust = 0.95};
    QTest::newRow("breasts down to the waist")
        << "underBust" << Measurements{.bust = 1.40, .underBust = 0.56, .waist = 0.48};
    QTest::newRow("legs up to the waist") << "insideLeg" << Measurements{.insideLeg = 1.02};
    QTest::newRow("thigh as wide as the hip") << "thigh" << Measurements{.thigh = 0.90};
}

void tst_Mannequin::impossibleMeasurementsAreNamed() {
    QFETCH(QString, name);
    QFETCH(Measurements, measurements);
    const auto refused = makeMannequin(measurements);
    QVERIFY(!refused);
    QCOMPARE(QString::fromStdString(refused.error().place.path), name);
}

TOILE_TEST(tst_Mannequin)
#include "tst_Mannequin.moc"
