// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/AtomicFile.h"
#include "core/body/Mannequin.h"
#include "core/io/BodyImport.h"
#include "tests/Suite.h"
#include "tests/collision/Shapes.h"

#include <QTemporaryDir>
#include <QTest>

#include <cstdio>
#include <fmt/format.h>

using namespace toile;
namespace fs = std::filesystem;

class tst_BodyRead : public QObject {
    Q_OBJECT
private slots:
    void aMannequinKeepsItsLandmarksInAFile();
    void aTableComesWithoutLandmarks();
    void whatIsNoBodyIsRefusedByItsFile();
    void foreignBodiesGetTheirLandmarks();

private:
    QTemporaryDir folder;
    [[nodiscard]] fs::path at(const char* name) const { return fs::path(folder.path().toStdString()) / name; }

    /// A box as an OBJ file.
    [[nodiscard]] fs::path putBox(const char* name, const Vec3& low, const Vec3& high) const {
        const auto mesh = shapes::box(low, high);
        std::string text;
        for (const Vec3& v : mesh.vertices) text += fmt::format("v {} {} {}\n", v.x, v.y, v.z);
        for (const auto& [a, b, c] : mesh.triangles) text += fmt::format("f {} {} {}\n", a + 1, b + 1, c + 1);
        if (!writeFileAtomically(at(name), text)) qFatal("a test writes its file");
        return at(name);
    }
};

void tst_BodyRead::aMannequinKeepsItsLandmarksInAFile() {
    const auto mannequin = body::makeMannequin({});
    QVERIFY2(mannequin, mannequin ? "" : mannequin.error().text.c_str());
    QVERIFY(io::writeBody(at("mannequin.glb"), mannequin->body));
    std::vector<Warning> warnings;
    const auto again = io::readBody(at("mannequin.glb"), {}, &warnings);
    QVERIFY2(again, again ? "" : again.error().text.c_str());
    QVERIFY(warnings.empty());
    QCOMPARE(again->name, mannequin->body.name);
    QVERIFY(again->landmarks == mannequin->body.landmarks); // bit for bit
    QVERIFY(again->axes == mannequin->body.axes);
    QVERIFY(again->mesh.triangles == mannequin->body.mesh.triangles);
    QVERIFY(geometry::isClosedManifold(again->mesh));
    for (std::size_t i = 0; i < again->mesh.vertices.size(); ++i)
        QVERIFY(distance(again->mesh.vertices[i], mannequin->body.mesh.vertices[i]) < 2e-7); // floats
}

void tst_BodyRead::aTableComesWithoutLandmarks() {
    io::BodyImportSettings settings;
    settings.isHuman = false;
    const auto table = io::readBody(putBox("table.obj", {-0.4, 0.7, -0.4}, {0.4, 0.75, 0.4}), settings);
    QVERIFY(table);
    QCOMPARE(table->name, std::string("table"));
    QVERIFY(table->axes.empty());
    QCOMPARE(table->mesh.triangles.size(), std::size_t(12));
}

void tst_BodyRead::whatIsNoBodyIsRefusedByItsFile() {
    const auto path = putBox("wardrobe.obj", {-0.5, 0, -0.3}, {0.5, 1.8, 0.3});
    const auto body = io::readBody(path);
    QVERIFY(!body);
    QCOMPARE(body.error().place.file, path.string());
}

void tst_BodyRead::foreignBodiesGetTheirLandmarks() {
    const char* data = std::getenv("TOILE_TEST_DATA");
    if (!data || !*data) {
        std::puts("NOT RUN: needs TOILE_TEST_DATA (a folder with bodies/*.obj and *.glb)");
        QSKIP("NOT RUN: needs TOILE_TEST_DATA");
    }
    for (const char* name : {"mh_female_bust98.glb", "mh_female_bust98.obj", "mh_male_adult.glb"}) {
        const auto body = io::readBody(fs::path(data) / "bodies" / name);
        QVERIFY2(body, body ? "" : toString(body.error()).c_str());
        QCOMPARE(body->axes.size(), std::size_t(6));
        const body::Landmarks& l = body->landmarks;
        QVERIFY(l.nape.y > l.bustLeft.y && l.bustLeft.y > l.waist.y && l.waist.y > l.hip.y && l.hip.y > l.crotch.y);
        QVERIFY(l.acromionLeft.x > 0 && l.acromionRight.x < 0);
    }
}

TOILE_TEST(tst_BodyRead)
#include "tst_BodyRead.moc"
