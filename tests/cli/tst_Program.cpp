// SPDX-License-Identifier: GPL-3.0-or-later
#include "Program.h"
#include "tests/Suite.h"

#include <QTemporaryDir>
#include <csignal>

using namespace toile;

/// toile-cli as a whole, and its smaller commands.
class tst_Program : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { QVERIFY(folder_.isValid()); }
    void linksNoQt();
    void saysWhatItIs();
    void explainsItself();
    void wrongUsage_data();
    void wrongUsage();
    void aWrongWordIsNamed_data();
    void aWrongWordIsNamed();
    void tooLittleMemoryIsSaid();
    void anAvatarIsWrittenAndReadBack();
    void anAvatarsNameMayEndInCapitals();
    void anImpossibleBodyIsRefused();
    void whatIsImpossibleIsSaidAsItWasGiven_data();
    void whatIsImpossibleIsSaidAsItWasGiven();
    void anAvatarIntoAMissingFolderIsRefused();
    void anInterruptEndsAtOnceWhatHasNothingToLeave();
    void inspectPrintsJson();
    void inspectPrintsText();
    void inspectRefusesWhatItCannotRead();
    void aConvertedDocumentIsTheSame();
    void aConvertedSampleIsSoundWhereverItLies_data();
    void aConvertedSampleIsSoundWhereverItLies();
    void convertWritesOnlyDocuments();
    void convertWritesOverNothingItReads();

private:
    [[nodiscard]] QString in(const char* name) const { return folder_.filePath(name); }
    QTemporaryDir folder_;
};

void tst_Program::linksNoQt() {
    QProcess ldd;
    ldd.start("ldd", {program()});
    QVERIFY(ldd.waitForFinished());
    const QString libraries = ldd.readAllStandardOutput();
    QVERIFY(libraries.contains("libc.so")); // it did list them
    QVERIFY2(!libraries.contains("Qt"), qPrintable(libraries));
}

void tst_Program::saysWhatItIs() {
    const Finished finished = run({"--version"});
    QCOMPARE(finished.status, 0);
    QVERIFY(finished.out.startsWith("toile-cli "));
    QVERIFY(finished.out.contains("0.1.0"));
}

void tst_Program::explainsItself() {
    const Finished finished = run({"--help"});
    QCOMPARE(finished.status, 0);
    for (const char* command : {"check", "mesh", "sew", "avatar", "inspect", "convert"})
        QVERIFY(finished.out.contains(command));
}

void tst_Program::wrongUsage_data() {
    QTest::addColumn<QStringList>("arguments");
    QTest::newRow("nothing") << QStringList{};
    QTest::newRow("an unknown command") << QStringList{"knit"};
    QTest::newRow("an unknown option") << QStringList{"--loud"};
    QTest::newRow("an avatar without a file") << QStringList{"avatar"};
    QTest::newRow("a girth that is no number") << QStringList{"avatar", "--bust", "large", "--out", "x.glb"};
    QTest::newRow("inspect without a file") << QStringList{"inspect"};
    QTest::newRow("convert without a target") << QStringList{"convert", sample("tube.toile")};
}

void tst_Program::wrongUsage() {
    QFETCH(QStringList, arguments);
    const Finished finished = run(arguments);
    QCOMPARE(finished.status, 2);
    QVERIFY(!finished.err.isEmpty());
}

void tst_Program::tooLittleMemoryIsSaid() {
    QProcess shell; // one thread, as those of OpenBLAS take memory by the number of cores
    shell.start("sh", {"-c", "ulimit -v 800000; OPENBLAS_NUM_THREADS=1 exec \"$0\" \"$@\"", program(), "mesh",
                       sample("blouse.toile"), "--spacing", "0.3", "--out", in("mesh.obj")});
    QVERIFY(shell.waitForFinished(60000));
    QCOMPARE(shell.exitStatus(), QProcess::NormalExit);
    QCOMPARE(shell.exitCode(), 1);
    const QByteArray said = shell.readAllStandardError();
    QVERIFY2(said.contains("not enough memory"), said.constData());
    QVERIFY(!QFile::exists(in("mesh.obj")));
}

