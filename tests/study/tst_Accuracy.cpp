// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/AccuracyRecords.h"
#include "core/study/AccuracyReport.h"
#include "core/study/ErrorTimePlot.h"
#include "tests/Suite.h"
#include "tests/study/Reports.h"

#include <QRegularExpression>
#include <QSet>
#include <QTest>
#include <cmath>
#include <fmt/format.h>

using namespace toile;
using dynamics::Method;
using study::Setup;

namespace {

study::Scene oscillator() {
    return *study::sceneNamed("oscillator", {});
}

/// A kilogram on 100 N/m, pulled out by 0.1 m.
double oscillatorAt(double time) {
    return 1 + 0.1 * std::cos(10 * time);
}

/// Of which no time is noisy, whatever else the machine does.
study::CaseResult studiedCase(const std::vector<Setup>& setups) {
    auto result = study::studied({"flap", {.cells = 4}, setups}, 2);
    if (!result) qFatal("%s", toString(result.error()).c_str());
    for (auto& run : result->runs) run.noisy = false;
    return std::move(*result);
}

} // namespace

class tst_Accuracy : public QObject {
    Q_OBJECT
private slots:
    void samplesLieAtEvenTimes();
    void theReferenceOfTheOscillatorIsTheClosedForm();
    void methodsShowTheirOrder_data();
    void methodsShowTheirOrder();
    void whatLiesInTheBandStandsAtItsEdge();
    void noisyTimesAllowNoConclusion();
    void everyMethodOfAPlotHasItsOwnColour();
    void aRunThatFailsIsSaidAndTheOthersGoOn();
    void whatIsNoSceneIsSaid();
    void itCanBeStopped();
    void everyPlannedSceneIsBuilt();
    void recordsHoldNumbersOrReasons();
    void aResultIsReadFromItsRecords();
};

void tst_Accuracy::samplesLieAtEvenTimes() {
    const auto scene = oscillator();
    const auto trajectory = study::trajectoryOf(scene, {Method::rk4, 2000});
    QVERIFY(trajectory);
    QCOMPARE(static_cast<int>(trajectory->samples.size()), study::sampleCount);
    for (int k = 0; k < study::sampleCount; ++k) {
        const double time = scene.duration * (k + 1) / study::sampleCount;
        QVERIFY(std::abs(trajectory->samples[k][1].x - oscillatorAt(time)) < 1e-9);
    }
    QVERIFY(std::abs(trajectory->energyChange) < 1e-9);
}

void tst_Accuracy::theReferenceOfTheOscillatorIsTheClosedForm() {
    const auto result = study::studied({"oscillator", {}, {{Method::midpoint, 40}}}, 1);
    QVERIFY(result);
    const Vec3 end = result->reference.trajectory.samples.back()[1];
    QVERIFY(std::abs(end.x - oscillatorAt(1)) < 2 * result->reference.selfError);
    QVERIFY(result->reference.selfError < 1e-6);
}

void tst_Accuracy::methodsShowTheirOrder_data() {
    QTest::addColumn<int>("method");
    QTest::addColumn<double>("order");
    QTest::newRow("TR-BDF2 is of second order") << static_cast<int>(Method::trBdf2) << 2.0;
    QTest::newRow("midpoint is of second order") << static_cast<int>(Method::midpoint) << 2.0;
    QTest::newRow("BDF2 is of second order") << static_cast<int>(Method::bdf2) << 2.0;
    QTest::newRow("backward Euler is of first order") << static_cast<int>(Method::backwardEuler) << 1.0;
}

void tst_Accuracy::methodsShowTheirOrder() {
    QFETCH(int, method);
    QFETCH(double, order);
    const auto scene = oscillator();
    const auto exact = study::trajectoryOf(scene, {Method::rk4, 4000});
    QVERIFY(exact);
    double errors[2];
    for (int i = 0; i < 2; ++i) {
        const auto run = study::trajectoryOf(scene, {static_cast<Method>(method), 1000 << i, 1, 1e-10});
        QVERIFY(run);
        errors[i] = study::differenceOf(scene, *run, *exact).maximum;
    }
    QVERIFY(std::abs(std::log2(errors[0] / errors[1]) - order) < 0.1);
}

void tst_Accuracy::whatLiesInTheBandStandsAtItsEdge() {
    auto result = studiedCase({{Method::trBdf2, 20}, {Method::trBdf2, 40}, {Method::trBdf2, 80}});
    result.reference.selfError = 0.001; // a band of 3 mm
    for (auto& run : result.runs) run.inBand = true;
    const std::string within = study::accuracyText({result}, here);
    QVERIFY(within.find("| trbdf2 | – | not reached |") != std::string::npos); // a millimetre is not claimed
    QVERIFY(within.find("No method came within 1 mm.") != std::string::npos);
    result.reference.selfError = 0.0001;
    const std::string near = study::accuracyText({result}, here);
    QVERIFY(near.find("A millimetre is cheapest by trbdf2") != std::string::npos); // 0.3 mm is
    QVERIFY(study::gnuplotScript(result, 1).find(" 0.3 5\n") != std::string::npos);
}

