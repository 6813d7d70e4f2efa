// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/cli/Pages.h"

#include <QTemporaryDir>

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
    void regionsSaveWhatThePageSays();
    void rulesMeshTheBackAsThePageSays();
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

QTEST_GUILESS_MAIN(tst_DocumentedFigures)
#include "tst_DocumentedFigures.moc"
