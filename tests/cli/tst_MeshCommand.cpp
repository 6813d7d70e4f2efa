// SPDX-License-Identifier: GPL-3.0-or-later
#include "Png.h"
#include "Program.h"
#include "tests/Suite.h"

#include <QTemporaryDir>
#include <csignal>

using namespace toile;

namespace {

const QStringList pieceKeys{"nodes",
                            "slaves",
                            "quads",
                            "triangles",
                            "rectangles",
                            "rectangleFraction",
                            "minimumAngleDegrees",
                            "maximumAngleDegrees",
                            "inputMinimumAngleDegrees",
                            "maximumAspect",
                            "anglePercentilesDegrees",
                            "neighbourSizeRatio",
                            "grainAlignment",
                            "areaRelativeError",
                            "boundaryDeviation",
                            "invertedCells",
                            "missingBoundaryNodes",
                            "nonManifoldEdges",
                            "seconds",
                            "bytes",
                            "regions"};

double number(const Json& object, const char* key) {
    return *object.find(key)->asNumber();
}

} // namespace

class tst_MeshCommand : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { QVERIFY(folder_.isValid()); }
    void theReportHasTheKeysThatArePromised();
    void theSumOfThePiecesIsTheTotal();
    void theSpacingsOfTheSidesAreCompared();
    void everySampleIsSewnAlikeByEveryRule_data();
    void everySampleIsSewnAlikeByEveryRule();
    void mostCellsOfTheSampleGarmentsAreRectangles();
    void aTableIsPrintedForPeople();
    void onePieceAlone();
    void theMainMeshAlone();
    void anUnknownPieceIsNamed();
    void halfTheSpacingGivesAboutFourTimesTheCells();
    void everyFormatIsWritten_data();
    void everyFormatIsWritten();
    void noCornerLiesOnASideInAnObj();
    void regionBordersMayStayWhereTheyArePainted();
    void anotherFormatIsRefused();
    void aMissingFolderIsSaidAndNothingIsWritten();
    void namesMayEndInCapitals();
    void noResultTakesThePlaceOfTheDocumentOrOfAnother();
    void anInterruptStopsBetweenRepetitions();
    void wrongUsage_data();
    void wrongUsage();

private:
    [[nodiscard]] QString in(const char* name) const { return folder_.filePath(name); }
    [[nodiscard]] Json report(const QStringList& arguments) const {
        if (run(QStringList{"mesh"} + arguments + QStringList{"--report", in("mesh.json")}).status != 0) return {};
        return jsonOf(contentOf(in("mesh.json")));
    }
    QTemporaryDir folder_;
};

void tst_MeshCommand::theReportHasTheKeysThatArePromised() {
    const Json json = report({sample("blouse.toile"), "--repeat", "3"});
    QCOMPARE(missingKeys(json, {"pieces", "total", "seams", "warnings"}), QString());
    QCOMPARE(json.find("pieces")->asArray()->size(), std::size_t(7));
    for (const Json& piece : *json.find("pieces")->asArray()) {
        QCOMPARE(missingKeys(piece, pieceKeys + QStringList{"name"}), QString());
        for (const Json& region : *piece.find("regions")->asArray())
            QCOMPARE(missingKeys(region, {"name", "spacing", "ratio", "cells", "displacement", "areaChange"}),
                     QString());
    }
    QCOMPARE(missingKeys(*json.find("total"), pieceKeys), QString());
    QCOMPARE(json.find("seams")->asArray()->size(), std::size_t(21));
    for (const Json& seam : *json.find("seams")->asArray())
        QCOMPARE(missingKeys(seam, {"name", "countA", "countB", "lengthA", "lengthB", "ease", "largestSpacingMismatch",
                                    "equalLength", "equalCount", "equalUnitLength"}),
                 QString());
    for (const Json& warning : *json.find("warnings")->asArray())
        QCOMPARE(missingKeys(warning, {"place", "text"}), QString());
}

