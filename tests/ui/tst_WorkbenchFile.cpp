// SPDX-License-Identifier: GPL-3.0-or-later
#include "WorkbenchFixture.h"
#include "core/document/DocumentEdits.h"
#include "tests/Suite.h"

#include <QDir>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

using namespace toile;
using namespace toile::ui;

/// The document and its file: saving, the avatar beside it, and work that would be lost.
class tst_WorkbenchFile : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void savingAndOpeningGivesTheSameDocument();
    void modifiedMarkFollowsSaving();
    void theAvatarIsFoundAfterSavingElsewhereAndUndo();
    void theAvatarIsReadAnewWhenItIsImportedOrOpenedAgain();
    void unsavedWorkIsRecovered();
    void theOnlyRecordIsKeptWhenItCannotBeTakenOver();
    void whoNeverPausesIsRecorded();
    void savedWorkLeavesNothingToRecover();
    void undoneWorkLeavesNothingToRecover();
};

void tst_WorkbenchFile::savingAndOpeningGivesTheSameDocument() {
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

void tst_WorkbenchFile::modifiedMarkFollowsSaving() {
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

void tst_WorkbenchFile::theAvatarIsFoundAfterSavingElsewhereAndUndo() {
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
void tst_WorkbenchFile::theAvatarIsReadAnewWhenItIsImportedOrOpenedAgain() {
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

void tst_WorkbenchFile::unsavedWorkIsRecovered() {
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

void tst_WorkbenchFile::theOnlyRecordIsKeptWhenItCannotBeTakenOver() {
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

void tst_WorkbenchFile::whoNeverPausesIsRecorded() {
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

void tst_WorkbenchFile::savedWorkLeavesNothingToRecover() {
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

void tst_WorkbenchFile::undoneWorkLeavesNothingToRecover() {
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

TOILE_TEST(tst_WorkbenchFile, QCoreApplication)
#include "tst_WorkbenchFile.moc"
