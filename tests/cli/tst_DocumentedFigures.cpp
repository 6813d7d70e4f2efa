// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/cli/Program.h"

#include <QRegularExpression>

using namespace toile;

namespace {

QString page(const QString& name) {
    return QString::fromUtf8(contentOf(qEnvironmentVariable("TOILE_SOURCE_DIR") + "/docs/" + name));
}

QStringList cellsOf(const QString& line) {
    QStringList cells = line.split('|');
    cells.removeFirst();
    cells.removeLast();
    for (QString& cell : cells) cell = cell.trimmed();
    return cells;
}

/// The rows below the heading row that begins with this cell or these cells; none where there is no such table.
QList<QStringList> tableIn(const QString& text, const QString& heading) {
    const QStringList lines = text.split('\n');
    QList<QStringList> rows;
    for (qsizetype i = 0; i < lines.size(); ++i) {
        if (!lines[i].startsWith("| " + heading + " |")) continue;
        for (i += 2; i < lines.size() && lines[i].startsWith('|'); ++i) rows << cellsOf(lines[i]);
        break;
    }
    return rows;
}

/// The lines of the page's code blocks that run this command, without the program's name.
QList<QStringList> commandsIn(const QString& text, const QString& command) {
    QList<QStringList> found;
    for (const QString& line : text.split('\n'))
        if (line.startsWith("toile-cli " + command)) found << QProcess::splitCommand(line).mid(1);
    return found;
}

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

QTEST_GUILESS_MAIN(tst_DocumentedFigures)
#include "tst_DocumentedFigures.moc"
