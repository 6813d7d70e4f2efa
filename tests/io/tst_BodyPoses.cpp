// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/body/ArmLift.h"
#include "core/body/Mannequin.h"
#include "core/io/BodyImport.h"
#include "core/io/BodyPoses.h"
#include "tests/Suite.h"

#include <QTemporaryDir>
#include <QTest>

#include <fmt/format.h>
#include <fstream>

using namespace toile;

namespace {

/// In centimetres, every triangle with corners of its own: another order than the body's, and another unit.
void writeSoup(const std::string& path, const geometry::TriangleMesh& mesh, const std::vector<Vec3>& vertices) {
    std::ofstream out(path);
    for (const auto& triangle : mesh.triangles)
        for (const int v : triangle)
            out << fmt::format("v {:.6f} {:.6f} {:.6f}\n", 100 * vertices[v].x, 100 * vertices[v].y,
                               100 * vertices[v].z);
    for (std::size_t f = 0; f < mesh.triangles.size(); ++f)
        out << fmt::format("f {} {} {}\n", 3 * f + 1, 3 * f + 2, 3 * f + 3);
}

} // namespace

class tst_BodyPoses : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void posesOfAnyOrderAndUnitAreThoseOfTheBody();
    void whatIsNoMotionOfThisBodyIsRefused();

private:
    body::Body body_;
    geometry::VertexMotion lift_;
};

void tst_BodyPoses::initTestCase() {
    auto mannequin = body::makeMannequin({});
    QVERIFY(mannequin.has_value());
    body_ = std::move(mannequin->body);
    auto lift = body::armLift(body_, 0.02, 0.5);
    QVERIFY(lift.has_value());
    lift_ = std::move(*lift);
    QCOMPARE(lift_.poses.size(), std::size_t(3));
}

void tst_BodyPoses::posesOfAnyOrderAndUnitAreThoseOfTheBody() {
    const QTemporaryDir folder;
    for (std::size_t i = 0; i < lift_.poses.size(); ++i)
        writeSoup(folder.filePath(QString("pose-%1.obj").arg(i == 0 ? 2 : 9 + i)).toStdString(), body_.mesh,
                  lift_.poses[i]); // 2, 10, 11
    std::ofstream(folder.filePath("notes.txt").toStdString()) << "no pose";
    const auto models = io::posesIn(folder.path().toStdString());
    QVERIFY(models.has_value());
    QCOMPARE(models->size(), lift_.poses.size());
    QCOMPARE(models->front().filename(), std::filesystem::path("pose-2.obj"));
    const auto motion = io::readBodyPoses(folder.path().toStdString(), body_, 0.25);
    QVERIFY2(motion.has_value(), motion ? "" : toString(motion.error()).c_str());
    QCOMPARE(motion->step, 0.25);
    QCOMPARE(motion->poses.size(), lift_.poses.size());
    for (std::size_t i = 0; i < lift_.poses.size(); ++i)
        for (std::size_t v = 0; v < body_.mesh.vertices.size(); ++v)
            QVERIFY(geometry::distance(motion->poses[i][v], lift_.poses[i][v]) < 1e-6);
    QVERIFY(geometry::checkedMotion(*motion, body_.mesh, 1e-4).has_value());
}

void tst_BodyPoses::whatIsNoMotionOfThisBodyIsRefused() {
    const auto refusal = [&](const QTemporaryDir& folder) {
        const auto motion = io::readBodyPoses(folder.path().toStdString(), body_, 0.1);
        return motion ? std::string() : toString(motion.error());
    };
    const QTemporaryDir one, other, fewer;
    writeSoup(one.filePath("a.obj").toStdString(), body_.mesh, lift_.poses[0]);
    QVERIFY(refusal(one).find("two poses at least") != std::string::npos);

    writeSoup(other.filePath("a.obj").toStdString(), body_.mesh, lift_.poses[2]);
    writeSoup(other.filePath("b.obj").toStdString(), body_.mesh, lift_.poses[0]);
    const std::string said = refusal(other);
    QVERIFY(said.find("a.obj") != std::string::npos && said.find("as it stands") != std::string::npos);

    writeSoup(fewer.filePath("a.obj").toStdString(), body_.mesh, lift_.poses[0]);
    geometry::TriangleMesh less = body_.mesh;
    less.triangles.pop_back();
    writeSoup(fewer.filePath("b.obj").toStdString(), less, lift_.poses[1]);
    QVERIFY(refusal(fewer).find("b.obj") != std::string::npos);
    QVERIFY(!io::readBodyPoses("no/such/folder", body_, 0.1));
}

TOILE_TEST(tst_BodyPoses)
#include "tst_BodyPoses.moc"