void tst_Program::aWrongWordIsNamed_data() {
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<QStringList>("said");
    QTest::newRow("a command") << QStringList{"frobnicate"}
                               << QStringList{"\"frobnicate\" of toile-cli", "check, mesh"};
    QTest::newRow("a study") << QStringList{"study", "bogus"} << QStringList{"\"bogus\" of study", "accuracy, regions"};
    QTest::newRow("an option") << QStringList{"--loud"} << QStringList{"\"--loud\" of toile-cli"};
    QTest::newRow("too many substeps") << QStringList{"sew", sample("tube.toile"), "--substeps", "1000000"}
                                       << QStringList{"1000000", "1 to 100000"};
}

void tst_Program::aWrongWordIsNamed() {
    QFETCH(QStringList, arguments);
    QFETCH(QStringList, said);
    const Finished finished = run(arguments);
    QCOMPARE(finished.status, 2);
    for (const QString& words : said) QVERIFY2(finished.err.contains(words), qPrintable(finished.err));
}

void tst_Program::anAvatarIsWrittenAndReadBack() {
    const Finished made = run({"avatar", "--height", "1720", "--bust", "940", "--out", in("body.glb")});
    QVERIFY2(made.status == 0, qPrintable(made.err));
    QVERIFY(made.out.contains("bust") && made.out.contains("940.0"));
    QVERIFY(contentOf(in("body.glb")).startsWith("glTF"));
    const Json body = jsonOf(run({"inspect", in("body.glb"), "--json"}).out.toUtf8());
    QCOMPARE(missingKeys(body, {"name", "vertices", "triangles", "closed", "height", "limbs"}), QString());
    QCOMPARE(*body.find("closed")->asBool(), true);
    QCOMPARE(*body.find("limbs")->asNumber(), 6.0);
    QVERIFY(std::abs(*body.find("height")->asNumber() - 1.72) < 0.005);
}

void tst_Program::anAvatarsNameMayEndInCapitals() {
    QCOMPARE(run({"avatar", "--out", in("BODY.GLB")}).status, 0);
    QVERIFY(jsonOf(run({"inspect", in("BODY.GLB"), "--json"}).out.toUtf8()).find("vertices"));
}

void tst_Program::anImpossibleBodyIsRefused() {
    const Finished finished = run({"avatar", "--waist", "3000", "--out", in("giant.glb")});
    QCOMPARE(finished.status, 1);
    QCOMPARE(finished.errorLines().size(), 1);
    QVERIFY2(finished.err.contains("waist", Qt::CaseInsensitive), qPrintable(finished.err));
    QVERIFY(!QFile::exists(in("giant.glb")));
}

void tst_Program::whatIsImpossibleIsSaidAsItWasGiven_data() {
    QTest::addColumn<QStringList>("options");
    QTest::addColumn<QString>("said");
    QTest::newRow("centimetres for millimetres")
        << QStringList{"--height", "170"}
        << "--height: It must lie between 1300 and 2200 mm for this body, but is 170.";
    QTest::newRow("an angle") << QStringList{"--shoulder-slope", "90"}
                              << "--shoulder-slope: It must lie between 8.6 and 34.3 degrees for this body, but is 90.";
    QTest::newRow("a name of two words, and a limit by another option")
        << QStringList{"--under-bust", "950.5", "--bust", "910.27"}
        << "--under-bust: It must lie between 550 and 910.2 mm for this body, but is 950.5.";
    QTest::newRow("edges of a millimetre")
        << QStringList{"--edge", "1"} << "--edge: It must lie between 3 and 15 mm for this body, but is 1.";
    QTest::newRow("no number") << QStringList{"--waist", "nan"}
                               << "--waist: It must lie between 480 and 1450 mm for this body, but is nan.";
}

void tst_Program::whatIsImpossibleIsSaidAsItWasGiven() {
    QFETCH(QStringList, options);
    QFETCH(QString, said);
    const Finished finished = run(QStringList{"avatar", "--out", in("none.glb")} + options);
    QCOMPARE(finished.status, 1);
    QCOMPARE(finished.err.trimmed(), said);
}

void tst_Program::anAvatarIntoAMissingFolderIsRefused() {
    const Finished finished = run({"avatar", "--out", in("none/body.glb")});
    QCOMPARE(finished.status, 1);
    QVERIFY(finished.err.contains("There is no folder"));
}

