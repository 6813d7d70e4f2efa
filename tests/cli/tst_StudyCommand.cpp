// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/cli/Program.h"

using namespace toile;

class tst_StudyCommand : public QObject {
    Q_OBJECT
private slots:
    void aStudyLeavesItsReport();
    void aSceneThatIsNotThereIsSaid();
    void aDocumentWithoutRegionsIsSaid();
    void storageIsPrintedAndWritten();
    void aBoxThatIsNoneIsSaid();
    void casesAreRunByTheirNumbers();
    void extremesAreRunByTheirNumbers();
};

void tst_StudyCommand::aStudyLeavesItsReport() {
    const QTemporaryDir folder;
    const QString out = folder.filePath("study");
    const Finished finished = run({"study", "accuracy", "oscillator", "--quiet", "--out", out});
    QCOMPARE(finished.err, QString());
    QCOMPARE(finished.status, 0);
    const QString report = QString::fromUtf8(contentOf(out + "/report.md"));
    QVERIFY(report.contains("## oscillator"));
    QVERIFY(report.contains("`toile-cli study accuracy oscillator --quick --out " + out + "`"));
    const auto lines = contentOf(out + "/results.jsonl").split('\n');
    QCOMPARE(lines.size(), 40 + 1); // the last ends with a line end
    for (const QByteArray& line : lines.first(40)) QVERIFY(jsonOf(line).find("result"));
    QVERIFY(!contentOf(out + "/oscillator.gp").isEmpty());
    QCOMPARE(contentOf(out + "/oscillator.svg").isEmpty(), finished.out.contains("without pictures"));
}

void tst_StudyCommand::aSceneThatIsNotThereIsSaid() {
    const QTemporaryDir folder;
    const Finished finished = run({"study", "accuracy", "skirt", "--out", folder.filePath("study")});
    QCOMPARE(finished.status, 1);
    QCOMPARE(finished.err, QString("There is no scene \"skirt\"; there are oscillator, flap, two-corners.\n"));
    QVERIFY(!QFile::exists(folder.filePath("study")));
}

void tst_StudyCommand::aDocumentWithoutRegionsIsSaid() {
    const QTemporaryDir folder;
    const Finished finished =
        run({"study", "regions", sample("sheet-one-edge.toile"), "--quiet", "--out", folder.path()});
    QCOMPARE(finished.status, 1);
    QVERIFY(finished.err.contains("sheet-one-edge.toile: The pattern has no region that is finer than its piece"));
    QCOMPARE(finished.errorLines().size(), 1);
}

void tst_StudyCommand::storageIsPrintedAndWritten() {
    const QTemporaryDir folder;
    const Finished finished = run({"study", "storage", sample("circle-skirt.toile"), "--fine", "Skirt left=0,0,1,0.3",
                                   "--fine", "Skirt left=0,0.7,1,1", "--out", folder.filePath("storage")});
    QCOMPARE(finished.err, QString());
    QCOMPARE(finished.status, 0);
    QVERIFY(finished.out.contains("--fine \"Skirt left=0,0,1,0.3\" --fine \"Skirt left=0,0.7,1,1\""));
    QCOMPARE(QString::fromUtf8(contentOf(folder.filePath("storage/report.md"))), finished.out);
    const auto lines = contentOf(folder.filePath("storage/results.jsonl")).split('\n');
    QCOMPARE(lines.size(), 3 + 1); // the last ends with a line end
    for (const QByteArray& line : lines.first(3))
        QVERIFY(missingKeys(jsonOf(line), {"schema", "program", "machine", "scene", "method", "cost"}).isEmpty());
}

void tst_StudyCommand::aBoxThatIsNoneIsSaid() {
    const QTemporaryDir folder;
    const QString file = sample("circle-skirt.toile");
    QCOMPARE(run({"study", "storage", file, "--fine", "Skirt left", "--out", folder.path()}).status, 2);
    QCOMPARE(run({"study", "storage", file, "--fine", "Skirt left=0,0,1", "--out", folder.path()}).status, 2);
    const Finished finished = run({"study", "storage", file, "--fine", "Hem=0,0,1,1", "--out", folder.path()});
    QCOMPARE(finished.status, 1);
    QVERIFY(finished.err.contains("There is no piece \"Hem\"."));
}

void tst_StudyCommand::casesAreRunByTheirNumbers() {
    const QTemporaryDir folder;
    const QString out = folder.filePath("validation");
    const Finished finished = run({"study", "validation", "--only", "V3,V18,V14", "--out", out});
    QCOMPARE(finished.err, QString());
    QCOMPARE(finished.status, 0);
    QVERIFY(finished.out.contains("7 of 7 rows pass. Not offered: V14."));
    const auto lines = contentOf(out + "/results.jsonl").split('\n');
    QCOMPARE(lines.size(), 8 + 1); // the last ends with a line end
    for (const QByteArray& line : lines.first(8))
        QVERIFY(missingKeys(jsonOf(line), {"schema", "program", "machine", "case", "verdict"}).isEmpty());
    QVERIFY(contentOf(out + "/report.md").contains("| V14 |"));

    const Finished none = run({"study", "validation", "--only", "V3,V99"});
    QCOMPARE(none.status, 1);
    QVERIFY(none.err.contains("There is no validation case \"V99\"."));
}

void tst_StudyCommand::extremesAreRunByTheirNumbers() {
    const QTemporaryDir folder;
    const QString out = folder.filePath("stability");
    const Finished finished = run({"study", "stability", "--quick", "--only", "S2,S4,S21,S30", "--out", out});
    QCOMPARE(finished.err, QString());
    QCOMPARE(finished.status, 0);
    QVERIFY(finished.out.contains("2 PASS, 0 PASS-WARN, 13 REFUSED, 0 FAIL; 1 case not run."));
    const auto lines = contentOf(out + "/results.jsonl").split('\n');
    QCOMPARE(lines.size(), 16 + 1); // the last ends with a line end
    for (const QByteArray& line : lines.first(16))
        QVERIFY(missingKeys(jsonOf(line), {"schema", "program", "machine", "case", "verdict"}).isEmpty());
    QVERIFY(contentOf(out + "/report.md").contains("Particle 1 has no mass."));
    QCOMPARE(run({"study", "stability", "--only", "S99"}).status, 1);
}

QTEST_APPLESS_MAIN(tst_StudyCommand)
#include "tst_StudyCommand.moc"
