// SPDX-License-Identifier: GPL-3.0-or-later
#include "UiFixtures.h"
#include "WindowFixture.h"
#include "core/document/DocumentEdits.h"
#include "core/io/CheckpointFile.h"
#include "core/io/ToileFile.h"
#include "core/simulation/Simulation.h"
#include "tests/Suite.h"

#include <QLabel>
#include <QMessageBox>
#include <QProcess>
#include <QPushButton>
#include <QTemporaryDir>

#include <csignal>

using namespace toile;
using namespace toile::ui;

/// Files through the window: dialogs answered by simulated input.
class tst_FileCommands : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { prepareApplication(); }
    void aDocumentIsSavedUnderANameThatOpenReads_data();
    void aDocumentIsSavedUnderANameThatOpenReads();
    void aFileIsReplacedOnlyAfterAQuestion();
    void theDrapeIsExported_data();
    void theDrapeIsExported();
    void anExportReplacesAFileOnlyAfterAQuestion();
    void aSimulationIsSavedAndResumedInAnotherWindow();
    void aCheckpointThatCannotBeReadIsRefused();
    void withoutADrapeThereIsNothingToExport();
    void aGarmentCodePatternIsImported();
    void whatAnImportAssumesIsTold();
    void aBrokenFileIsRefusedWithASentence();
    void workOfAKilledProgramIsRecovered();
    void lostWorkCanBeDiscarded();
    void discardedWorkStaysRecordedWhileItStaysOpen();
    void whatIsBeingTypedIsSaved();
    void closingAsksAboutWhatIsBeingTyped();
    void actionsWorkOnWhatIsBeingTyped_data();
    void actionsWorkOnWhatIsBeingTyped();
    void aWindowMayEndWhileSomethingIsBeingTyped();
};

namespace {

/// Two panels of 20 × 30 cm, one behind the other, sewn at both sides.
constexpr auto twoPanels = R"({"pattern": {"panels": {
 "front": {"vertices": [[0,0],[20,0],[20,30],[0,30]], "translation": [-10,100,20], "rotation": [0,0,0],
  "edges": [{"endpoints":[0,1]}, {"endpoints":[1,2]}, {"endpoints":[2,3]}, {"endpoints":[3,0]}]},
 "back": {"vertices": [[0,0],[20,0],[20,30],[0,30]], "translation": [10,100,-20], "rotation": [0,180,0],
  "edges": [{"endpoints":[0,1]}, {"endpoints":[1,2]}, {"endpoints":[2,3]}, {"endpoints":[3,0]}]}},
 "stitches": [[{"panel":"front","edge":1}, {"panel":"back","edge":3}], [{"panel":"front","edge":3}, {"panel":"back","edge":1}]]},
"properties": {"curvature_coords": "relative", "units_in_meter": 100}})";

QString written(const QTemporaryDir& folder, const char* name, const char* text) {
    QFile file(folder.filePath(QLatin1String(name)));
    if (!file.open(QIODevice::WriteOnly)) qFatal("cannot write %s", name);
    file.write(text);
    return file.fileName();
}

void drape(Bench& bench) {
    QVERIFY(bench.workbench.openCopy(qEnvironmentVariable("TOILE_SOURCE_DIR") +
                                     QStringLiteral("/samples/two-squares.toile")));
    QTRY_VERIFY(bench.workbench.frame().has_value());
}

/// This very program, told to edit and to be killed before it saves.
bool crashAfterAnEdit(const QString& recoveryFolder) {
    QProcess program;
    program.start(QCoreApplication::applicationFilePath(),
                  {QStringLiteral("tst_FileCommands"), QStringLiteral("crash"), recoveryFolder});
    return program.waitForFinished(60000) && program.exitStatus() == QProcess::CrashExit;
}

[[noreturn]] int crash(const QString& recoveryFolder) {
    WorkbenchParts parts = realParts(recoveryFolder);
    parts.recoveryDelay = std::chrono::milliseconds(1);
    Workbench workbench(std::move(parts));
    workbench.apply({QStringLiteral("Draw"), twoRectangles()});
    while (workbench.journal() && QDir(recoveryFolder).entryList({QStringLiteral("*.txt")}, QDir::Files).isEmpty())
        QCoreApplication::processEvents();
    std::raise(SIGKILL);
    std::abort();
}

