// SPDX-License-Identifier: GPL-3.0-or-later
#include "UiFixtures.h"
#include "core/body/Mannequin.h"
#include "core/document/DocumentEdits.h"
#include "core/io/ToileFile.h"
#include "core/pattern/PatternFabrics.h"
#include "ui/panels/PropertySheet.h"
#include "ui/workbench/Workbench.h"

#include <QDir>
#include <QSemaphore>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include <future>

using namespace toile;
using namespace toile::ui;

namespace {

/// Remembers what it was told; frames are made by the test.
struct FakeSimulation : Simulation {
    struct Log {
        std::vector<std::uint64_t> generations;
        std::optional<simulation::Frame> frame;
        bool playing = false, busy = false;
        bool finishes = false;
        int resets = 0;
        std::vector<simulation::Grip> grips;
        std::optional<simulation::Checkpoint> resumed;
        std::shared_ptr<const geometry::VertexMotion> motion;
    };
    explicit FakeSimulation(Log& l) : log(l) {}
    void setScene(simulation::Scene, std::uint64_t generation) override { log.generations.push_back(generation); }
    void play() override { log.playing = true; }
    void pause() override { log.playing = false; }
    void step() override {}
    void reset() override { ++log.resets; }
    void finishAtRest(bool wanted) override { log.finishes = wanted; }
    void hold(std::vector<simulation::Grip> grips) override { log.grips = std::move(grips); }
    void moveBody(std::shared_ptr<const geometry::VertexMotion> motion) override { log.motion = std::move(motion); }
    void askForCheckpoint() override {}
    std::optional<Result<simulation::Checkpoint>> takeCheckpoint() override { return {}; }
    void resume(simulation::Checkpoint checkpoint) override { log.resumed = std::move(checkpoint); }
    bool isPlaying() const override { return log.playing; }
    bool isBusy() const override { return log.busy; }
    std::optional<simulation::Frame> takeFrame() override { return std::exchange(log.frame, std::nullopt); }
    Log& log;
};

struct Fixture {
    FakeSimulation::Log log;
    std::atomic<int> meshed{0};
    WorkbenchParts parts() {
        WorkbenchParts result;
        result.read = io::readDocument;
        result.write = [](const std::string& file, const document::Document& d) { return io::writeToile(d, file); };
        result.mesh = [this, mesh = std::make_shared<meshing::GarmentMesh>()](
                          const pattern::Pattern& pattern) -> Result<const meshing::GarmentMesh*> {
            ++meshed;
            mesh->pieces.resize(pattern.pieces.size());
            return mesh.get();
        };
        result.simulation = std::make_unique<FakeSimulation>(log);
        result.recoveryDelay = std::chrono::milliseconds(1);
        return result;
    }
};

simulation::Frame frameOf(std::uint64_t generation) {
    simulation::Frame frame;
    frame.generation = generation;
    frame.positions = {{0, 0, 0}};
    return frame;
}

} // namespace

class tst_Workbench : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void anEditMakesANewScene();
    void movingOnTheTableMakesNoNewScene();
    void olderFramesAreDropped();
    void armsAreLiftedAndLetDownAgain();
    void theEndOfTheFinishIsToldOnce();
    void theGarmentStaysInViewWhileItCannotBeBuilt();
    void framesAreAskedForOnlyWhileSomethingHappens();
    void anotherDocumentBeginsAnew();
    void aSimulationIsResumedWhenItsBodyIsThere();
    void meshesOfTheNewestPatternArrive();
    void anEditNeverWaitsForAMesh();
    void undoBringsTheValueBack();
    void savingAndOpeningGivesTheSameDocument();
    void modifiedMarkFollowsSaving();
    void theAvatarIsFoundAfterSavingElsewhereAndUndo();
    void theAvatarIsReadAnewWhenItIsImportedOrOpenedAgain();
    void unsavedWorkIsRecovered();
    void theOnlyRecordIsKeptWhenItCannotBeTakenOver();
    void whoNeverPausesIsRecorded();
    void savedWorkLeavesNothingToRecover();
    void undoneWorkLeavesNothingToRecover();
    void selectionForgetsWhatIsDeleted();
    void everyNumberOfASheetSetsWhatItShows();
    void theSheetOfAPieceProposesItsSpacing();
    void aMeshThatComesOutTakesItsComplaintBack();
    void aGarmentThatGoesOnTakesItsComplaintBack();
};

