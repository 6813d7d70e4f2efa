// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/Suite.h"
#include "tests/cli/Program.h"

#include <QStandardPaths>

using namespace toile;

class tst_StudyCommand : public QObject {
    Q_OBJECT
private slots:
    void aStudyLeavesItsReport();
    void aSceneThatIsNotThereIsSaid();
    void aGarmentIsStudiedWithASuggestion();
    void withoutAGarmentNothingIsSuggested();
    void anErrorThatIsNoNumberIsRefused();
    void aDocumentWithoutRegionsIsSaid();
    void storageIsPrintedAndWritten();
    void aBoxThatIsNoneIsSaid();
    void casesAreRunByTheirNumbers();
    void extremesAreRunByTheirNumbers();
    void theMapOfStiffnessIsDrawn();
    void partsOfAStepAreRunByTheirNames();
    void instructionsAreCountedOrTheReasonIsSaid();
    void scenesStandBesideTheirGoals();
    void aStudyThatWasStoppedGoesOn();
    void recordsThatNobodyAskedForAreKept();
    void recordsOfTooFewOrNoisyRunsDoNotStand();
    void reportsAreCompared();
    void namesThatAreTooLongAreSaid();
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
    const QString page = QString::fromUtf8(contentOf(out + "/report.html"));
    QVERIFY(page.startsWith("<!DOCTYPE html>"));
    QVERIFY(page.contains("<title>Error against run time</title>"));
    QVERIFY(page.contains("<h2>oscillator</h2>"));
    QVERIFY(page.contains("<img src=\"oscillator.svg\""));
    QCOMPARE(page.count("<tr>"), report.count("\n|") - page.count("<table>")); // all but the lines below the headings
}

void tst_StudyCommand::aSceneThatIsNotThereIsSaid() {
    const QTemporaryDir folder;
    const Finished finished = run({"study", "accuracy", "skirt", "--out", folder.filePath("study")});
    QCOMPARE(finished.status, 1);
    QCOMPARE(finished.err, QString("There is no scene \"skirt\"; there are oscillator, flap, two-corners.\n"));
    QVERIFY(!QFile::exists(folder.filePath("study")));
}

void tst_StudyCommand::aGarmentIsStudiedWithASuggestion() {
    const QTemporaryDir folder;
    const QString out = folder.filePath("tube");
    const Finished finished =
        run({"study", "accuracy", sample("tube.toile"), "--within", "5", "--quiet", "--out", out});
    QCOMPARE(finished.err, QString());
    QCOMPARE(finished.status, 0);
    QVERIFY(finished.out.contains("7 meshes and methods, each 2 times, against 5 references")); // it has no regions
    const QString report = QString::fromUtf8(contentOf(out + "/report.md"));
    QVERIFY(report.contains("# Error against run time: tube"));
    QVERIFY(report.contains("tube.toile --quick --within 5 --out " + out + "`"));
    for (const QByteArray& line : contentOf(out + "/results.jsonl").trimmed().split('\n'))
        QVERIFY(missingKeys(jsonOf(line), {"schema", "scene", "method", "status"}).isEmpty());
    QCOMPARE(contentOf(out + "/accuracy.svg").isEmpty(), finished.out.contains("without pictures"));
}

void tst_StudyCommand::anErrorThatIsNoNumberIsRefused() {
    const QTemporaryDir folder;
    for (const char* value : {"nan", "0", "inf"}) {
        const Finished finished =
            run({"study", "accuracy", sample("tube.toile"), "--within", value, "--out", folder.filePath("study")});
        QCOMPARE(finished.status, 2);
        QVERIFY2(finished.err.contains("--within"), qPrintable(finished.err));
    }
}

void tst_StudyCommand::withoutAGarmentNothingIsSuggested() {
    const QTemporaryDir folder;
    const Finished finished = run({"study", "accuracy", "flap", "--within", "5", "--out", folder.path()});
    QCOMPARE(finished.status, 1);
    QCOMPARE(finished.err, QString("A setting can be suggested for a document's garment: name one file.\n"));
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
    QCOMPARE(run({"study", "storage", file, "--fine", "Skirt left=nan,0,1,1", "--out", folder.path()}).status, 2);
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
    QVERIFY(finished.out.contains("3 PASS, 0 PASS-WARN, 13 REFUSED, 0 FAIL."));
    const auto lines = contentOf(out + "/results.jsonl").split('\n');
    QCOMPARE(lines.size(), 16 + 1); // the last ends with a line end
    for (const QByteArray& line : lines.first(16))
        QVERIFY(missingKeys(jsonOf(line), {"schema", "program", "machine", "case", "verdict"}).isEmpty());
    QVERIFY(contentOf(out + "/report.md").contains("Particle 1 has no mass."));
    QCOMPARE(run({"study", "stability", "--only", "S99"}).status, 1);
}

void tst_StudyCommand::theMapOfStiffnessIsDrawn() {
    const QTemporaryDir folder;
    const QString out = folder.filePath("map");
    const Finished finished = run({"study", "stability", "--quick", "--only", "S1", "--out", out});
    QCOMPARE(finished.status, 0);
    for (const char* picture : {"/stiffness-map.svg", "/stiffness-map.png"})
        QCOMPARE(contentOf(out + picture).isEmpty(), finished.out.contains("without pictures"));
}