void tst_Accuracy::noisyTimesAllowNoConclusion() {
    auto result = studiedCase({{Method::trBdf2, 20}, {Method::trBdf2, 40}});
    result.runs[1].noisy = true;
    const std::string text = study::accuracyText({result}, here);
    QVERIFY(text.find("No conclusion about cost") != std::string::npos);
    QVERIFY(text.find("No method came within 1 mm.") == std::string::npos);
    QVERIFY(text.find("A millimetre is cheapest by") == std::string::npos);
}

void tst_Accuracy::everyMethodOfAPlotHasItsOwnColour() {
    study::ErrorTimePlot plot;
    for (int i = 0; i < 10; ++i) plot.curves.push_back({fmt::format("method {}", i), {{1, 1, 1}}});
    const QString script = QString::fromStdString(study::gnuplotScript(plot, "methods"));
    static const QRegularExpression colour(QStringLiteral("linespoints linecolor rgb '(#[0-9a-f]{6})'"));
    QSet<QString> seen;
    for (auto match = colour.globalMatch(script); match.hasNext();) seen.insert(match.next().captured(1));
    QCOMPARE(seen.size(), 10);
}

void tst_Accuracy::aRunThatFailsIsSaidAndTheOthersGoOn() {
    auto result = studiedCase({{Method::trBdf2, 20}, {Method::bdf2, 20}});
    result.runs[0].failure = "it was told to fail";
    result.runs[0].solved = false;
    const std::string text = study::accuracyText({result}, here);
    QVERIFY(text.find("it was told to fail") != std::string::npos);
    QCOMPARE(*study::recordsOf(result, here)[0].find("status")->asString(), std::string("it was told to fail"));
    QVERIFY(!study::recordsOf(result, here)[0].find("result")->find("rmsError"));
}

void tst_Accuracy::whatIsNoSceneIsSaid() {
    const auto result = study::studied({"a skirt", {}, {}}, 1);
    QVERIFY(!result);
    QCOMPARE(result.error().text, std::string("There is no scene \"a skirt\"."));
}

void tst_Accuracy::itCanBeStopped() {
    std::stop_source stop;
    stop.request_stop();
    const auto result = study::studied({"flap", {.cells = 4}, {{Method::trBdf2, 20}}}, 1, stop.get_token());
    QVERIFY(!result);
    QCOMPARE(result.error().code, ErrorCode::cancelled);
}

void tst_Accuracy::everyPlannedSceneIsBuilt() {
    QCOMPARE(static_cast<int>(study::accuracyPlan({}, true).cases.size()), 5);
    QCOMPARE(static_cast<int>(study::accuracyPlan({}, false).cases.size()), 7);
    QCOMPARE(static_cast<int>(study::accuracyPlan({"flap"}, true).cases.size()), 2);
    for (const auto& one : study::accuracyPlan({}, true).cases)
        for (const Method method : dynamics::allMethods())
            QVERIFY(std::ranges::find(one.setups, method, &Setup::method) != one.setups.end());
}

void tst_Accuracy::recordsHoldNumbersOrReasons() {
    const auto result = studiedCase({{Method::xpbd, 20, 4}, {Method::trBdf2, 20}});
    for (const Json& record : study::recordsOf(result, here)) {
        QVERIFY(parseJson(toLine(record)));
        QCOMPARE(toLine(record).find("null"), std::string::npos);
        for (const char* key :
             {"schema", "program", "machine", "scene", "method", "reference", "result", "cost", "status"})
            QVERIFY2(record.find(key), key);
        QVERIFY(*record.find("cost")->find("cpuSecondsMedian")->asNumber() > 0);
        QVERIFY(*record.find("result")->find("maximumError")->asNumber() > 0);
    }
    QVERIFY(study::gnuplotScript(result, here.calibration).find("set output 'flap-1.svg'") != std::string::npos);
}

void tst_Accuracy::aResultIsReadFromItsRecords() {
    const study::AccuracyCase which{
        "oscillator", {}, {{Method::xpbd, 20, 4}, {Method::trBdf2, 20}, {Method::rk4, 400}, {Method::bdf2, 20}}};
    auto result = study::studied(which, 2);
    QVERIFY(result);
    result->runs[1].failure = "it was told to fail";
    result->runs[1].solved = result->runs[1].inBand = false;
    result->runs[1].error = {};
    result->runs[3].solved = false;
    result->runs[2].secondsLeast = 1;
    result->runs[2].secondsMedian = 2;
    result->runs[2].noisy = true;
    const auto written = study::recordsOf(*result, here);
    QVERIFY(*written[2].find("cost")->find("noisy")->asBool());
    std::vector<Json> read;
    for (const Json& record : written) read.push_back(*parseJson(toLine(record)));
    const auto again = study::resultFrom(which, read);
    QVERIFY(study::recordsOf(again, here) == written);
    QCOMPARE(study::accuracyText({again}, here), study::accuracyText({*result}, here));
    const auto keys = study::keysOf(which);
    QCOMPARE(keys.size(), written.size());
    for (std::size_t i = 0; i < keys.size(); ++i) {
        QVERIFY(*keys[i].find("scene") == *read[i].find("scene"));
        QVERIFY(*keys[i].find("method") == *read[i].find("method"));
    }
}

TOILE_TEST(tst_Accuracy)
#include "tst_Accuracy.moc"
