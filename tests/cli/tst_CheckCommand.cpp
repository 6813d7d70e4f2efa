// SPDX-License-Identifier: GPL-3.0-or-later
#include "Program.h"
#include "tests/Suite.h"

#include <QTemporaryDir>

using namespace toile;

/// toile-cli check: one line a problem, and an exit status that scripts can rely on.
class tst_CheckCommand : public QObject {
    Q_OBJECT
private slots:
    void ourSamplesAreSound();
    void thereAreTwentyBrokenDocuments();
    void aBrokenDocumentGivesOneLineThatNamesIt_data();
    void aBrokenDocumentGivesOneLineThatNamesIt();
    void whatItRefusesIsNotSewn_data();
    void whatItRefusesIsNotSewn();
    void aMissingFileIsSaid();
    void oneBrokenFileAmongSoundOnesIsEnough();
    void aNameDoesNotBreakTheLine();
    void withoutAFileTheUsageIsWrong();

private:
    static QStringList brokenDocuments() { return QDir(sample("broken")).entryList({"*.toile"}, QDir::Files); }
    static void addBrokenDocuments() {
        QTest::addColumn<QString>("file");
        for (const QString& file : brokenDocuments()) QTest::newRow(qPrintable(file)) << file;
    }
    static bool isOnlyWarnedOf(const QString& file) {
        static const QStringList those{"nearly-equal-seam.toile", "pinned-to-no-body.toile", "wrong-way-round.toile"};
        return those.contains(file);
    }
};

void tst_CheckCommand::ourSamplesAreSound() {
    QStringList files;
    for (const QString& file : QDir(sample("")).entryList({"*.toile"}, QDir::Files)) files << sample(file);
    QVERIFY(files.size() >= 9);
    const Finished finished = run(QStringList{"check"} + files);
    QVERIFY2(finished.status == 0, qPrintable(finished.err));
    QVERIFY2(finished.err.isEmpty(), qPrintable(finished.err));
    QVERIFY(finished.out.isEmpty());
}

void tst_CheckCommand::thereAreTwentyBrokenDocuments() {
    QVERIFY(brokenDocuments().size() >= 20);
}

void tst_CheckCommand::aBrokenDocumentGivesOneLineThatNamesIt_data() {
    addBrokenDocuments();
}

void tst_CheckCommand::aBrokenDocumentGivesOneLineThatNamesIt() {
    QFETCH(QString, file);
    const Finished finished = run({"check", sample("broken/" + file)});
    QCOMPARE(finished.status, isOnlyWarnedOf(file) ? 0 : 1);
    QVERIFY2(finished.errorLines().size() == 1, qPrintable(finished.err));
    QVERIFY2(finished.err.startsWith(sample("broken/" + file) + ":"), qPrintable(finished.err));
    QCOMPARE(finished.err.contains(": warning: "), isOnlyWarnedOf(file));
    QVERIFY(finished.err.trimmed().endsWith('.') || finished.err.trimmed().endsWith('?')); // a sentence
}

void tst_CheckCommand::whatItRefusesIsNotSewn_data() {
    addBrokenDocuments();
}

void tst_CheckCommand::whatItRefusesIsNotSewn() {
    QFETCH(QString, file);
    const Finished sewn = run({"sew", sample("broken/" + file), "--seconds", "0.02"});
    QCOMPARE(sewn.status, isOnlyWarnedOf(file) ? 3 : 1); // 3: its seams are not closed so soon
    if (isOnlyWarnedOf(file)) return;
    if (file == "missing-avatar.toile") // the file that is not there is named, not the line that names it
        QVERIFY2(sewn.err.contains("nobody.glb: "), qPrintable(sewn.err));
    else QCOMPARE(sewn.err, run({"check", sample("broken/" + file)}).err);
}

void tst_CheckCommand::aMissingFileIsSaid() {
    const Finished finished = run({"check", "/no/such/file.toile"});
    QCOMPARE(finished.status, 1);
    QCOMPARE(finished.errorLines().size(), 1);
    QVERIFY(finished.err.startsWith("/no/such/file.toile: "));
}

void tst_CheckCommand::oneBrokenFileAmongSoundOnesIsEnough() {
    const Finished finished =
        run({"check", sample("two-squares.toile"), sample("broken/truncated.toile"), sample("tube.toile")});
    QCOMPARE(finished.status, 1);
    QCOMPARE(finished.errorLines().size(), 1);
}

void tst_CheckCommand::aNameDoesNotBreakTheLine() {
    const QTemporaryDir folder;
    const QString file = folder.filePath("names.toile");
    QByteArray text = contentOf(sample("two-squares.toile"));
    text.replace("\"name\": \"Left square\"", R"("name": "Left\nRight\u001b[31m \u009b31m Über")");
    text.replace(text.indexOf("\"x\": -150"), 9, "\"x\": -15e7"); // a problem that names the piece
    QFile written(file);
    QVERIFY(written.open(QIODevice::WriteOnly) && written.write(text) == text.size());
    written.close();
    const Finished checked = run({"check", file});
    QVERIFY2(checked.err.contains(R"(Left\nRight\u001b[31m \u009b31m Über)"), qPrintable(checked.err));
    for (const QString& line : checked.errorLines()) QVERIFY2(line.startsWith(file + ":"), qPrintable(line));
    for (const QString& command : {QStringLiteral("inspect"), QStringLiteral("mesh")}) {
        const Finished finished = run({command, file});
        QVERIFY(!(finished.out + finished.err).contains(QChar(0x1b)));
        QVERIFY(!(finished.out + finished.err).contains(QChar(0x9b)));
        QVERIFY((finished.out + finished.err).contains(R"(Left\nRight)"));
    }
}

void tst_CheckCommand::withoutAFileTheUsageIsWrong() {
    QCOMPARE(run({"check"}).status, 2);
}

TOILE_TEST(tst_CheckCommand, QCoreApplication)
#include "tst_CheckCommand.moc"
