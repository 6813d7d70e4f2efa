// SPDX-License-Identifier: GPL-3.0-or-later
#include "Png.h" // before ours: moc 6.4 stumbles over <compare> as the first header
#include "tests/Suite.h"

#include "SewFolder.h"

#include <csignal>

using namespace toile;

/// What `toile-cli sew` writes and where it refuses to; what is left when it is stopped, and going on from there.
class tst_SewOutputs : public QObject, private SewFolder {
    Q_OBJECT
private slots:
    void init() { QVERIFY(makeAnew()); }
    void everyDrapeFormatIsWritten();
    void framesAreKeptAsAPointCacheOrAFolder();
    void framesOfAnotherRunAreNotMixedIn();
    void aPictureIsNotBlank();
    void aMissingFolderIsSaidAndNothingIsWritten();
    void noResultTakesThePlaceOfAnInputOrOfAnother_data();
    void noResultTakesThePlaceOfAnInputOrOfAnother();
    void whatCannotBeWrittenIsSaidBeforeTheRun_data();
    void whatCannotBeWrittenIsSaidBeforeTheRun();
    void namesMayEndInCapitals();
    void aBrokenDocumentIsRefused();
    void anInterruptLeavesNothingBehind_data();
    void anInterruptLeavesNothingBehind();
    void aRunThatIsToldToEndKeepsItsCheckpoint_data() { anInterruptLeavesNothingBehind_data(); }
    void aRunThatIsToldToEndKeepsItsCheckpoint();
    void aCheckpointMayTakeThePlaceOfTheOneItGoesOnFrom();
    void aStoppedRunGoesOnFromItsCheckpoint();
};

void tst_SewOutputs::everyDrapeFormatIsWritten() {
    for (const char* file : {"drape.glb", "drape.obj", "drape.ply", "drape.stl"}) {
        QCOMPARE(run({"sew", sample("two-squares.toile"), "--seconds", "0.1", "--out", in(file)}).status,
                 3); // not sewn yet
        QVERIFY2(contentOf(in(file)).size() > 1000, file);
    }
}

void tst_SewOutputs::framesAreKeptAsAPointCacheOrAFolder() {
    QCOMPARE(run({"sew", sample("two-squares.toile"), "--seconds", "0.1", "--frames", in("cache.pc2")}).status,
             3); // not sewn yet
    QCOMPARE(run({"sew", sample("two-squares.toile"), "--seconds", "0.1", "--frames", in("frames"), "--out",
                  in("drape.obj"), "--report", in("sew.json")})
                 .status,
             3);
    const QStringList frames = QDir(in("frames")).entryList(QDir::Files);
    QCOMPARE(frames.size(), 7); // the start and six steps
    QCOMPARE(contentOf(in("frames") + "/frame-00006.obj"), contentOf(in("drape.obj")));
    QCOMPARE(*report().find("frames")->find("count")->asNumber(), 7.0);
    const qsizetype points = contentOf(in("drape.obj")).count("\nv ");
    QCOMPARE(contentOf(in("cache.pc2")).size(), 32 + 7 * points * 12);
}

void tst_SewOutputs::framesOfAnotherRunAreNotMixedIn() {
    QVERIFY(run({"sew", sample("two-squares.toile"), "--seconds", "0.1", "--frames", in("frames")}).status == 3);
    const Finished again = run({"sew", sample("two-squares.toile"), "--seconds", "0.1", "--frames", in("frames")});
    QCOMPARE(again.status, 1);
    QVERIFY2(again.err.contains("frames of another run"), qPrintable(again.err));
}

void tst_SewOutputs::aPictureIsNotBlank() {
    const Finished finished = run(
        {"sew", "--picture", in("front.png") + "," + in("back.png"), sample("two-squares.toile"), "--seconds", "3"});
    QVERIFY2(finished.status == 0, qPrintable(finished.err));
    QVERIFY(coloursIn(in("front.png")) > 100); // shaded cloth before a ground that is no plain colour
    QVERIFY(coloursIn(in("back.png")) > 100);
}

void tst_SewOutputs::aMissingFolderIsSaidAndNothingIsWritten() {
    const Finished finished =
        run({"sew", sample("two-squares.toile"), "--out", in("drape.glb"), "--report", in("none/sew.json")});
    QCOMPARE(finished.status, 1);
    QCOMPARE(finished.errorLines().size(), 1);
    QVERIFY(finished.err.contains("There is no folder"));
    QCOMPARE(files(), QStringList());
}

