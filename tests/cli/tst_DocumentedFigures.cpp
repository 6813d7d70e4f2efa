// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/Suite.h"
#include "tests/cli/Program.h"

#include <QTemporaryDir>
#include <cmath>

using namespace toile;

namespace {

/// Of all pieces together, as `toile-cli mesh` reports it.
struct Meshed {
    double rectangles = 0, elements = 0; ///< elements: rectangles, other quadrilaterals and triangles
    double leastAngle = 0;               ///< [°]
};

Meshed meshed(const QString& garment, const QString& spacing) {
    const QTemporaryDir folder;
    const QString report = folder.filePath("mesh.json");
    const Finished finished = run({"mesh", sample(garment + ".toile"), "--spacing", spacing, "--report", report});
    if (finished.status != 0) return {};
    const Json json = jsonOf(contentOf(report));
    const Json* total = json.find("total");
    const auto number = [&](const char* key) { return *total->find(key)->asNumber(); };
    return {number("rectangles"), number("quads") + number("triangles"), number("minimumAngleDegrees")};
}

constexpr int minute = 60000; // [ms]

/// "72.1 %" as it would be printed from a share.
QString percent(double share) {
    return QString::number(100 * share, 'f', 1) + " %";
}

} // namespace

/// Figures of the documentation that are cheap to have again, and do not depend on the machine, are made again by the
/// commands that the pages name.
class tst_DocumentedFigures : public QObject {
    Q_OBJECT
private slots:
    void samplesHaveTheRectanglesThatThePageSays();
    void theBackThatIsTimedHasTheMeshThatThePageSays();
    void regionsSaveWhatThePageSays();
    void rulesMeshTheBackAsThePageSays();
    void regionsOverTheRodAreAsNearAsThePageSays();
    void positionBasedStepsAreAsFarOffAsThePageSays();
};

void tst_DocumentedFigures::samplesHaveTheRectanglesThatThePageSays() {
    const auto rows = tableIn(page("meshing.md"), "sample | rectangles at 20 mm | at 10 mm");
    QCOMPARE(rows.size(), 5);
    for (const int column : {1, 2}) {
        double rectangles = 0, elements = 0;
        for (const QStringList& row : rows.first(4)) {
            const Meshed found = meshed(row[0], column == 1 ? "20" : "10");
            QCOMPARE(percent(found.rectangles / found.elements), row[column]);
            QCOMPARE(QString::number(found.leastAngle, 'f', 1) + "°", row[column + 2]);
            rectangles += found.rectangles;
            elements += found.elements;
        }
        QCOMPARE(percent(rectangles / elements), rows[4][column]);
    }
}

/// What `./dev bench` meshes is what this command does.
void tst_DocumentedFigures::theBackThatIsTimedHasTheMeshThatThePageSays() {
    const QString text = page("meshing.md");
    static const QRegularExpression ofTheStrip(R"(rims, ([\d ]+) at 5 mm .* were all of them paired, (\S+), (\S+) and )"
                                               R"((\S+) % would be rectangles)",
                                               QRegularExpression::DotMatchesEverythingOption);
    const auto strip = ofTheStrip.match(text);
    QVERIFY(strip.hasMatch());
    const auto rows = tableIn(text, "spacing | cells | rectangles | least angle | warm");
    QCOMPARE(rows.size(), 6);
    for (const QStringList& row : rows.first(5)) { // the sixth takes gigabytes
        const QTemporaryDir folder;
        const QString report = folder.filePath("mesh.json"), spacing = row[0].section(' ', 0, 0);
        const Finished finished = run({"mesh", sample("blouse.toile"), "--piece", "Back", "--no-regions", "--spacing",
                                       spacing, "--report", report});
        QCOMPARE(finished.status, 0);
        const Json json = jsonOf(contentOf(report));
        const auto number = [&](const char* key) { return *json.find("total")->find(key)->asNumber(); };
        const double quads = number("quads"), triangles = number("triangles"), rectangles = number("rectangles");
        QCOMPARE(QString(row[1]).remove(' ').toDouble(), quads + triangles);
        QCOMPARE(percent(number("rectangleFraction")), row[2]);
        QCOMPARE(QString::number(number("minimumAngleDegrees"), 'f', 1) + "°", row[3]);
        const QString paired = QString::number(100 * rectangles / (quads + 0.5 * triangles), 'f', 1);
        if (spacing == "5") {
            QCOMPARE(strip.captured(1).remove(' ').toDouble(), 2 * (quads - rectangles) + triangles);
            QCOMPARE(strip.captured(2), paired);
        }
        if (spacing == "2") QCOMPARE(strip.captured(3), paired);
        if (spacing == "1") QCOMPARE(strip.captured(4), paired);
    }
}