void tst_Workbench::anEditMakesANewScene() {
    Fixture fixture;
    Workbench bench(fixture.parts());
    const std::size_t before = fixture.log.generations.size();
    bench.apply({QStringLiteral("Draw"), twoRectangles()});
    QCOMPARE(fixture.log.generations.size(), before + 1);
    QVERIFY(fixture.log.generations.back() == bench.generation());
}

void tst_Workbench::movingOnTheTableMakesNoNewScene() {
    Fixture fixture;
    Workbench bench(fixture.parts());
    bench.apply({QStringLiteral("Draw"), twoRectangles()});
    const std::size_t before = fixture.log.generations.size();
    const auto& piece = bench.document().pattern.pieces[0]->id;
    bench.apply({QStringLiteral("Move"),
                 *document::edited(bench.document(), [&](const pattern::Pattern& p, pattern::IdSource&) {
                     return movePiece(p, piece, {5, 5});
                 })});
    QCOMPARE(fixture.log.generations.size(), before);
    QCOMPARE(bench.flat().pieces[0].piece.tablePosition.x, 5.0);
}

void tst_Workbench::olderFramesAreDropped() {
    Fixture fixture;
    Workbench bench(fixture.parts());
    bench.apply({QStringLiteral("Draw"), twoRectangles()});
    fixture.log.frame = frameOf(bench.generation() - 1);
    bench.pollFrame();
    QVERIFY(!bench.frame());
    fixture.log.frame = frameOf(bench.generation());
    bench.pollFrame();
    QVERIFY(bench.frame());
}

void tst_Workbench::armsAreLiftedAndLetDownAgain() {
    Fixture fixture;
    Workbench bench(fixture.parts());
    QSignalSpy told(&bench, &Workbench::messageChanged);
    bench.liftArms();
    QCOMPARE(told.size(), 1); // there is nothing yet
    QVERIFY(!fixture.log.motion);

    auto mannequin = body::makeMannequin({});
    QVERIFY(mannequin.has_value());
    Fixture dressed;
    auto parts = dressed.parts();
    parts.readBody = [&](const std::string&) -> Result<body::Body> { return mannequin->body; };
    Workbench workbench(std::move(parts));
    QSignalSpy read(&workbench, &Workbench::bodyChanged);
    workbench.startFrom(document::withAvatar(twoRectangles(), "body.glb"), {}, false);
    QTRY_VERIFY(workbench.body().has_value());
    dressed.log.frame = frameOf(workbench.generation());
    workbench.pollFrame();
    workbench.liftArms();
    QVERIFY(dressed.log.motion);
    const auto up = dressed.log.motion;
    QVERIFY(up->poses.front() == mannequin->body.mesh.vertices);
    QVERIFY(std::ranges::max(up->poses.back(), {}, &Vec3::x).y > mannequin->body.landmarks.wristLeft.y + 0.3);

    dressed.log.frame = frameOf(workbench.generation());
    dressed.log.frame->body = Shared<body::Body>(mannequin->body);
    workbench.pollFrame();
    QVERIFY(workbench.bodyHasMoved());
    workbench.liftArms();
    QVERIFY(dressed.log.motion->poses.front() == up->poses.back());
    QVERIFY(dressed.log.motion->poses.back() == up->poses.front());
}