void tst_SewOutputs::noResultTakesThePlaceOfAnInputOrOfAnother_data() {
    QTest::addColumn<QStringList>("options");
    QTest::newRow("a report over the document") << QStringList{"--report", "squares.toile"};
    QTest::newRow("a report over the document, by another way") << QStringList{"--report", "poses/../squares.toile"};
    QTest::newRow("a report over the document, by a link") << QStringList{"--report", "link.toile"};
    QTest::newRow("a checkpoint over the document") << QStringList{"--checkpoint", "squares.toile"};
    QTest::newRow("a drape over the document's avatar") << QStringList{"--out", "body.glb"};
    QTest::newRow("a drape over another avatar") << QStringList{"--avatar", "poses/a.glb", "--out", "poses/a.glb"};
    QTest::newRow("a drape over a pose") << QStringList{"--motion", "poses", "--out", "poses/a.glb"};
    QTest::newRow("frames among the poses") << QStringList{"--motion", "poses", "--frames", "poses"};
    QTest::newRow("a report over what it goes on from") << QStringList{"--resume", "point", "--report", "point"};
    QTest::newRow("a drape and its report") << QStringList{"--out", "same.obj", "--report", "./same.obj"};
    QTest::newRow("a checkpoint and a report") << QStringList{"--checkpoint", "same", "--report", "same"};
    QTest::newRow("two pictures") << QStringList{"--picture", "same.png,same.png"};
}

void tst_SewOutputs::noResultTakesThePlaceOfAnInputOrOfAnother() {
    QFETCH(QStringList, options);
    const QString document = squaresWith(box(0.05, 0.05));
    QVERIFY(QDir().mkpath(in("poses")));
    QVERIFY(QFile::copy(in("body.glb"), in("poses/a.glb")));
    QVERIFY(QFile::link(document, in("link.toile")));
    QVERIFY(QFile::copy(document, in("point")));
    const QString workingFolder = QDir::currentPath();
    QVERIFY(QDir::setCurrent(folder_->path()));
    const QByteArray before = contentOf(document), body = contentOf(in("body.glb"));
    const Finished finished = run(QStringList{"sew", document, "--seconds", "0.02"} + options);
    QVERIFY(QDir::setCurrent(workingFolder));
    QCOMPARE(finished.status, 1);
    QCOMPARE(finished.errorLines().size(), 1); // no progress: nothing was done
    QVERIFY2(finished.err.contains("name another file"), qPrintable(finished.err));
    QCOMPARE(contentOf(document), before);
    QCOMPARE(contentOf(in("body.glb")), body);
    QCOMPARE(contentOf(in("poses/a.glb")), body);
    QCOMPARE(contentOf(in("point")), before);
    QVERIFY(!QFile::exists(in("same")) && !QFile::exists(in("same.obj")) && !QFile::exists(in("same.png")));
}

void tst_SewOutputs::whatCannotBeWrittenIsSaidBeforeTheRun_data() {
    QTest::addColumn<QStringList>("options");
    QTest::newRow("a drape where a folder is") << QStringList{"--out", "folder.glb"};
    QTest::newRow("a report where a folder is") << QStringList{"--report", "folder.glb"};
    QTest::newRow("a picture where a folder is") << QStringList{"--picture", "folder.png"};
    QTest::newRow("a checkpoint where a folder is") << QStringList{"--checkpoint", "folder.glb"};
    QTest::newRow("a point cache where a folder is") << QStringList{"--frames", "folder.pc2"};
    QTest::newRow("frames where a file is") << QStringList{"--frames", "file"};
    QTest::newRow("frames among others") << QStringList{"--frames", "kept"};
    QTest::newRow("a folder that takes no file") << QStringList{"--out", "/proc/drape.glb"};
    QTest::newRow("a folder that takes no folder") << QStringList{"--frames", "/proc/frames"};
}

void tst_SewOutputs::whatCannotBeWrittenIsSaidBeforeTheRun() {
    QFETCH(QStringList, options);
    for (const char* folder : {"folder.glb", "folder.png", "folder.pc2", "kept"}) QVERIFY(QDir().mkpath(in(folder)));
    for (const char* file : {"file", "kept/frame-00000.obj"})
        QVERIFY(QFile::copy(sample("two-squares.toile"), in(file)));
    if (!QDir::isAbsolutePath(options.last())) options.last() = in(qPrintable(options.last()));
    const Finished finished =
        run(QStringList{"sew", sample("two-squares.toile"), "--spacing", "10", "--refine", "--limit", "0.1"} + options);
    QCOMPARE(finished.status, 1);
    QCOMPARE(finished.errorLines().size(), 1); // no progress, no seam that stayed open
    QVERIFY2(finished.err.startsWith(options.last() + ": "), qPrintable(finished.err));
    QCOMPARE(files().size(), 5);
}