void tst_DocumentedFigures::regionsSaveWhatThePageSays() {
    const QString text = page("meshing.md");
    const auto commands = commandsIn(text, "study storage");
    const auto rows = tableIn(text, "garment | spacing | nodes | springs | bending | membranes");
    QCOMPARE(commands.size(), 3);
    QCOMPARE(rows.size(), 3 * commands.size());
    for (qsizetype i = 0; i < commands.size(); ++i) {
        const QTemporaryDir folder;
        QStringList arguments = commands[i];
        arguments.replace(arguments.indexOf("DIR"), folder.path());
        arguments[2] = qEnvironmentVariable("TOILE_SOURCE_DIR") + "/" + arguments[2];
        QCOMPARE(run(arguments).err, QString());
        const auto found = tableIn(QString::fromUtf8(contentOf(folder.filePath("report.md"))), "layout");
        QCOMPARE(found.size(), 3);
        for (qsizetype k = 0; k < 3; ++k) {
            const QStringList &written = rows[3 * i + k], &made = found[k];
            // written: garment, spacing, nodes, springs, bending, membranes, KiB of mesh + cloth, bytes a cell
            // made: layout, spacing, nodes, slaves, cells, springs, bending, membranes, mesh KiB, cloth KiB, bytes
            QCOMPARE(written[2], made[2]);
            if (!written[3].contains("knit") && written[3] != "0") QCOMPARE(written[3], made[5]);
            else QCOMPARE(made[5], QString("0"));
            QCOMPARE(written[4], made[6]);
            QCOMPARE(written[5], made[7]);
            QCOMPARE(written[6], made[8] + " + " + made[9]);
            QCOMPARE(written[7], made[10]);
        }
    }
}

void tst_DocumentedFigures::rulesMeshTheBackAsThePageSays() {
    const auto rows = tableIn(page("meshing-paper.md"), "rule | nodes | slaves | cells | rectangles");
    QCOMPARE(rows.size(), 3);
    for (const QStringList& row : rows) {
        const QTemporaryDir folder;
        const QString report = folder.filePath("mesh.json"), rule = QString(row[0]).remove('`');
        const Finished finished = run(
            {"mesh", sample("blouse.toile"), "--piece", "Back", "--spacing", "40", "--rule", rule, "--report", report});
        QCOMPARE(finished.status, 0);
        const Json json = jsonOf(contentOf(report));
        const auto number = [&](const char* key) { return *json.find("total")->find(key)->asNumber(); };
        QCOMPARE(QString::number(number("nodes")), row[1]);
        QCOMPARE(QString::number(number("slaves")), row[2]);
        QCOMPARE(QString::number(number("quads") + number("triangles")), row[3]);
        QCOMPARE(percent(number("rectangleFraction")), row[4]);
        QCOMPARE(QString::number(number("minimumAngleDegrees"), 'f', 1) + "°", row[5]);
        // printed: piece, nodes, quads, triangles, rectangles, grain, least angle, 1 %, 5 % …
        const QString all = finished.out.section("\nall ", 1).section('\n', 0, 0).simplified();
        QCOMPARE(all.section(' ', 7, 7) + "°", row[6]);
    }
}

void tst_DocumentedFigures::regionsOverTheRodAreAsNearAsThePageSays() {
    const QString text = page("regions.md");
    const auto rows = tableIn(text, "layout | least spacing mm | particles | CPU s to the drape | rms mm");
    QCOMPARE(rows.size(), 6);
    const QTemporaryDir folder;
    const QStringList command{"study", "regions", sample("finer-over-rod.toile"), "--full", "--out", folder.path()};
    QCOMPARE(run(command, 5 * minute).status, 0);
    const auto found = tableIn(QString::fromUtf8(contentOf(folder.filePath("report.md"))), "layout | least spacing mm");
    QCOMPARE(found.size(), rows.size() + 1); // and the reference
    for (qsizetype i = 0; i < rows.size(); ++i) {
        // written: layout, spacing, particles, CPU s, rms, largest
        // made: layout, spacing, particles, springs, KiB, CPU s, median, rms, largest, strain, energy, at rest
        const QStringList written = QStringList(rows[i]).replaceInStrings("**", ""), &made = found[i];
        const QByteArray name = written[0].toUtf8();
        QCOMPARE(written.first(3), made.first(3));
        for (const auto& [page, report] : {std::pair{4, 7}, {5, 8}}) {
            const double said = written[page].toDouble(), seen = made[report].toDouble();
            QVERIFY2(std::abs(seen - said) <= 0.05 * said, name + ": " + made[report].toUtf8()); // of two digits
        }
    }
}

void tst_DocumentedFigures::positionBasedStepsAreAsFarOffAsThePageSays() {
    static const QRegularExpression said(
        R"(it is (\S+) mm off at the smallest step tried, 0\.3 ms, .*wrong by centimetres\*\*: (\d+) to (\d+) mm)",
        QRegularExpression::DotMatchesEverythingOption);
    const auto figures = said.match(page("accuracy.md"));
    QVERIFY(figures.hasMatch());
    const QTemporaryDir folder;
    const Finished finished = run({"study", "accuracy", "two-corners", "--quick", "--out", folder.path()}, 5 * minute);
    QCOMPARE(finished.status, 0);
    const QString report = QString::fromUtf8(contentOf(folder.filePath("report.md")));
    const auto rows =
        tableIn(report.section("## two-corners, 16 × 16 cells, 5000 N/m", 1), "method | step ms | error mm");
    QStringList errors; // from the longest step to the shortest
    for (const QStringList& row : rows)
        if (row[0] == "xpbd") errors << row[2];
    QCOMPARE(errors.size(), 4);
    QCOMPARE(QString::number(errors[3].toDouble(), 'f', 1), figures.captured(1));
    QCOMPARE(QString::number(errors[2].toDouble(), 'f', 0), figures.captured(2));
    QCOMPARE(QString::number(errors[0].toDouble(), 'f', 0), figures.captured(3));
}

TOILE_TEST(tst_DocumentedFigures, QCoreApplication)
#include "tst_DocumentedFigures.moc"