/// Waits for a dialog that another one leads to.
template <class Dialog>
void onceAsked(std::function<void(Dialog&)> answer) {
    QTimer::singleShot(5, [answer = std::move(answer)] {
        auto* dialog = qobject_cast<Dialog*>(QApplication::activeModalWidget());
        return dialog ? answer(*dialog) : onceAsked(answer);
    });
}

/// Who does not replace the file is asked for another name, and gives up.
void answerReplacing(QMessageBox::ButtonRole answer) {
    onceAsked<QMessageBox>([answer](QMessageBox& box) {
        if (answer == QMessageBox::RejectRole) onceAsked<QFileDialog>([](QFileDialog& dialog) { dialog.reject(); });
        for (QAbstractButton* button : box.buttons())
            if (box.buttonRole(button) == answer) return button->click();
    });
}

QString contentOf(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

/// A field of the first piece's sheet, in which this has been typed and nothing more.
QWidget& typed(Bench& bench, const char* name, const char* text) {
    bench.workbench.select({bench.pattern().pieces[0]->id});
    QApplication::setActiveWindow(&bench.window); // only there have fields the focus
    auto* field = bench.find<QWidget>(name);
    field->setFocus();
    QTest::keySequence(field, QKeySequence::SelectAll);
    QTest::keyClicks(field, QLatin1String(text));
    return *field;
}

void answerRecovery(const QString& button) {
    Bench::whenAsked<QMessageBox>([button](QMessageBox& box) {
        for (QAbstractButton* each : box.buttons())
            if (each->text() == button) return each->click();
        QFAIL("there is no such answer");
    });
}

} // namespace

void tst_FileCommands::aDocumentIsSavedUnderANameThatOpenReads_data() {
    QTest::addColumn<QString>("asked");
    QTest::addColumn<QString>("file");
    QTest::newRow("ours") << "tee.toile"
                          << "tee.toile";
    QTest::newRow("ours in capitals") << "tee.TOILE"
                                      << "tee.TOILE";
    QTest::newRow("no ending") << "tee"
                               << "tee.toile";
    QTest::newRow("a dot that begins no ending") << "tee v1.2"
                                                 << "tee v1.2.toile";
    QTest::newRow("the ending of another format") << "tee.json"
                                                  << "tee.json.toile";
}

void tst_FileCommands::aDocumentIsSavedUnderANameThatOpenReads() {
    QFETCH(QString, asked);
    QFETCH(QString, file);
    QTemporaryDir folder;
    Bench bench;
    bench.workbench.apply({QStringLiteral("Draw"), twoRectangles()});
    Bench::nextFile(folder.filePath(asked));
    bench.action("file.saveAs")->trigger();
    QCOMPARE(bench.workbench.path(), folder.filePath(file));
    QCOMPARE(QDir(folder.path()).entryList(QDir::Files), QStringList(file));
    bench.workbench.startNew();
    QVERIFY(bench.window.files().openFile(folder.filePath(file)));
    QCOMPARE(bench.pattern().pieces.size(), std::size_t(2));
}

void tst_FileCommands::aFileIsReplacedOnlyAfterAQuestion() {
    QTemporaryDir folder;
    const QString file = written(folder, "tee v1.2.toile", "older work");
    Bench bench;
    bench.workbench.apply({QStringLiteral("Draw"), twoRectangles()});
    Bench::nextFile(folder.filePath(QStringLiteral("tee v1.2")));
    answerReplacing(QMessageBox::RejectRole);
    bench.action("file.saveAs")->trigger();
    QCOMPARE(contentOf(file), QStringLiteral("older work"));
    QVERIFY(bench.workbench.isModified());
    Bench::nextFile(folder.filePath(QStringLiteral("tee v1.2")));
    answerReplacing(QMessageBox::DestructiveRole);
    bench.action("file.saveAs")->trigger();
    QVERIFY(contentOf(file).startsWith(QLatin1Char('{')));
    QVERIFY(!bench.workbench.isModified());
}

