// SPDX-License-Identifier: GPL-3.0-or-later
#include "WorkbenchFixture.h"
#include "core/document/DocumentEdits.h"
#include "core/pattern/PatternFabrics.h"
#include "tests/Suite.h"
#include "ui/panels/PropertySheet.h"

#include <QSemaphore>
#include <QSignalSpy>
#include <QTest>

#include <future>

using namespace toile;
using namespace toile::ui;

class tst_Workbench : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void anEditMakesANewScene();
    void movingOnTheTableMakesNoNewScene();
    void olderFramesAreDropped();
    void theEndOfTheFinishIsToldOnce();
    void whatIsWrongAfterTheFinishIsToldAsAProblem();
    void theGarmentStaysInViewWhileItCannotBeBuilt();
    void framesAreAskedForOnlyWhileSomethingHappens();
    void anotherDocumentBeginsAnew();
    void aSimulationIsResumedWhenItsBodyIsThere();
    void meshesOfTheNewestPatternArrive();
    void anEditNeverWaitsForAMesh();
    void undoBringsTheValueBack();
    void selectionForgetsWhatIsDeleted();
    void everyNumberOfASheetSetsWhatItShows();
    void theSheetOfAPieceProposesItsSpacing();
    void theSheetOfAPieceFreezesAndStrengthensIt();
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
    QVERIFY(!told[0][1].toBool());
}

void tst_Workbench::whatIsWrongAfterTheFinishIsToldAsAProblem() {
    Fixture fixture;
    Workbench workbench(fixture.parts());
    workbench.startFrom(twoRectangles(), {}, false);
    QSignalSpy told(&workbench, &Workbench::messageChanged);
    fixture.log.frame = frameOf(workbench.generation());
    fixture.log.frame->finish = simulation::Finish::found;
    fixture.log.frame->warnings = {{"seam \"side\"", "The seam is not closed; its gap is 12.0 mm."},
                                   {"layers", "4 nodes lie behind a piece of a lower layer."}};
    workbench.pollFrame();
    QCOMPARE(told.size(), 1);
    const QStringList lines = told[0][0].toString().split(QLatin1Char('\n'));
    QCOMPARE(lines.size(), 3);
    QCOMPARE(lines[0], QStringLiteral("seam \"side\": The seam is not closed; its gap is 12.0 mm."));
    QVERIFY(told[0][1].toBool());
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

void tst_Workbench::theSheetOfAPieceFreezesAndStrengthensIt() {
    Fixture fixture;
    const Workbench bench(fixture.parts());
    const document::Document drawn = withRectangle(bench.document(), "Front", {0, 0}, 0.2, 0.3);
    const auto switched = [&](const document::Document& document, const char* name, bool on) {
        const PropertySheet sheet =
            sheetOf({document, flattened(document.pattern), {document.pattern.pieces[0]->id}}, {});
        const auto row = std::ranges::find(sheet.rows, QString::fromLatin1(name), &PropertyRow::name);
        return *std::get<FlagRow>(row->content).set(document, on);
    };
    const document::Document frozen = switched(drawn, "frozen", true);
    QVERIFY(frozen.pattern.pieces[0]->frozen && !frozen.pattern.pieces[0]->strengthened);
    QVERIFY(switched(frozen, "frozen", false) == drawn);
    const document::Document strengthened = switched(drawn, "strengthened", true);
    QVERIFY(strengthened.pattern.pieces[0]->strengthened);
    QVERIFY(switched(strengthened, "strengthened", false) == drawn);
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

TOILE_TEST(tst_Workbench, QCoreApplication)
#include "tst_Workbench.moc"