void tst_Program::anInterruptEndsAtOnceWhatHasNothingToLeave() {
    QProcess process; // for some ten seconds
    process.start(program(), {"avatar", "--edge", "3", "--out", in("fine.glb")});
    QVERIFY(process.waitForStarted());
    QTest::qWait(500);
    QCOMPARE(process.state(), QProcess::Running);
    ::kill(static_cast<pid_t>(process.processId()), SIGINT);
    QVERIFY(process.waitForFinished(minutes));
    QCOMPARE(process.exitStatus(), QProcess::CrashExit); // by the signal
    QVERIFY(!QFile::exists(in("fine.glb")));
}

void tst_Program::inspectPrintsJson() {
    const Finished finished = run({"inspect", sample("blouse.toile"), "--json"});
    QCOMPARE(finished.status, 0);
    const Json json = jsonOf(finished.out.toUtf8());
    QCOMPARE(missingKeys(json, {"avatar", "pieces", "seams", "tacks", "fabrics"}), QString());
    QCOMPARE(json.find("pieces")->asArray()->size(), std::size_t(7));
    QCOMPARE(json.find("seams")->asArray()->size(), std::size_t(21));
    for (const Json& seam : *json.find("seams")->asArray()) // drafted exactly: what is left over is declared
        QVERIFY(std::abs(*seam.find("difference")->asNumber() - *seam.find("declaredEase")->asNumber()) < 1e-6);
}

void tst_Program::inspectPrintsText() {
    const Finished finished = run({"inspect", sample("blouse.toile")});
    QCOMPARE(finished.status, 0);
    QVERIFY(finished.out.contains("pieces: 7") && finished.out.contains("Sleeve left"));
}

void tst_Program::inspectRefusesWhatItCannotRead() {
    QCOMPARE(run({"inspect", sample("broken/truncated.toile")}).status, 1);
    QCOMPARE(run({"inspect", "/no/such/body.glb"}).status, 1);
}

void tst_Program::aConvertedDocumentIsTheSame() {
    QCOMPARE(run({"convert", sample("two-squares.toile"), in("copy.toile")}).status, 0);
    QCOMPARE(contentOf(in("copy.toile")), contentOf(sample("two-squares.toile")));
}

void tst_Program::aConvertedSampleIsSoundWhereverItLies_data() {
    QTest::addColumn<QString>("file");
    for (const QString& file : QDir(sample("")).entryList({"*.toile"}, QDir::Files))
        QTest::newRow(qPrintable(file)) << file;
}

void tst_Program::aConvertedSampleIsSoundWhereverItLies() {
    QFETCH(QString, file);
    QVERIFY(QDir().mkpath(in("deep/er")));
    QVERIFY(QFile::exists(in("short")) || QFile::link(in("deep/er"), in("short"))); // its ".." is deep
    const QString elsewhere = in("short/copy.toile"), onward = in("deep/copy.toile");
    QCOMPARE(run({"convert", sample(file), elsewhere}).status, 0);
    QCOMPARE(run({"convert", elsewhere, onward}).status, 0);
    for (const QString& copy : {elsewhere, onward}) {
        const Finished checked = run({"check", copy});
        QVERIFY2(checked.status == 0 && checked.err.isEmpty(), qPrintable(checked.err));
    }
    const Json avatar = *jsonOf(run({"inspect", elsewhere, "--json"}).out.toUtf8()).find("avatar");
    QVERIFY(avatar.isNull() || avatar.asString()->starts_with("../"));
}

void tst_Program::convertWritesOnlyDocuments() {
    const Finished finished = run({"convert", sample("two-squares.toile"), in("copy.dxf")});
    QCOMPARE(finished.status, 1);
    QVERIFY(!QFile::exists(in("copy.dxf")));
}

void tst_Program::convertWritesOverNothingItReads() {
    QVERIFY(QFile::copy(sample("two-squares.toile"), in("mine.toile")));
    const Finished finished = run({"convert", in("mine.toile"), in("mine.toile")});
    QCOMPARE(finished.status, 1);
    QVERIFY2(finished.err.contains("name another file"), qPrintable(finished.err));
}

TOILE_TEST(tst_Program, QCoreApplication)
#include "tst_Program.moc"