void tst_SewOutputs::namesMayEndInCapitals() {
    const Finished finished = run({"sew", sample("two-squares.toile"), "--seconds", "0.1", "--frames", in("CACHE.PC2"),
                                   "--out", in("DRAPE.OBJ"), "--picture", in("FRONT.PNG")});
    QCOMPARE(finished.status, 3); // not sewn yet
    QVERIFY(contentOf(in("CACHE.PC2")).startsWith("POINTCACHE2"));
    QVERIFY(contentOf(in("DRAPE.OBJ")).contains("\nv "));
    QVERIFY(contentOf(in("FRONT.PNG")).contains("PNG"));
}

void tst_SewOutputs::aBrokenDocumentIsRefused() {
    const Finished finished = run({"sew", sample("broken/unknown-piece-in-seam.toile"), "--out", in("drape.glb")});
    QCOMPARE(finished.status, 1);
    QVERIFY(finished.err.contains("There is no piece \"sleeve\"."));
    QCOMPARE(files(), QStringList());
}

void tst_SewOutputs::anInterruptLeavesNothingBehind_data() {
    QTest::addColumn<int>("signal");
    QTest::newRow("Ctrl+C") << SIGINT;
    QTest::newRow("told to end") << SIGTERM;
    QTest::newRow("the terminal is closed") << SIGHUP;
    QTest::newRow("nobody reads on") << SIGPIPE;
}

void tst_SewOutputs::anInterruptLeavesNothingBehind() {
    QFETCH(int, signal);
    QProcess process; // a garment that takes minutes
    process.setReadChannel(QProcess::StandardError);
    process.start(program(), {"sew", sample("blouse.toile"), "--spacing", "10", "--out", in("drape.glb"), "--report",
                              in("sew.json"), "--frames", in("cache.pc2")});
    QVERIFY(process.waitForReadyRead(60000)); // its first word of progress
    QVERIFY(files().join(' ').contains(".cache.pc2."));
    ::kill(static_cast<pid_t>(process.processId()), signal);
    QVERIFY(process.waitForFinished(60000));
    QCOMPARE(process.exitStatus(), QProcess::NormalExit);
    QVERIFY(process.exitCode() != 0);
    QVERIFY(process.readAllStandardError().contains("stopped"));
    QCOMPARE(files(), QStringList());
}

void tst_SewOutputs::aRunThatIsToldToEndKeepsItsCheckpoint() {
    QFETCH(int, signal);
    QProcess process;
    process.setReadChannel(QProcess::StandardError);
    process.start(program(), {"sew", sample("blouse.toile"), "--spacing", "10", "--checkpoint", in("point")});
    QVERIFY(process.waitForReadyRead(60000));
    ::kill(static_cast<pid_t>(process.processId()), signal);
    QVERIFY(process.waitForFinished(60000));
    QCOMPARE(process.exitStatus(), QProcess::NormalExit);
    QCOMPARE(process.exitCode(), 1);
    QVERIFY(contentOf(in("point")).contains("toile-checkpoint"));
}

void tst_SewOutputs::aCheckpointMayTakeThePlaceOfTheOneItGoesOnFrom() {
    const QStringList sew{"sew", sample("two-squares.toile"), "--seconds", "0.1", "--checkpoint", in("point")};
    QCOMPARE(run(sew).status, 3); // not sewn yet
    const QByteArray first = contentOf(in("point"));
    QCOMPARE(run(sew + QStringList{"--resume", in("point")}).status, 3);
    QVERIFY(!first.isEmpty() && contentOf(in("point")) != first);
}

void tst_SewOutputs::aStoppedRunGoesOnFromItsCheckpoint() {
    const QString squares = sample("two-squares.toile"), point = in("squares.checkpoint");
    const auto hashAfter = [&](const QStringList& options) {
        const Finished finished = run(QStringList{"sew", squares, "--report", in("sew.json")} + options);
        return finished.status == 0 ? *report().find("resultHash")->asString() : finished.err.toStdString();
    };
    (void)run({"sew", squares, "--seconds", "0.3", "--checkpoint", point}); // its seam is not closed yet
    const std::string once = hashAfter({"--resume", point, "--seconds", "1"});
    QCOMPARE(once.size(), std::size_t{64}); // the seam is closed now
    QCOMPARE(hashAfter({"--resume", point, "--seconds", "1"}), once);
    QVERIFY(hashAfter({"--resume", point, "--seconds", "1", "--spacing", "10"}).find("another scene") !=
            std::string::npos);
    QVERIFY(hashAfter({"--resume", in("none")}).find("none") != std::string::npos);
}

TOILE_TEST(tst_SewOutputs, QCoreApplication)
#include "tst_SewOutputs.moc"