void tst_FileCommands::theDrapeIsExported_data() {
    QTest::addColumn<QString>("asked");
    QTest::addColumn<QString>("kind");
    QTest::addColumn<QString>("file");
    const auto row = [](const char* name, const char* asked, const char* kind, const char* file) {
        QTest::newRow(name) << QString::fromLatin1(asked) << QString::fromLatin1(kind) << QString::fromLatin1(file);
    };
    row("glTF", "drape.glb", "", "drape.glb");
    row("OBJ", "drape.obj", "", "drape.obj");
    row("glTF where no ending is given", "drape", "", "drape.glb");
    row("OBJ where it is chosen", "drape", "Wavefront OBJ (*.obj)", "drape.obj");
    row("OBJ where it is chosen, and a dot begins no ending", "drape v1.2", "Wavefront OBJ (*.obj)", "drape v1.2.obj");
    row("what the name says where another is chosen", "drape.ply", "Wavefront OBJ (*.obj)", "drape.ply");
}

void tst_FileCommands::theDrapeIsExported() {
    QFETCH(QString, asked);
    QFETCH(QString, kind);
    QFETCH(QString, file);
    QTemporaryDir folder;
    Bench bench;
    drape(bench);
    Bench::nextFile(folder.filePath(asked), kind);
    bench.key(Qt::Key_E, Qt::ControlModifier);
    QCOMPARE(QDir(folder.path()).entryList(QDir::Files), QStringList(file));
    QVERIFY(QFileInfo(folder.filePath(file)).size() > 1000);
}

void tst_FileCommands::anExportReplacesAFileOnlyAfterAQuestion() {
    QTemporaryDir folder;
    Bench bench;
    drape(bench);
    const QString older = written(folder, "drape.obj", "an older one");
    const QString checkpoint = written(folder, "evening.checkpoint", "an older one");
    Bench::nextFile(folder.filePath(QStringLiteral("drape")), QStringLiteral("Wavefront OBJ (*.obj)"));
    answerReplacing(QMessageBox::RejectRole);
    bench.key(Qt::Key_E, Qt::ControlModifier);
    QCOMPARE(contentOf(older), QStringLiteral("an older one"));
    Bench::nextFile(folder.filePath(QStringLiteral("evening")));
    answerReplacing(QMessageBox::RejectRole);
    bench.action("simulation.saveCheckpoint")->trigger();
    QTRY_VERIFY(!bench.workbench.isFollowing());
    QCOMPARE(contentOf(checkpoint), QStringLiteral("an older one"));

    Bench::nextFile(folder.filePath(QStringLiteral("drape")), QStringLiteral("Wavefront OBJ (*.obj)"));
    answerReplacing(QMessageBox::DestructiveRole);
    bench.key(Qt::Key_E, Qt::ControlModifier);
    QVERIFY(QFileInfo(older).size() > 1000);
    QCOMPARE(QDir(folder.path()).entryList(QDir::Files), (QStringList{"drape.obj", "evening.checkpoint"}));
}

void tst_FileCommands::aSimulationIsSavedAndResumedInAnotherWindow() {
    QTemporaryDir folder;
    const QString sample = qEnvironmentVariable("TOILE_SOURCE_DIR") + QStringLiteral("/samples/two-squares.toile");
    Bench today, tomorrow;
    QVERIFY(today.workbench.openCopy(sample));
    today.key(Qt::Key_Space);
    QTRY_VERIFY(today.workbench.frame() && today.workbench.frame()->time > 0.1);
    today.key(Qt::Key_Space);
    Bench::nextFile(folder.filePath(QStringLiteral("evening")));
    today.action("simulation.saveCheckpoint")->trigger();
    const QString file = folder.filePath(QStringLiteral("evening.checkpoint"));
    QTRY_VERIFY(QFileInfo::exists(file));
    QTRY_VERIFY(!today.workbench.isFollowing());

    QVERIFY(tomorrow.workbench.openCopy(sample));
    Bench::nextFile(file);
    tomorrow.action("simulation.resume")->trigger();
    QTRY_VERIFY(tomorrow.workbench.frame() && tomorrow.workbench.frame()->time > 0);
    QCOMPARE(tomorrow.workbench.frame()->time, today.workbench.frame()->time);
    QVERIFY(tomorrow.workbench.frame()->positions == today.workbench.frame()->positions);

    // As the program without a window goes on with it.
    const auto document = io::readToile(sample.toStdString());
    const auto checkpoint = io::readCheckpoint(file.toStdString());
    QVERIFY(document && checkpoint);
    QVERIFY(simulation::Simulation::resumed(document::sceneOf(*document, {}), {}, *checkpoint));
}