void tst_Workbench::theEndOfTheFinishIsToldOnce() {
    Fixture fixture;
    Workbench workbench(fixture.parts());
    workbench.finishAtRest(true);
    QVERIFY(fixture.log.finishes);
    workbench.startFrom(twoRectangles(), {}, false);
    QSignalSpy told(&workbench, &Workbench::messageChanged);
    using simulation::Finish;
    for (const Finish finish : {Finish::none, Finish::underWay, Finish::underWay, Finish::found, Finish::found}) {
        fixture.log.frame = frameOf(workbench.generation());
        fixture.log.frame->finish = finish;
        fixture.log.frame->finishMove = 0.0062;
        workbench.pollFrame();
    }
    QCOMPARE(told.size(), 1);
    QVERIFY(told[0][0].toString().contains(QStringLiteral("6.2 mm")));
}

void tst_Workbench::theGarmentStaysInViewWhileItCannotBeBuilt() {
    Fixture fixture;
    Workbench bench(fixture.parts());
    bench.apply({QStringLiteral("Draw"), twoRectangles()});
    fixture.log.frame = frameOf(bench.generation());
    bench.pollFrame();
    simulation::Frame none;
    none.generation = bench.generation();
    none.message = "a seam is too long";
    fixture.log.frame = none;
    bench.pollFrame();
    QVERIFY(bench.frame() && !bench.frame()->positions.empty());
    none.message.clear(); // nothing to be built: the last piece was deleted
    fixture.log.frame = none;
    bench.pollFrame();
    QVERIFY(!bench.frame());
}

void tst_Workbench::framesAreAskedForOnlyWhileSomethingHappens() {
    Fixture fixture;
    Workbench bench(fixture.parts());
    fixture.log.busy = true;
    bench.apply({QStringLiteral("Draw"), twoRectangles()});
    QVERIFY(bench.isFollowing());
    bench.pollFrame();
    QVERIFY(bench.isFollowing());
    fixture.log.busy = false;
    fixture.log.frame = frameOf(bench.generation());
    bench.pollFrame();
    QVERIFY(bench.frame().has_value()); // the last frame is still taken
    QVERIFY(!bench.isFollowing());
    fixture.log.busy = true;
    bench.play();
    QVERIFY(bench.isFollowing());
}

void tst_Workbench::anotherDocumentBeginsAnew() {
    Fixture fixture;
    Workbench bench(fixture.parts());
    bench.play();
    const int resets = fixture.log.resets;
    bench.startFrom(twoRectangles(), {}, false);
    QVERIFY(!bench.isPlaying());
    QCOMPARE(fixture.log.resets, resets + 1);
}

void tst_Workbench::aSimulationIsResumedWhenItsBodyIsThere() {
    Fixture fixture;
    std::promise<void> read;
    WorkbenchParts parts = fixture.parts();
    parts.readBody = [done = read.get_future().share()](const std::string&) -> Result<body::Body> {
        done.wait();
        return body::Body{};
    };
    parts.readCheckpoint = [](const std::string&) { return Result<simulation::Checkpoint>({.steps = 7}); };
    Workbench bench(std::move(parts));
    bench.importAvatar(QStringLiteral("somebody.glb"));
    QVERIFY(bench.resumeFrom({}));
    QVERIFY(!fixture.log.resumed); // it would be taken for one of the scene without the body
    const std::size_t scenes = fixture.log.generations.size();
    read.set_value();
    QTRY_VERIFY(fixture.log.resumed);
    QCOMPARE(fixture.log.resumed->steps, 7);
    QCOMPARE(fixture.log.generations.size(), scenes + 1);
}

void tst_Workbench::meshesOfTheNewestPatternArrive() {
    Fixture fixture;
    Workbench bench(fixture.parts());
    QSignalSpy changed(&bench, &Workbench::meshChanged);
    document::Document document = twoRectangles();
    for (int i = 0; i < 20; ++i)
        bench.apply({QStringLiteral("Draw"), document = withRectangle(document, "More", {0, double(i)}, 0.1, 0.1)});
    QTRY_COMPARE(bench.mesh().size(), std::size_t(22)); // of all twenty only the newest is shown
    QTest::qWait(20);
    QCOMPARE(bench.mesh().size(), std::size_t(22));
}