void tst_MeshCommand::theSumOfThePiecesIsTheTotal() {
    const Json json = report({sample("two-squares.toile")});
    for (const char* key : {"nodes", "quads", "triangles", "bytes"}) {
        double sum = 0;
        for (const Json& piece : *json.find("pieces")->asArray()) sum += number(piece, key);
        QCOMPARE(number(*json.find("total"), key), sum);
    }
    QCOMPARE(number(*json.find("total"), "quads"), 2 * 15.0 * 15.0); // squares of 0.3 m at 20 mm
    QCOMPARE(number(*json.find("total"), "invertedCells"), 0.0);
}

void tst_MeshCommand::theSpacingsOfTheSidesAreCompared() {
    const Json squares = report({sample("two-squares.toile")}); // straight, equally long edges
    QVERIFY(number(squares.find("seams")->asArray()->front(), "largestSpacingMismatch") < 1e-9);
    const Json blouse = report({sample("blouse.toile")});
    for (const Json& seam : *blouse.find("seams")->asArray()) {
        const double mismatch = number(seam, "largestSpacingMismatch");
        if (number(seam, "ease") == 0) QVERIFY(mismatch < 0.02); // chords of curves that bend differently
        else QVERIFY(mismatch > 0.01 && mismatch < 0.1);         // millimetres over some 13 cm of cap
    }
}

void tst_MeshCommand::everySampleIsSewnAlikeByEveryRule_data() {
    QTest::addColumn<QString>("file");
    QTest::addColumn<QString>("rule");
    for (const char* name : {"blouse", "t-shirt", "circle-skirt", "trousers", "tube", "two-squares"})
        for (const char* rule : {"regular", "features", "paper"})
            QTest::addRow("%s, %s", name, rule) << sample(QString("%1.toile").arg(name)) << QString(rule);
}

/// The three conditions of the paper, for every seam.
void tst_MeshCommand::everySampleIsSewnAlikeByEveryRule() {
    QFETCH(QString, file);
    QFETCH(QString, rule);
    const Json json = report({file, "--rule", rule});
    QVERIFY(!json.find("seams")->asArray()->empty());
    for (const Json& seam : *json.find("seams")->asArray())
        for (const char* key : {"equalLength", "equalCount", "equalUnitLength"})
            QVERIFY2(*seam.find(key)->asBool(), seam.find("name")->asString()->c_str());
    for (const char* key : {"invertedCells", "missingBoundaryNodes", "nonManifoldEdges"})
        QCOMPARE(number(*json.find("total"), key), 0.0);
}

void tst_MeshCommand::mostCellsOfTheSampleGarmentsAreRectangles() {
    const auto share = [this](const char* spacing) {
        double rectangles = 0, cells = 0;
        for (const char* name : {"blouse", "t-shirt", "trousers", "circle-skirt"}) {
            const Json json = report({sample(QString("%1.toile").arg(name)), "--spacing", spacing});
            const Json& total = *json.find("total");
            rectangles += number(total, "rectangles");
            cells += number(total, "quads") + number(total, "triangles");
        }
        return rectangles / cells;
    };
    QVERIFY(share("20") >= 0.80); // the goals of the mesher's specification
    QVERIFY(share("10") >= 0.90);
}

void tst_MeshCommand::aTableIsPrintedForPeople() {
    const Finished finished = run({"mesh", sample("two-squares.toile")});
    QCOMPARE(finished.status, 0);
    QVERIFY(finished.out.contains("Left square") && finished.out.contains("Right square"));
    QVERIFY(finished.err.isEmpty());
}

void tst_MeshCommand::onePieceAlone() {
    const Json json = report({sample("blouse.toile"), "--piece", "Cuff left"});
    QCOMPARE(json.find("pieces")->asArray()->size(), std::size_t(1));
}

void tst_MeshCommand::theMainMeshAlone() {
    const QStringList back{sample("blouse.toile"), "--piece", "Back", "--rule", "paper"};
    const Json with = report(back), without = report(back + QStringList{"--no-regions"});
    QCOMPARE(with.find("pieces")->asArray()->front().find("regions")->asArray()->size(), std::size_t(4));
    QVERIFY(without.find("pieces")->asArray()->front().find("regions")->asArray()->empty());
    QVERIFY(number(*without.find("total"), "nodes") < number(*with.find("total"), "nodes"));
    QCOMPARE(number(*without.find("total"), "slaves"), 0.0);
}