void tst_StudyCommand::partsOfAStepAreRunByTheirNames() {
    const QTemporaryDir folder;
    const QString out = folder.filePath("lean");
    const Finished finished = run({"study", "lean", "hands", sample("two-squares.toile"), "--quiet", "--out", out});
    QCOMPARE(finished.err, QString());
    QCOMPARE(finished.status, 0);
    QVERIFY(finished.out.contains("7 of 7 rows pass."));
    const auto lines = contentOf(out + "/results.jsonl").split('\n');
    QCOMPARE(lines.size(), 7 + 1); // the last ends with a line end
    for (const QByteArray& line : lines.first(7))
        QVERIFY(missingKeys(jsonOf(line), {"schema", "program", "machine", "scene", "method", "cost", "verdict"})
                    .isEmpty());
    QVERIFY(contentOf(out + "/report.md").contains("| two-squares | in use | with self-contact |"));

    const Finished none = run({"study", "lean", "gloves", "--out", out});
    QCOMPARE(none.status, 1);
    QVERIFY(none.err.contains("\"gloves\" is neither a document nor a feature; there are wind, pressure, seams, "));
}

void tst_StudyCommand::instructionsAreCountedOrTheReasonIsSaid() {
    const QTemporaryDir folder;
    const Finished finished =
        run({"study", "lean", "pins", "--count", "--repetitions", "1", "--quiet", "--out", folder.filePath("lean")});
    if (QStandardPaths::findExecutable("valgrind").isEmpty()) {
        QCOMPARE(finished.status, 1);
        QVERIFY(finished.err.contains("Debian's valgrind"));
        return;
    }
    QCOMPARE(finished.err, QString());
    QCOMPARE(finished.status, 0);
    const auto lines = contentOf(folder.filePath("lean/results.jsonl")).split('\n');
    QCOMPARE(lines.size(), 2 + 1); // the last ends with a line end
    for (const QByteArray& line : lines.first(2))
        QVERIFY(*jsonOf(line).find("cost")->find("instructions")->asNumber() > 1e5); // of 256 particles in a frame step
    QVERIFY(contentOf(folder.filePath("lean/report.md")).contains("counted by valgrind"));
    QVERIFY(!QFile::exists(folder.filePath("lean/counted")));
}

void tst_StudyCommand::scenesStandBesideTheirGoals() {
    const QTemporaryDir folder;
    const QString out = folder.filePath("scenes");
    const QStringList command{"study", "scenes", "tunic", "--quick", "--repetitions", "1", "--quiet", "--out", out};
    const Finished finished = run(command);
    QCOMPARE(finished.err, QString());
    QVERIFY(finished.status == 0 || finished.out.contains("Missed: tunic")); // how fast it is depends on the build
    const QString report = QString::fromUtf8(contentOf(out + "/report.md"));
    QVERIFY(report.contains("`toile-cli study scenes tunic --quick --repetitions 1 --out " + out + "`"));
    QVERIFY(report.contains("| 0 ≤ 0 | 0 ≤ 0 | 0 ≤ 0 | 0 ≤ 0 |")); // closed, outside, and clear of itself
    QVERIFY(missingKeys(jsonOf(contentOf(out + "/results.jsonl")),
                        {"schema", "program", "machine", "scene", "method", "result", "goal", "cost", "verdict"})
                .isEmpty());
    QVERIFY(run(command).out.contains("1 of 1 records stood in"));

    const Finished none = run({"study", "scenes", "trousers", "--out", out});
    QCOMPARE(none.status, 1);
    QVERIFY(none.err.contains("There is no scene \"trousers\"; there are flap, hanging, "));
}

void tst_StudyCommand::aStudyThatWasStoppedGoesOn() {
    const QTemporaryDir folder;
    const QString out = folder.filePath("lean"), records = out + "/results.jsonl";
    const auto lean = [&](const QStringList& more) {
        const Finished finished = // once: what is noisy would be measured again
            run(QStringList{"study", "lean"} + more + QStringList{"--repetitions", "1", "--quiet", "--out", out});
        if (finished.status != 0) qWarning("%s", qPrintable(finished.err));
        return finished.out;
    };
    QVERIFY(!lean({"hands"}).contains("already"));
    const QByteArray first = contentOf(records);
    QCOMPARE(first.count('\n'), 4);
    QFile file(records);
    QVERIFY(file.open(QIODevice::Append));
    QVERIFY(file.write("{\"schema\":\"toile-lean-1\",\"pro") > 0); // as a kill leaves it
    file.close();
    QVERIFY(lean({"hands", "pins"}).contains("4 of 6 records stood in"));
    QVERIFY(contentOf(records).startsWith(first)); // the same lines, not measured again
    QCOMPARE(contentOf(records).count('\n'), 6);
    QVERIFY(contentOf(out + "/report.md").contains("| hands | in use | one hand |"));
    QVERIFY(!lean({"hands", "pins", "--fresh"}).contains("already"));
    QVERIFY(!contentOf(records).startsWith(first));

    const QString accuracy = folder.filePath("accuracy");
    const QStringList command{"study", "accuracy", "oscillator", "--quiet", "--out", accuracy};
    QCOMPARE(run(command).status, 0);
    const QByteArray report = contentOf(accuracy + "/results.jsonl");
    const Finished again = run(command);
    QVERIFY(again.out.contains("40 of 40 records stood in"));
    QCOMPARE(contentOf(accuracy + "/results.jsonl"), report);
}

