// SPDX-License-Identifier: GPL-3.0-or-later
#include "WornScenes.h"
#include "core/io/CheckpointFile.h"
#include "core/simulation/Inspect.h"
#include "tests/Suite.h"

#include <QTemporaryDir>

using namespace toile;
using namespace toile::simulation;

namespace {

constexpr double coarse = 0.03, fine = 0.012; ///< spacings; the fine one is helped by coarse levels

Scene shirt(double spacing = coarse) {
    Scene scene = onBlouseWearer(blouseAt(spacing));
    scene.settings.selfContact = spacing == coarse;
    return scene;
}

} // namespace

/// A simulation that is saved and resumed goes on as if nothing had happened.
class tst_Checkpoint : public QObject {
    Q_OBJECT
private slots:
    void whatIsResumedGoesOnToTheSameBits_data();
    void whatIsResumedGoesOnToTheSameBits();
    void whatFallsUnseenGoesOnUnseen();
    void howFarTacksAreIsKept();
    void aCheckpointOfAnotherSceneIsRefused();
    void aCheckpointOfAKnitOfAnotherTensionIsRefused();
    void aBrokenFileIsRefusedWithItsField_data();
    void aBrokenFileIsRefusedWithItsField();

private:
    [[nodiscard]] std::string file() const { return folder_.filePath("garment.checkpoint").toStdString(); }
    QTemporaryDir folder_;
};

void tst_Checkpoint::whatIsResumedGoesOnToTheSameBits_data() {
    QTest::addColumn<QString>("method");
    QTest::addColumn<int>("frames");
    QTest::addColumn<int>("phase");
    QTest::addColumn<double>("spacing");
    QTest::newRow("while seams close") << "xpbd" << 20 << 0 << coarse;
    QTest::newRow("while it is shaken down") << "xpbd" << 70 << 1 << coarse;
    QTest::newRow("by coarse levels") << "xpbd" << 70 << 1 << fine;
    QTest::newRow("draping") << "xpbd" << 180 << 2 << coarse;
    QTest::newRow("draping by TR-BDF2") << "trbdf2" << 180 << 2 << coarse;
}

void tst_Checkpoint::whatIsResumedGoesOnToTheSameBits() {
    QFETCH(QString, method);
    QFETCH(int, frames);
    QFETCH(int, phase);
    QFETCH(double, spacing);
    const auto by = dynamics::methodNamed(method.toStdString());
    auto simulation = Simulation::create(shirt(spacing));
    QVERIFY(simulation);
    run(*simulation, std::min(frames, 175));
    if (method != "xpbd") simulation->drapeWith(by);
    run(*simulation, frames - std::min(frames, 175));
    const Checkpoint point = simulation->checkpoint();
    QCOMPARE(static_cast<int>(point.phase), phase);
    QVERIFY(io::writeCheckpoint(point, file()));
    const auto read = io::readCheckpoint(file());
    QVERIFY2(read, read ? "" : toString(read.error()).c_str());
    QVERIFY(*read == point);

    QCOMPARE(std::ranges::count(simulation->plan().leftOut(), "coarse levels", &LeftOut::stage) == 0, spacing == fine);

    auto resumed = Simulation::resumed(shirt(spacing), {}, *read);
    QVERIFY2(resumed, resumed ? "" : toString(resumed.error()).c_str());
    if (method != "xpbd") resumed->drapeWith(by);
    QCOMPARE(resultHash(*resumed), resultHash(*simulation));
    const int more = phase == 0 ? 60 : method == "xpbd" ? 20 : 5; // the first through the merging of its seams
    run(*simulation, more);
    run(*resumed, more);
    QCOMPARE(resultHash(*resumed), resultHash(*simulation));
    QVERIFY(resumed->state().velocities == simulation->state().velocities);
    QVERIFY(resumed->checkpoint() == simulation->checkpoint());
}