void tst_FileCommands::aCheckpointThatCannotBeReadIsRefused() {
    QTemporaryDir folder;
    Bench bench;
    QString sentence;
    Bench::whenAsked<QMessageBox>([&](QMessageBox& box) {
        sentence = box.informativeText();
        box.accept();
    });
    bench.window.files().resumeFrom(written(folder, "broken.checkpoint", "{\"format\": \"toile-checkpoint\""));
    QVERIFY(sentence.contains(QStringLiteral("broken.checkpoint")));
}

void tst_FileCommands::withoutADrapeThereIsNothingToExport() {
    Bench bench;
    bench.key(Qt::Key_E, Qt::ControlModifier); // asks for no file
    QVERIFY(bench.find<QLabel>("statusMessage")->text().contains(QStringLiteral("no drape")));
}

void tst_FileCommands::aGarmentCodePatternIsImported() {
    QTemporaryDir folder;
    Bench bench;
    Bench::nextFile(written(folder, "panels.json", twoPanels));
    bench.key(Qt::Key_O, Qt::ControlModifier);
    QCOMPARE(bench.pattern().pieces.size(), std::size_t(2));
    QCOMPARE(bench.pattern().seams.size(), std::size_t(2));
    QVERIFY(bench.window.isWindowModified());  // it is no document of ours yet
    QVERIFY(bench.workbench.path().isEmpty()); // saving asks where to
    QVERIFY(!bench.action("edit.undo")->isEnabled());
    bench.key(Qt::Key_Z, Qt::ControlModifier); // undoes nothing
    QCOMPARE(bench.pattern().pieces.size(), std::size_t(2));
    QTRY_COMPARE(bench.workbench.mesh().size(), std::size_t(2));
}

void tst_FileCommands::whatAnImportAssumesIsTold() {
    QTemporaryDir folder;
    QByteArray text(twoPanels);
    QVERIFY(text.contains(R"(, "units_in_meter": 100)"));
    text.replace(R"(, "units_in_meter": 100)", "");
    text.replace("[20,30],[0,30]]", "[20,32],[0,30]]"); // sides of different length
    Bench bench;
    QVERIFY(bench.window.files().openFile(written(folder, "panels.json", text)));
    const auto* message = bench.find<QLabel>("statusMessage");
    QVERIFY(message->text().startsWith(QStringLiteral("Opened panels.json. Remarks (")));
    QVERIFY(message->text().contains(QStringLiteral("centimetres are assumed")));
    QVERIFY(message->text().contains(QStringLiteral("ease")));
    QVERIFY(!message->text().contains(QLatin1Char('\n')));
    QVERIFY(message->toolTip().contains(QStringLiteral("\nunits: ")));

    const auto saved = folder.filePath(QStringLiteral("panels.toile"));
    QVERIFY(bench.workbench.saveAs(saved));
    QVERIFY(bench.window.files().openFile(saved)); // a document of ours says all
    QCOMPARE(message->text(), QStringLiteral("Opened panels.toile"));
}

void tst_FileCommands::aBrokenFileIsRefusedWithASentence() {
    QTemporaryDir folder;
    Bench bench;
    bench.workbench.startFrom(twoRectangles(), {}, false);
    QString sentence;
    Bench::whenAsked<QMessageBox>([&](QMessageBox& box) {
        sentence = box.informativeText();
        box.accept();
    });
    QVERIFY(
        !bench.window.files().openFile(written(folder, "broken.toile", "{\"format\": \"toile\", \"version\": 1, ")));
    QVERIFY(sentence.contains(QStringLiteral("broken.toile")));
    QVERIFY(bench.workbench.document() == twoRectangles()); // what was open stays
}

void tst_FileCommands::workOfAKilledProgramIsRecovered() {
    QTemporaryDir folder;
    QVERIFY(crashAfterAnEdit(folder.path()));
    {
        Bench bench(folder.path());
        answerRecovery(QStringLiteral("Later"));
        QVERIFY(!bench.window.files().offerRecovery());
        QVERIFY(bench.pattern().pieces.empty()); // and it is offered again
    }
    Bench bench(folder.path());
    answerRecovery(QStringLiteral("Recover"));
    QVERIFY(bench.window.files().offerRecovery());
    QVERIFY(bench.workbench.document() == *io::asWritten(twoRectangles()));
    QVERIFY(bench.window.isWindowModified());
    QVERIFY(bench.workbench.journal()->leftovers().empty()); // it is ours now, and kept under our name
    bench.workbench.journal()->clear();
}

