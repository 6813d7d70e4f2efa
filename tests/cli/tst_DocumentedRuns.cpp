// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/Suite.h"
#include "tests/cli/Program.h"

#include <QTemporaryDir>
#include <algorithm>
#include <cmath>

using namespace toile;

namespace {

/// The report of `toile-cli sew DOCUMENT …`; null where there is none.
Json sewn(const QString& document, const QStringList& arguments = {}) {
    const QTemporaryDir folder;
    const QString report = folder.filePath("sew.json");
    run(QStringList{"sew", document, "--quiet", "--report", report} + arguments, 5 * minutes);
    return jsonOf(contentOf(report));
}

/// The value at "worn.stretch.warpMaximum"; null where there is none.
Json valueAt(const Json& report, const QString& path) {
    const Json* value = &report;
    for (const QString& key : path.split('.'))
        if (value) value = value->find(key.toStdString());
    return value ? *value : Json();
}

double numberAt(const Json& report, const QString& path) {
    const Json value = valueAt(report, path);
    return value.asNumber() ? *value.asNumber() : double(NAN);
}

bool isAtRest(const Json& report) {
    const Json value = valueAt(report, "atRest");
    return value.asBool() && *value.asBool();
}

/// "7.4 mm" is compared to one of its last digit: half is lost by writing, and the static finish sums with OpenBLAS,
/// whose order is not the same on every processor.
QByteArray unlike(const QString& written, double seen) {
    static const QRegularExpression pattern(R"(\d+(?:\.(\d+))?)");
    const auto found = pattern.match(written);
    if (!found.hasMatch()) return "no figure: " + written.toUtf8();
    const double said = found.captured().toDouble(), digit = std::pow(10, -static_cast<int>(found.captured(1).size()));
    if (std::abs(said - seen) <= digit) return {};
    return written.toUtf8() + " is written, " + QByteArray::number(seen) + " seen";
}

#define COMPARE_FIGURE(written, seen)                                                                                  \
    do {                                                                                                               \
        const QByteArray difference = unlike(written, seen);                                                           \
        QVERIFY2(difference.isEmpty(), difference);                                                                    \
    } while (false)

/// Of "2 563".
double countOf(QString written) {
    return written.remove(' ').toDouble();
}

QStringList rowOf(const QList<QStringList>& rows, const QString& name) {
    const auto row = std::ranges::find_if(rows, [&](const QStringList& each) { return each[0] == name; });
    return row == rows.end() ? QStringList() : *row;
}

/// A copy of a sample with one text replaced, beside a body that is found as before.
QString altered(const QString& name, const QString& text, const QString& by, const QTemporaryDir& folder) {
    QString document = QString::fromUtf8(contentOf(sample(name)));
    if (document.count(text) != 1) return {};
    document.replace(text, by).replace("\"bodies/", "\"" + sample("bodies/"));
    QFile file(folder.filePath("altered.toile"));
    return file.open(QIODevice::WriteOnly) && file.write(document.toUtf8()) > 0 ? file.fileName() : QString();
}

/// The row of decision 9 that has this name.
void compareWithDecision(const QString& name, const Json& report) {
    const QStringList row =
        rowOf(tableIn(page("decisions/0009-a-fuller-mannequin-for-the-blouse.md"),
                      "`toile-cli sew samples/blouse.toile --until-rest` | particles | nape | left and right"),
              name);
    QCOMPARE(row.size(), 6);
    QCOMPARE(countOf(row[1]), numberAt(report, "particles"));
    COMPARE_FIGURE(row[2], 1000 * numberAt(report, "worn.landmarks.napeDistance"));
    COMPARE_FIGURE(row[3], 1000 * numberAt(report, "worn.landmarks.symmetryDifference"));
    for (const auto& [column, thread] : {std::pair{4, "warp"}, {5, "weft"}}) {
        const QByteArray path = QByteArray("worn.stretch.") + thread;
        COMPARE_FIGURE(row[column].section('/', 0, 0), 100 * numberAt(report, path + "Percentile99"));
        COMPARE_FIGURE(row[column].section('/', 1, 1), 100 * numberAt(report, path + "Maximum"));
    }
}

} // namespace

/// What the pages say of runs of `toile-cli sew` that take seconds: how garments lie, and when they rest.
class tst_DocumentedRuns : public QObject {
    Q_OBJECT
private slots:
    void theBlouseLiesAsThePagesSay();
    void theBlouseLiesOnAnotherBodyAsThePageSays();
    void finishesMoveTheClothAsThePageSays();
    void airIsBalancedAsThePageSays();
    void thePaperEndsAsThePageSays();
    void methodsTakeOverFromSewingAsThePageSays();
};

void tst_DocumentedRuns::theBlouseLiesAsThePagesSay() {
    const Json report = sewn(sample("blouse.toile"), {"--until-rest"});
    QVERIFY(isAtRest(report));
    const double particles = numberAt(report, "particles"), rms = numberAt(report, "curvature.rms"),
                 alternating = numberAt(report, "curvature.alternating");
    const auto millimetres = [&](const char* path) { return 1000 * numberAt(report, path); };

    compareWithDecision("on the mannequin", report);
    if (QTest::currentTestFailed()) return;

    const QString text = page("simulation.md");
    const QStringList rest = rowOf(tableIn(text, "spacing | particles | at rest after"), "20 mm"),
                      waves = rowOf(tableIn(text, "spacing | `curvature.rms`"), "20 mm"),
                      finish = rowOf(tableIn(text, "sample | particles | finish, CPU s"), "blouse");
    QVERIFY(rest.size() == 4 && waves.size() == 5 && finish.size() == 5);
    QCOMPARE(countOf(rest[1]), particles);
    COMPARE_FIGURE(rest[2], numberAt(report, "simulatedSeconds"));
    COMPARE_FIGURE(waves[1], rms);
    COMPARE_FIGURE(waves[2], alternating);
    COMPARE_FIGURE(waves[3], 100 * alternating / rms);
    QCOMPARE(countOf(finish[1]), particles);
    COMPARE_FIGURE(finish[4], millimetres("finishDisplacementMaximum"));
}