void tst_Checkpoint::whatFallsUnseenGoesOnUnseen() {
    Simulation before = simulationOf(shirt());
    while (before.phase() != Phase::draping) run(before, 1);
    Scene heavier = before.scene(); // on the same body
    heavier.settings.gravity.y *= 1.1;
    auto edited = Simulation::continued(heavier, before, {}, GoesOn::asSewn);
    QVERIFY(edited && edited->fallsUnseen());
    run(*edited, 10);
    const Checkpoint point = edited->checkpoint();
    QVERIFY(!point.sewn.empty() && !point.shown.empty());
    QVERIFY(io::writeCheckpoint(point, file()));
    const auto read = io::readCheckpoint(file());
    QVERIFY(read && *read == point);
    auto resumed = Simulation::resumed(heavier, {}, *read);
    QVERIFY(resumed && resumed->fallsUnseen());
    QVERIFY(resumed->frame().positions == edited->frame().positions);
    run(*edited, 10);
    run(*resumed, 10);
    QVERIFY(resumed->checkpoint() == edited->checkpoint());
    auto again = Simulation::continued(before.scene(), *resumed, {}, GoesOn::asSewn);
    QVERIFY(again && again->fallsUnseen());
    for (std::vector<Vec3> Checkpoint::*nodes : {&Checkpoint::sewn, &Checkpoint::shown}) {
        Checkpoint other = point;
        (other.*nodes).pop_back();
        const auto refused = Simulation::resumed(heavier, {}, other);
        QVERIFY(!refused && toString(refused.error()).find("nodes") != std::string::npos);
    }
}

void tst_Checkpoint::howFarTacksAreIsKept() {
    Checkpoint point{.scene = "abc", .time = 1};
    point.tacks = {{.closed = true, .initialGap = 0.05, .start = 0.25, .startGap = 0.04}, {}};
    QVERIFY(io::writeCheckpoint(point, file()));
    const auto read = io::readCheckpoint(file());
    QVERIFY(read && *read == point);
}

void tst_Checkpoint::aCheckpointOfAnotherSceneIsRefused() {
    auto simulation = Simulation::create(shirt());
    QVERIFY(simulation);
    const Checkpoint point = simulation->checkpoint();
    const auto whyNot = [&](const Scene& scene, const MeshOverrides& overrides = {}) {
        const auto resumed = Simulation::resumed(scene, overrides, point);
        return resumed ? std::string() : toString(resumed.error());
    };
    QCOMPARE(whyNot(shirt()), std::string());
    QVERIFY(whyNot(shirt(), {.spacing = 0.04}).find("particles") != std::string::npos);
    Scene heavier = shirt();
    heavier.settings.gravity.y *= 1.001;
    QVERIFY(whyNot(heavier).find("different") != std::string::npos);
    Scene stiffer = shirt();
    material::Fabric fabric = *stiffer.pattern.fabrics[0];
    fabric.warpBending *= 1.01;
    stiffer.pattern.fabrics[0] = fabric;
    QVERIFY(whyNot(stiffer).find("different") != std::string::npos);
    Scene later = shirt();
    later.pattern.seams[0].order += 1;
    QVERIFY(whyNot(later).find("different") != std::string::npos);
    Scene folded = shirt();
    folded.pattern.seams[0].foldAngle = 1;
    QVERIFY(whyNot(folded).find("different") != std::string::npos);
    Scene firmer = shirt();
    firmer.pattern.seams[0].stiffnessFactor = 5;
    QVERIFY(whyNot(firmer).find("different") != std::string::npos);
    Scene gathered = shirt();
    gathered.pattern.seams[0].sections = {{.ease = 0.001}};
    QVERIFY(whyNot(gathered).find("different") != std::string::npos);
    Scene above = shirt();
    pattern::Piece piece = *above.pattern.pieces[0];
    piece.layer += 1;
    above.pattern.pieces[0] = piece;
    QVERIFY(whyNot(above).find("different") != std::string::npos);
    Scene fewer = shirt();
    fewer.pattern.seams.pop_back();
    QVERIFY(whyNot(fewer).find("seams") != std::string::npos);
    Checkpoint elsewhere = point;
    elsewhere.contact.forces.push_back(0);
    const auto resumed = Simulation::resumed(shirt(), {}, elsewhere);
    QVERIFY(!resumed && toString(resumed.error()).find("touches the body") != std::string::npos);
}