void tst_StudyCommand::recordsThatNobodyAskedForAreKept() {
    const QTemporaryDir folder;
    const QString records = folder.filePath("results.jsonl"), old = folder.filePath("results.old.jsonl");
    const auto lean = [&](const QStringList& more) {
        return run(QStringList{"study", "lean"} + more +
                   QStringList{"--repetitions", "1", "--quiet", "--out", folder.path()})
            .out;
    };
    lean({"hands", "pins"});
    const QList<QByteArray> all = contentOf(records).trimmed().split('\n');
    QCOMPARE(all.size(), 6);
    QVERIFY(lean({"pins"}).contains("2 of 2 records stood in"));
    QCOMPARE(contentOf(records).trimmed().split('\n'), all.mid(4) + all.first(4)); // those of pins first
    QVERIFY(lean({"hands"}).contains("4 of 4 records stood in"));
    QVERIFY(!QFile::exists(old));

    const QByteArray older = contentOf(records).replace("\"program\": \"toile-cli ", "\"program\": \"toile-cli 0.0.");
    QFile file(records);
    QVERIFY(file.open(QIODevice::WriteOnly) && file.write(older) == older.size());
    file.close();
    QVERIFY(!lean({"pins"}).contains("already"));
    QCOMPARE(contentOf(old), older);
    QCOMPARE(contentOf(records).count('\n'), 2);
    const QByteArray newer = contentOf(records);
    QVERIFY(!lean({"pins", "--fresh"}).contains("already"));
    QCOMPARE(contentOf(old).count('\n'), 6); // the newer ones of pins took the place of the older
    for (const QByteArray& line : newer.trimmed().split('\n')) QVERIFY(contentOf(old).contains(line));
}

void tst_StudyCommand::recordsOfTooFewOrNoisyRunsDoNotStand() {
    const QTemporaryDir folder;
    const QString records = folder.filePath("results.jsonl");
    const auto stands = [&](const char* repetitions) {
        return run({"study", "lean", "pins", "--repetitions", repetitions, "--quiet", "--out", folder.path()})
            .out.contains("2 of 2 records stood in");
    };
    const auto replace = [&](const char* before, const char* after) {
        const QByteArray text = contentOf(records).replace(before, after);
        QFile file(records);
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write(text) == text.size());
        QCOMPARE(text.count(after), 2);
    };
    QVERIFY(!stands("1"));
    QVERIFY(stands("1"));
    QVERIFY(!stands("2"));
    QVERIFY(QFile::remove(records));
    QVERIFY(!stands("1"));
    replace("\"repetitions\": 1", "\"repetitions\": 3"); // as if; three may be noisy
    QVERIFY(stands("2"));
    QVERIFY(stands("3"));
    replace("\"repetitions\": 3", "\"repetitions\": 3, \"noisy\": true");
    QVERIFY(!stands("1"));
    QVERIFY(stands("1"));
}

void tst_StudyCommand::reportsAreCompared() {
    const QTemporaryDir folder;
    const auto written = [&](const QString& name, const QByteArray& verdict) {
        QFile file(folder.filePath(name));
        if (!file.open(QIODevice::WriteOnly)) qFatal("no file");
        file.write("{\"schema\":\"toile-validation-1\",\"case\":\"V3\",\"what\":\"sag\",\"measured\":1,\"verdict\":\"" +
                   verdict + "\"}\n");
        return file.fileName();
    };
    const QString good = written("good.jsonl", "PASS"), bad = written("bad.jsonl", "FAIL");
    const Finished same = run({"study", "compare", good, good}), worse = run({"study", "compare", good, bad}),
                   better = run({"study", "compare", bad, good});
    QCOMPARE(same.status, 0);
    QCOMPARE(worse.status, 3);
    QCOMPARE(worse.err, QString());
    QVERIFY(worse.out.contains("worse  V3, sag: verdict PASS → FAIL"));
    QCOMPARE(better.status, 0);
    QCOMPARE(run({"study", "compare", good, folder.filePath("none")}).status, 1);
    QCOMPARE(run({"study", "compare", good}).status, 2);
}

void tst_StudyCommand::namesThatAreTooLongAreSaid() {
    const QTemporaryDir folder;
    const QString longName(300, 'a');
    for (const QStringList& command : {QStringList{"study", "compare", longName, longName},
                                       QStringList{"study", "lean", longName, "--out", folder.filePath("lean")}}) {
        const Finished finished = run(command);
        QCOMPARE(finished.status, 1);
        QCOMPARE(finished.errorLines().size(), 1);
    }
}

TOILE_TEST(tst_StudyCommand)
#include "tst_StudyCommand.moc"