/// While a vertex is dragged, patterns that come during a meshing replace one another, and the pointer is never held
/// up.
void tst_Workbench::anEditNeverWaitsForAMesh() {
    Fixture fixture;
    QSemaphore mayGoOn;
    WorkbenchParts parts = fixture.parts();
    parts.mesh = [&mayGoOn, mesh = parts.mesh](const pattern::Pattern& pattern) {
        mayGoOn.acquire();
        return mesh(pattern);
    };
    Workbench bench(std::move(parts));
    document::Document document = twoRectangles();
    for (int i = 0; i < 20; ++i) // comes back although no mesh is ever finished
        bench.apply({QStringLiteral("Draw"), document = withRectangle(document, "More", {0, double(i)}, 0.1, 0.1)});
    QCOMPARE(bench.document().pattern.pieces.size(), std::size_t(22));
    QCOMPARE(bench.mesh().size(), std::size_t(0));
    mayGoOn.release(20);
    QTRY_COMPARE(bench.mesh().size(), std::size_t(22));
    QVERIFY(fixture.meshed <= 3); // the first, perhaps one taken meanwhile, the newest
}

void tst_Workbench::undoBringsTheValueBack() {
    Fixture fixture;
    Workbench bench(fixture.parts());
    const document::Document before = bench.document();
    bench.apply({QStringLiteral("Draw"), twoRectangles()});
    bench.undo();
    QVERIFY(bench.document() == before);
    bench.redo();
    QVERIFY(bench.document() == twoRectangles());
}

void tst_Workbench::savingAndOpeningGivesTheSameDocument() {
    QTemporaryDir folder;
    Fixture fixture;
    Workbench bench(fixture.parts());
    bench.apply({QStringLiteral("Draw"), twoRectangles()});
    const document::Document drawn = *io::asWritten(bench.document());
    QVERIFY(bench.saveAs(folder.filePath(QStringLiteral("two.toile"))));
    bench.startNew();
    QVERIFY(bench.open(folder.filePath(QStringLiteral("two.toile"))));
    QVERIFY(bench.document() == drawn);
}

void tst_Workbench::modifiedMarkFollowsSaving() {
    QTemporaryDir folder;
    Fixture fixture;
    Workbench bench(fixture.parts());
    QVERIFY(!bench.isModified());
    bench.apply({QStringLiteral("Draw"), twoRectangles()});
    QVERIFY(bench.isModified());
    QVERIFY(bench.saveAs(folder.filePath(QStringLiteral("two.toile"))));
    QVERIFY(!bench.isModified());
    bench.undo();
    QVERIFY(bench.isModified());
}

void tst_Workbench::theAvatarIsFoundAfterSavingElsewhereAndUndo() {
    QTemporaryDir folder;
    QVERIFY(QDir(folder.path()).mkdir(QStringLiteral("here")) && QDir(folder.path()).mkdir(QStringLiteral("there")));
    const QString here = folder.filePath(QStringLiteral("here/two.toile"));
    const QString there = folder.filePath(QStringLiteral("there/two.toile"));
    QVERIFY(io::writeToile(document::withAvatar(twoRectangles(), "body.glb"), here.toStdString()));
    Fixture fixture;
    std::vector<std::string> read;
    WorkbenchParts parts = fixture.parts();
    parts.readBody = [&read](const std::string& file) -> Result<body::Body> {
        read.push_back(file);
        return body::Body{};
    };
    Workbench bench(std::move(parts));
    QVERIFY(bench.open(here));
    QTRY_VERIFY(bench.body());
    bench.apply({QStringLiteral("Draw"), withRectangle(bench.document(), "Sleeve", {1, 0}, 0.2, 0.3)});
    QVERIFY(bench.saveAs(there));
    QCOMPARE(io::readToile(there.toStdString())->avatarFile, std::string("../here/body.glb"));
    QCOMPARE(bench.history().undoName(), std::string("Draw")); // saving is no step

    bench.undo();
    QTRY_VERIFY(!bench.isReadingBody());
    QCOMPARE(read, std::vector{folder.filePath(QStringLiteral("here/body.glb")).toStdString()});
    QVERIFY(bench.saveAs(there));
    QCOMPARE(io::readToile(there.toStdString())->avatarFile, std::string("../here/body.glb"));
}