void tst_Checkpoint::aCheckpointOfAKnitOfAnotherTensionIsRefused() {
    const auto ofKnit = [](double atTwentyPercent) {
        Scene scene = shirt();
        material::Fabric fabric = *scene.pattern.fabrics[0];
        fabric.kind = material::FabricKind::knit;
        fabric.weftTension = {{0.1, 1}, {0.2, atTwentyPercent}};
        scene.pattern.fabrics[0] = fabric;
        return scene;
    };
    auto simulation = Simulation::create(ofKnit(2));
    QVERIFY(simulation);
    const Checkpoint point = simulation->checkpoint();
    QVERIFY(Simulation::resumed(ofKnit(2), {}, point));
    const auto tighter = Simulation::resumed(ofKnit(2.02), {}, point);
    QVERIFY(!tighter && toString(tighter.error()).find("different") != std::string::npos);
}

void tst_Checkpoint::aBrokenFileIsRefusedWithItsField_data() {
    QTest::addColumn<QByteArray>("from");
    QTest::addColumn<QByteArray>("to");
    QTest::addColumn<QByteArray>("names");
    QTest::newRow("no JSON") << QByteArray("{") << QByteArray("[") << QByteArray("garment.checkpoint");
    QTest::newRow("another format") << QByteArray("toile-checkpoint") << QByteArray("toile") << QByteArray("format");
    QTest::newRow("a newer version") << QByteArray("\"version\": 1") << QByteArray("\"version\": 2")
                                     << QByteArray("version");
    QTest::newRow("no phase") << QByteArray("\"sewing\"") << QByteArray("\"ironing\"") << QByteArray("phase");
    QTest::newRow("no number") << QByteArray("\"positions\": [") << QByteArray("\"positions\": [null,")
                               << QByteArray("positions");
    QTest::newRow("a number too many") << QByteArray("\"velocities\": [") << QByteArray("\"velocities\": [1,")
                                       << QByteArray("velocities");
    QTest::newRow("a time that a step does not change")
        << QByteArray("\"time\": 0,") << QByteArray("\"time\": 1e300,") << QByteArray(": time: ");
    QTest::newRow("a time before the start")
        << QByteArray("\"time\": 0,") << QByteArray("\"time\": -1,") << QByteArray(": time: ");
    QTest::newRow("sewn before the start")
        << QByteArray("\"sewnTime\": 0,") << QByteArray("\"sewnTime\": -1,") << QByteArray(": sewnTime: ");
    QTest::newRow("a gap below nothing") << QByteArray("\"gapAtMerge\": 0,") << QByteArray("\"gapAtMerge\": -1,")
                                         << QByteArray("seams[0].gapAtMerge: ");
    QTest::newRow("a place out of this world")
        << QByteArray("\"positions\": [") << QByteArray("\"positions\": [1e20,") << QByteArray("positions[0]");
    QTest::newRow("a force that pulls") << QByteArray("\"forces\": [") << QByteArray("\"forces\": [-1,")
                                        << QByteArray("contact.forces[0]");
    QTest::newRow("a seam that is never to close")
        << QByteArray("\"start\": 0,") << QByteArray("\"start\": 1e300,") << QByteArray("seams[0].start: ");
}

void tst_Checkpoint::aBrokenFileIsRefusedWithItsField() {
    QFETCH(QByteArray, from);
    QFETCH(QByteArray, to);
    QFETCH(QByteArray, names);
    auto simulation = Simulation::create(shirt());
    QVERIFY(simulation && io::writeCheckpoint(simulation->checkpoint(), file()));
    QFile text(QString::fromStdString(file()));
    QVERIFY(text.open(QIODevice::ReadWrite));
    QByteArray content = text.readAll();
    const qsizetype at = content.indexOf(from);
    QVERIFY(at >= 0);
    content.replace(at, from.size(), to);
    QVERIFY(text.resize(0) && text.seek(0) && text.write(content) == content.size());
    text.close();
    const auto read = io::readCheckpoint(file());
    QVERIFY(!read);
    QVERIFY2(toString(read.error()).find(names.toStdString()) != std::string::npos, toString(read.error()).c_str());
}

TOILE_TEST(tst_Checkpoint, QCoreApplication)
#include "tst_Checkpoint.moc"