void tst_MeshCommand::anUnknownPieceIsNamed() {
    const Finished finished = run({"mesh", sample("blouse.toile"), "--piece", "Hood"});
    QCOMPARE(finished.status, 1);
    QVERIFY(finished.err.contains("There is no piece \"Hood\"."));
}

void tst_MeshCommand::halfTheSpacingGivesAboutFourTimesTheCells() {
    const double coarse = number(*report({sample("two-squares.toile"), "--spacing", "30"}).find("total"), "quads");
    const double fine = number(*report({sample("two-squares.toile"), "--spacing", "15"}).find("total"), "quads");
    QCOMPARE(fine, 4 * coarse); // both divide the square
}

void tst_MeshCommand::everyFormatIsWritten_data() {
    QTest::addColumn<QString>("file");
    for (const char* file : {"mesh.obj", "mesh.svg", "mesh.png"}) QTest::newRow(file) << file;
}

void tst_MeshCommand::everyFormatIsWritten() {
    QFETCH(QString, file);
    const QString path = folder_.filePath(file);
    const Finished finished = run({"mesh", sample("two-squares.toile"), "--out", path});
    QVERIFY2(finished.status == 0, qPrintable(finished.err));
    const QByteArray content = contentOf(path);
    if (file.endsWith(".obj")) {
        QCOMPARE(content.count("\nv "), 2 * 16 * 16);
        QCOMPARE(content.count("\nf "), 2 * 15 * 15);
    } else if (file.endsWith(".svg")) {
        QVERIFY(content.contains("<svg") && content.trimmed().endsWith("</svg>"));
    } else {
        QVERIFY(coloursIn(path) > 2); // paper, lines and fill at least
    }
}

/// Where coarse cells meet fine ones, other programs shall see no crack: every inner side belongs to two faces.
void tst_MeshCommand::noCornerLiesOnASideInAnObj() {
    const QStringList back{"mesh", sample("blouse.toile"), "--piece", "Back"};
    QCOMPARE(run(back + QStringList{"--out", in("back.obj"), "--report", in("back.json")}).status, 0);
    const Json total = *jsonOf(contentOf(in("back.json"))).find("total");
    QVERIFY(number(total, "slaves") > 0);
    std::map<std::pair<int, int>, int> faces; // by directed side
    int corners = 0;
    for (const QByteArray& line : contentOf(in("back.obj")).split('\n')) {
        if (!line.startsWith("f ")) continue;
        const QList<QByteArray> nodes = line.mid(2).split(' ');
        for (qsizetype i = 0; i < nodes.size(); ++i)
            QVERIFY(++faces[std::pair(nodes[i].toInt(), nodes[(i + 1) % nodes.size()].toInt())] == 1);
        corners += nodes.size() == 4;
    }
    QVERIFY(corners > 100); // cells without a slave stay whole
    int border = 0;
    for (const auto& [side, count] : faces) border += !faces.contains({side.second, side.first});
    std::map<int, int> used;
    for (const auto& [side, count] : faces) ++used[side.first];
    QCOMPARE(double(used.size()), number(total, "nodes"));
    QCOMPARE(int(used.size()) - int(faces.size() + border) / 2 + int(contentOf(in("back.obj")).count("\nf ")),
             -1); // Euler's number of a piece with two darts cut out
}

void tst_MeshCommand::regionBordersMayStayWhereTheyArePainted() {
    const QStringList back{sample("blouse.toile"), "--piece", "Back", "--border"};
    const auto largest = [](const Json& json) {
        double displacement = 0;
        for (const Json& region : *json.find("pieces")->asArray()->front().find("regions")->asArray())
            displacement = std::max(displacement, number(region, "displacement"));
        return displacement;
    };
    const double snapped = largest(report(back + QStringList{"snap"})),
                 kept = largest(report(back + QStringList{"exact"}));
    QVERIFY(snapped > 1e-3 && kept < snapped);
}