/// Its file may be another one by now, under the same name.
void tst_Workbench::theAvatarIsReadAnewWhenItIsImportedOrOpenedAgain() {
    QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("two.toile"));
    const QString avatar = folder.filePath(QStringLiteral("body.glb"));
    Fixture fixture;
    std::atomic<int> readings = 0;
    WorkbenchParts parts = fixture.parts();
    parts.readBody = [&readings](const std::string&) -> Result<body::Body> {
        body::Body body;
        body.mesh.vertices.resize(static_cast<std::size_t>(++readings));
        if (readings == 1) return fail(ErrorCode::io, "The file is half written.");
        return body;
    };
    Workbench bench(std::move(parts));
    const auto vertices = [&] { return bench.body() ? (*bench.body())->mesh.vertices.size() : 0; };
    bench.importAvatar(avatar);
    QTRY_VERIFY(!bench.isReadingBody());
    QVERIFY(!bench.body());
    bench.apply({QStringLiteral("Draw"), withRectangle(bench.document(), "Front", {0, 0}, 0.2, 0.3)});
    QVERIFY(!bench.isReadingBody()); // not at every edit
    bench.importAvatar(avatar);
    QTRY_COMPARE(vertices(), std::size_t(2));
    bench.importAvatar(avatar);
    QTRY_COMPARE(vertices(), std::size_t(3));
    QVERIFY(bench.scene()->body == bench.body());
    QCOMPARE(bench.history().undoName(), std::string("Draw")); // the document is the same
    QVERIFY(bench.saveAs(file));
    QVERIFY(bench.open(file));
    QTRY_COMPARE(vertices(), std::size_t(4));
}

void tst_Workbench::unsavedWorkIsRecovered() {
    QTemporaryDir folder;
    Fixture fixture;
    WorkbenchParts parts = fixture.parts();
    parts.recoveryFolder = folder.path();
    auto first = std::make_unique<Workbench>(std::move(parts));
    first->apply({QStringLiteral("Draw"), twoRectangles()});
    const Journal probe(folder.path(), {});
    QTRY_COMPARE(QDir(folder.path()).entryList({QStringLiteral("*.recovery.toile")}).size(), 1);
    QVERIFY(probe.leftovers().empty()); // its writer still runs
    first.reset();                      // ends without saving: the lock goes, the record stays
    QCOMPARE(probe.leftovers().size(), std::size_t(1));

    Fixture next;
    parts = next.parts();
    parts.recoveryFolder = folder.path();
    Workbench bench(std::move(parts));
    QVERIFY(bench.recover(probe.leftovers().front()));
    QVERIFY(bench.document() == *io::asWritten(twoRectangles()));
    QVERIFY(bench.isModified());
    QVERIFY(!bench.history().canUndo()); // there is nothing before it that could be saved over the user's file
    QVERIFY(probe.leftovers().empty());
}

void tst_Workbench::theOnlyRecordIsKeptWhenItCannotBeTakenOver() {
    QTemporaryDir folder;
    const Journal::Write write = [](const std::string& file, const document::Document& d) {
        return io::writeToile(d, file);
    };
    QVERIFY(Journal(folder.path(), write).record(twoRectangles(), {}));
    Fixture fixture;
    WorkbenchParts parts = fixture.parts();
    parts.recoveryFolder = folder.path();
    parts.write = [](const std::string&, const document::Document&) -> Result<void> {
        return fail(ErrorCode::io, "The disk is full.");
    };
    Workbench bench(std::move(parts));
    QSignalSpy told(&bench, &Workbench::messageChanged);
    QVERIFY(bench.recover(bench.journal()->leftovers().front()));
    QVERIFY(bench.document() == *io::asWritten(twoRectangles()));
    QCOMPARE(bench.journal()->leftovers().size(), std::size_t(1)); // offered again at the next start
    QCOMPARE(told.size(), 1);
    QVERIFY(told[0][0].toString().contains(QStringLiteral("disk is full")));
}