void tst_DocumentedRuns::theBlouseLiesOnAnotherBodyAsThePageSays() {
    if (!qEnvironmentVariableIsSet("TOILE_TEST_DATA"))
        QSKIP("NOT RUN: needs TOILE_TEST_DATA (a folder with bodies/*.glb)");
    const QString body = "mh_female_bust98.glb";
    const Json report = sewn(sample("blouse.toile"),
                             {"--avatar", qEnvironmentVariable("TOILE_TEST_DATA") + "/bodies/" + body, "--until-rest"});
    QVERIFY(isAtRest(report));
    compareWithDecision("`--avatar " + body + "`", report);
}

void tst_DocumentedRuns::finishesMoveTheClothAsThePageSays() {
    const auto rows = tableIn(page("simulation.md"), "sample | particles | finish, CPU s");
    for (const auto& [name, file] :
         {std::pair{"T-shirt", "t-shirt.toile"}, {"tube", "tube.toile"}, {"buttoned band", "buttoned-band.toile"}}) {
        const QStringList row = rowOf(rows, name);
        QVERIFY2(row.size() == 5, name);
        const Json report = sewn(sample(file), {"--until-rest"});
        QCOMPARE(countOf(row[1]), numberAt(report, "particles"));
        COMPARE_FIGURE(row[4], 1000 * numberAt(report, "finishDisplacementMaximum"));
    }
}

void tst_DocumentedRuns::airIsBalancedAsThePageSays() {
    const QTemporaryDir folder;
    const auto rows = tableIn(page("physics/air.md"), "| residual at the end");
    QCOMPARE(rows.size(), 5);
    for (const QStringList& row : rows) {
        const QString method = row[0].section('`', 1, 1);
        const QString copy = row[0].startsWith("50 Pa")
                                 ? altered("tube.toile", "\"fabric\":", "\"pressure\": 50, \"fabric\":", folder)
                                 : altered("tube.toile", "\"scene\": {",
                                           R"("scene": { "air": {"wind": [3, 0, 0], "drag": 1.2},)", folder);
        QVERIFY2(!copy.isEmpty(), "the sample is not as it was");
        const Json report = sewn(copy, {"--until-rest", "--method", method});
        const QByteArray name = row[0].toUtf8();
        QVERIFY2(isAtRest(report) != row[2].contains("not at rest"), name);
        const double said = row[1].toDouble(), seen = numberAt(report, "residual");
        QVERIFY2(seen < 3 * said && seen > said / 3, name + ": " + QByteArray::number(seen)); // how far Newton got
        if (isAtRest(report)) COMPARE_FIGURE(row[2], numberAt(report, "simulatedSeconds"));
    }
}

void tst_DocumentedRuns::thePaperEndsAsThePageSays() {
    const auto rows = tableIn(page("physics/paper.md"), "garment | seen");
    static const QRegularExpression squares(R"(at rest after (\S+) s, (\d+) particles)"),
        blouse(R"(steps would have to be (\d+) ns long)"), step(R"(explicit steps of at most (\S+) s)");
    const auto said = squares.match(rowOf(rows, "`two-squares`").value(1));
    QVERIFY(said.hasMatch());
    const Json report = sewn(sample("two-squares.toile"), {"--paper"});
    QVERIFY(isAtRest(report));
    COMPARE_FIGURE(said.captured(1), numberAt(report, "simulatedSeconds"));
    QCOMPARE(countOf(said.captured(2)), numberAt(report, "particles"));

    const auto refused = blouse.match(rowOf(rows, "`blouse`").value(1)),
               found = step.match(run({"sew", sample("blouse.toile"), "--paper"}).err);
    QVERIFY(refused.hasMatch() && found.hasMatch());
    COMPARE_FIGURE(refused.captured(1), 1e9 * found.captured(1).toDouble());
}

void tst_DocumentedRuns::methodsTakeOverFromSewingAsThePageSays() {
    static const QRegularExpression sentence(
        R"(two squares of (\d+) particles are\s+shaken down in (\d+) frame steps and (\d+) Newton)");
    const auto said = sentence.match(page("decisions/0005-methods.md"));
    QVERIFY(said.hasMatch());
    const Json report = sewn(sample("two-squares.toile"), {"--spacing", "50", "--method", "trbdf2"});
    QCOMPARE(countOf(said.captured(1)), numberAt(report, "particles"));
    const Json phases = valueAt(report, "phases");
    QVERIFY(phases.asArray() && phases.asArray()->size() == 4);
    const Json& shaking = (*phases.asArray())[2]; // after sewing, and the two steps
    COMPARE_FIGURE(said.captured(2), numberAt(shaking, "parts"));
    COMPARE_FIGURE(said.captured(3), numberAt(shaking, "newtonIterations"));
}

TOILE_TEST(tst_DocumentedRuns, QCoreApplication)
#include "tst_DocumentedRuns.moc"