void tst_MeshCommand::anotherFormatIsRefused() {
    const Finished finished = run({"mesh", sample("two-squares.toile"), "--out", in("mesh.step")});
    QCOMPARE(finished.status, 1);
    QVERIFY(finished.err.contains(".obj, .svg, .png"));
    QVERIFY(!QFile::exists(in("mesh.step")));
}

void tst_MeshCommand::aMissingFolderIsSaidAndNothingIsWritten() {
    const QString out = in("only.obj"), lost = folder_.filePath("none/mesh.json");
    const Finished finished = run({"mesh", sample("two-squares.toile"), "--out", out, "--report", lost});
    QCOMPARE(finished.status, 1);
    QCOMPARE(finished.errorLines().size(), 1);
    QVERIFY(finished.err.contains("There is no folder"));
    QVERIFY(!QFile::exists(out) && !QFile::exists(lost)); // not half of the results
}

void tst_MeshCommand::namesMayEndInCapitals() {
    for (const char* file : {"MESH.OBJ", "MESH.SVG", "MESH.PNG"}) {
        QCOMPARE(run({"mesh", sample("two-squares.toile"), "--out", in(file)}).status, 0);
        QVERIFY(!contentOf(in(file)).isEmpty());
    }
}

void tst_MeshCommand::noResultTakesThePlaceOfTheDocumentOrOfAnother() {
    QVERIFY(QFile::copy(sample("two-squares.toile"), in("mine.toile")));
    QCOMPARE(run({"mesh", in("mine.toile"), "--report", in("mine.toile")}).status, 1);
    QCOMPARE(contentOf(in("mine.toile")), contentOf(sample("two-squares.toile")));
    const Finished twice = run({"mesh", in("mine.toile"), "--out", in("same.obj"), "--report", in("same.obj")});
    QCOMPARE(twice.status, 1);
    QVERIFY2(twice.err.contains("Two results"), qPrintable(twice.err));
    QVERIFY(!QFile::exists(in("same.obj")));
}

void tst_MeshCommand::anInterruptStopsBetweenRepetitions() {
    QProcess process; // for minutes
    process.start(program(),
                  {"mesh", sample("blouse.toile"), "--spacing", "2", "--repeat", "1000", "--report", in("no.json")});
    QVERIFY(process.waitForStarted());
    QTest::qWait(1000); // a process of a moment would know no signals yet
    QCOMPARE(process.state(), QProcess::Running);
    ::kill(static_cast<pid_t>(process.processId()), SIGINT);
    QVERIFY(process.waitForFinished(30000));
    QCOMPARE(process.exitStatus(), QProcess::NormalExit);
    QCOMPARE(process.exitCode(), 1);
    QVERIFY(process.readAllStandardError().contains("stopped"));
    QVERIFY(!QFile::exists(in("no.json")));
}

void tst_MeshCommand::wrongUsage_data() {
    QTest::addColumn<QStringList>("options");
    QTest::newRow("an unknown option") << QStringList{"--fast"};
    QTest::newRow("a spacing below zero") << QStringList{"--spacing", "-20"};
    QTest::newRow("a spacing that is no number") << QStringList{"--spacing", "wide"};
    QTest::newRow("an unknown rule") << QStringList{"--rule", "random"};
    QTest::newRow("an unknown border") << QStringList{"--border", "soft"};
    QTest::newRow("a piece without a name") << QStringList{"--piece", ""};
    QTest::newRow("no run at all") << QStringList{"--repeat", "0"};
}

void tst_MeshCommand::wrongUsage() {
    QFETCH(QStringList, options);
    const Finished finished = run(QStringList{"mesh", sample("two-squares.toile")} + options);
    QCOMPARE(finished.status, 2);
    QVERIFY(!finished.err.isEmpty());
}

TOILE_TEST(tst_MeshCommand, QCoreApplication)
#include "tst_MeshCommand.moc"