void tst_Workbench::whoNeverPausesIsRecorded() {
    QTemporaryDir folder;
    Fixture fixture;
    WorkbenchParts parts = fixture.parts();
    parts.recoveryFolder = folder.path();
    parts.recoveryDelay = std::chrono::milliseconds(100);
    Workbench bench(std::move(parts));
    const auto isRecorded = [&] {
        return !QDir(folder.path()).entryList({QStringLiteral("*.recovery.toile")}).isEmpty();
    };
    for (int i = 0; i < 400 && !isRecorded(); ++i) {
        bench.apply({QStringLiteral("Draw"), withRectangle({}, "Front", {0, 0}, 0.2, 0.3 + i * 0.001)});
        QTest::qWait(5);
    }
    QVERIFY(isRecorded());
}

void tst_Workbench::savedWorkLeavesNothingToRecover() {
    QTemporaryDir folder;
    Fixture fixture;
    WorkbenchParts parts = fixture.parts();
    parts.recoveryFolder = folder.path() + QStringLiteral("/recovery");
    Workbench bench(std::move(parts));
    bench.apply({QStringLiteral("Draw"), twoRectangles()});
    const QDir recovery(folder.path() + QStringLiteral("/recovery"));
    QTRY_COMPARE(recovery.entryList({QStringLiteral("*.toile")}).size(), 1);
    QVERIFY(bench.saveAs(folder.filePath(QStringLiteral("two.toile"))));
    QVERIFY(recovery.entryList({QStringLiteral("*.toile")}).isEmpty());
}

void tst_Workbench::undoneWorkLeavesNothingToRecover() {
    QTemporaryDir folder;
    Fixture fixture;
    WorkbenchParts parts = fixture.parts();
    parts.recoveryFolder = folder.path();
    Workbench bench(std::move(parts));
    bench.apply({QStringLiteral("Draw"), twoRectangles()});
    QTRY_COMPARE(QDir(folder.path()).entryList({QStringLiteral("*.toile")}).size(), 1);
    bench.undo();
    QTRY_VERIFY(QDir(folder.path()).entryList({QStringLiteral("*.toile")}).isEmpty());
}

void tst_Workbench::selectionForgetsWhatIsDeleted() {
    Fixture fixture;
    Workbench bench(fixture.parts());
    bench.apply({QStringLiteral("Draw"), twoRectangles()});
    bench.select({bench.document().pattern.pieces[1]->id});
    QCOMPARE(bench.selection().size(), std::size_t(1));
    bench.undo();
    QVERIFY(bench.selection().empty());
}

void tst_Workbench::everyNumberOfASheetSetsWhatItShows() {
    Fixture fixture;
    Workbench bench(fixture.parts());
    bench.apply({QStringLiteral("Draw"), withRectangle(bench.document(), "Front", {0, 0}, 0.2, 0.3)});
    const pattern::PieceId front = bench.document().pattern.pieces[0]->id;
    bench.apply({QStringLiteral("Fuse"),
                 *document::edited(bench.document(), [&](const pattern::Pattern& p, pattern::IdSource&) {
                     return setInterfacing(p, front, pattern::Interfacing{});
                 })});
    simulation::SceneSettings windy = bench.document().scene;
    windy.air = simulation::Air{.wind = {1, 0, 2}};
    bench.apply({QStringLiteral("Air"), *document::withScene(bench.document(), windy)});
    const Selection things{front, bench.document().pattern.fabrics[0]->id, SceneItem{}};
    int numbers = 0;
    for (const Item& thing : things) {
        const auto sheet = [&](const document::Document& d) { return sheetOf({d, flattened(d.pattern), {thing}}, {}); };
        const PropertySheet shownNow = sheet(bench.document());
        for (std::size_t row = 0; row < shownNow.rows.size(); ++row) {
            const auto* number = std::get_if<NumberRow>(&shownNow.rows[row].content);
            if (!number) continue;
            const double wanted = number->quantity == Quantity::count ? number->value + 1
                                  : number->value == 0                ? std::min(0.25, number->high)
                                                                      : number->value * 1.125;
            const DocumentResult after = number->set(bench.document(), wanted);
            QVERIFY2(after, qPrintable(shownNow.rows[row].name));
            const auto& now = std::get<NumberRow>(sheet(*after).rows[row].content);
            QVERIFY2(std::abs(now.value - wanted) <= 1e-12 * std::abs(wanted), qPrintable(shownNow.rows[row].name));
            ++numbers;
        }
    }
    QVERIFY(numbers > 20);
}