void tst_FileCommands::lostWorkCanBeDiscarded() {
    QTemporaryDir folder;
    QVERIFY(crashAfterAnEdit(folder.path()));
    Bench bench(folder.path());
    answerRecovery(QStringLiteral("Discard"));
    QVERIFY(!bench.window.files().offerRecovery());
    QVERIFY(bench.pattern().pieces.empty());
    QVERIFY(bench.workbench.journal()->leftovers().empty());
    QVERIFY(QDir(folder.path()).entryList({QStringLiteral("*.toile")}, QDir::Files).isEmpty());
}

void tst_FileCommands::discardedWorkStaysRecordedWhileItStaysOpen() {
    QTemporaryDir folder, recovery;
    const auto records = [&] {
        return QDir(recovery.path()).entryList({QStringLiteral("*.recovery.toile")}, QDir::Files).size();
    };
    const auto discard = [](QMessageBox& box) { box.button(QMessageBox::Discard)->click(); };
    Bench bench(recovery.path());
    bench.workbench.apply({QStringLiteral("Draw"), twoRectangles()});
    QVERIFY(bench.workbench.journal()->record(bench.workbench.document(), {}));

    Bench::whenAsked<QMessageBox>([&](QMessageBox& box) {
        discard(box);
        onceAsked<QMessageBox>([](QMessageBox& problem) { problem.accept(); });
    });
    QVERIFY(!bench.window.files().openFile(written(folder, "broken.toile", "{")));
    QVERIFY(bench.workbench.document() == twoRectangles());
    QCOMPARE(records(), 1);

    Bench::whenAsked<QMessageBox>(discard);
    QVERIFY(bench.window.files().openFile(written(folder, "panels.json", twoPanels)));
    QCOMPARE(records(), 0);
}

void tst_FileCommands::whatIsBeingTypedIsSaved() {
    QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("typed.toile"));
    Bench bench;
    bench.workbench.startFrom(twoRectangles(), file, false);
    QWidget& field = typed(bench, "seamAllowance", "25");
    QTest::keyClick(&field, Qt::Key_S, Qt::ControlModifier);
    const auto saved = io::readToile(file.toStdString());
    QVERIFY(saved);
    QCOMPARE(saved->pattern.pieces[0]->seamAllowance, 0.025);
    QVERIFY(!bench.window.isWindowModified());
    QVERIFY(field.hasFocus()); // typing goes on
}

void tst_FileCommands::closingAsksAboutWhatIsBeingTyped() {
    Bench bench;
    bench.workbench.startFrom(twoRectangles(), {}, false);
    typed(bench, "name", "Sleeve");
    Bench::whenAsked<QMessageBox>([](QMessageBox& box) { box.button(QMessageBox::Cancel)->click(); });
    QVERIFY(!bench.window.close());
    QVERIFY(bench.pattern().pieces[0]->name == "Sleeve");
}

void tst_FileCommands::actionsWorkOnWhatIsBeingTyped_data() {
    QTest::addColumn<QString>("action");
    for (const char* id : {"simulation.play", "simulation.step", "simulation.reset", "edit.layOut"})
        QTest::newRow(id) << id;
}

void tst_FileCommands::actionsWorkOnWhatIsBeingTyped() {
    QFETCH(QString, action);
    Bench bench;
    bench.workbench.startFrom(twoRectangles(), {}, false);
    typed(bench, "spacing", "25");
    bench.action(action.toLatin1())->trigger();
    QCOMPARE(bench.pattern().pieces[0]->spacing, 0.025);
}

void tst_FileCommands::aWindowMayEndWhileSomethingIsBeingTyped() {
    Bench bench;
    bench.workbench.startFrom(twoRectangles(), {}, false);
    typed(bench, "name", "Sleeve"); // the field loses the focus when half of the window has gone
}

/// The test, or the program that it sees killed.
static const suite::Entry testOrCrash("tst_FileCommands", [](int argc, char** argv) {
    if (argc != 3 || qstrcmp(argv[1], "crash") != 0) return suite::run<tst_FileCommands, QApplication>(argc, argv);
    QApplication application(argc, argv);
    return crash(QString::fromLocal8Bit(argv[2]));
});
#include "tst_FileCommands.moc"