void tst_Workbench::theSheetOfAPieceProposesItsSpacing() {
    Fixture fixture;
    const Workbench bench(fixture.parts()); // its empty document has a fabric
    document::Document document = withRectangle(bench.document(), "Front", {0, 0}, 0.2, 0.3);
    const Shared<pattern::Fabric> cloth = document.pattern.fabrics.front();
    document.pattern = *pattern::setPieceFabric(document.pattern, document.pattern.pieces[0]->id, cloth->id);
    const auto& piece = document.pattern.pieces[0];
    const FlatPattern flat = flattened(document.pattern);
    const PropertySheet sheet = sheetOf({document, flat, {piece->id}}, {});
    const auto row = std::ranges::find(sheet.rows, QStringLiteral("proposedSpacing"), &PropertyRow::name);
    QVERIFY(row != sheet.rows.end());
    const auto after = std::get<ActionRow>(row->content).act(document);
    QVERIFY(after);
    QCOMPARE(after->pattern.pieces[0]->spacing, material::proposedSpacing(*cloth));
}

void tst_Workbench::aMeshThatComesOutTakesItsComplaintBack() {
    Fixture fixture;
    WorkbenchParts parts = fixture.parts();
    parts.mesh = [mesh = parts.mesh](const pattern::Pattern& pattern) -> Result<const meshing::GarmentMesh*> {
        if (pattern.pieces.size() == 2) return fail(ErrorCode::invalidInput, "The outline crosses itself.");
        return mesh(pattern);
    };
    Workbench bench(std::move(parts));
    QSignalSpy told(&bench, &Workbench::messageChanged);
    bench.apply({QStringLiteral("Draw"), twoRectangles()});
    QTRY_VERIFY(!told.isEmpty() && told.back()[0].toString().contains(QStringLiteral("crosses itself")));
    bench.undo();
    QTRY_COMPARE(told.back()[0].toString(), QString());

    bench.redo();
    QTRY_VERIFY(told.back()[1].toBool());
    bench.tell(QStringLiteral("Saved")); // what others say stays
    QSignalSpy meshed(&bench, &Workbench::meshChanged);
    bench.undo();
    QTRY_VERIFY(!meshed.isEmpty());
    QCOMPARE(told.back()[0].toString(), QStringLiteral("Saved"));
}

void tst_Workbench::aGarmentThatGoesOnTakesItsComplaintBack() {
    Fixture fixture;
    Workbench bench(fixture.parts());
    bench.apply({QStringLiteral("Draw"), twoRectangles()});
    QSignalSpy told(&bench, &Workbench::messageChanged);
    const auto arrive = [&](const char* message) {
        fixture.log.frame = frameOf(bench.generation());
        fixture.log.frame->message = message;
        bench.pollFrame();
    };
    arrive("a seam is too long");
    QCOMPARE(told.size(), 1);
    arrive("");
    QCOMPARE(told.size(), 2);
    QCOMPARE(told.back()[0].toString(), QString());
    arrive("");
    QCOMPARE(told.size(), 2);

    fixture.log.playing = true; // what does not stop it is to be read while it plays on
    arrive("the avatar cannot move so");
    arrive("");
    QCOMPARE(told.size(), 3);
}

QTEST_GUILESS_MAIN(tst_Workbench)
#include "tst_Workbench.moc"
