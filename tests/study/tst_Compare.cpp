// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/Compare.h"
#include "tests/Suite.h"

#include <QTest>

using namespace toile;
using study::Change;
using study::Comparison;

namespace {

struct Made {
    double error = 1e-3;
    double least = 1, median = 1.02, calibration = 0.01;
    int newton = 100;
    std::string status = "done";
    std::string processor = "this";
    double step = 0.01;
    double selfError = 0;
};

Json record(const Made& made) {
    Json machine, scene, method, reference, result, cost, json;
    machine.set("processor", made.processor).set("calibrationSeconds", made.calibration);
    scene.set("name", "flap").set("stiffness", 50);
    method.set("integrator", "trbdf2").set("step", made.step);
    reference.set("selfError", made.selfError);
    result.set("maximumError", made.error);
    cost.set("cpuSecondsMinimum", made.least).set("cpuSecondsMedian", made.median);
    cost.set("newtonIterations", made.newton);
    json.set("schema", "toile-study-1").set("machine", machine).set("scene", scene).set("method", method);
    json.set("reference", reference).set("result", result).set("cost", cost).set("status", made.status);
    return json;
}

Json validation(const char* what, double measured, const char* verdict) {
    Json json;
    json.set("schema", "toile-validation-1").set("case", "V5").set("what", what);
    json.set("expected", 1.0).set("measured", measured).set("verdict", verdict);
    return json;
}

Comparison comparisonOf(const Made& before, const Made& after) {
    const auto comparison = study::compared({record(before)}, {record(after)});
    if (!comparison) qFatal("%s", toString(comparison.error()).c_str());
    return *comparison;
}

/// "worse maximumError": of the only change.
std::string onlyChange(const Comparison& comparison) {
    if (comparison.changes.size() != 1) return std::to_string(comparison.changes.size()) + " changes";
    const Change& change = comparison.changes.front();
    const char* kind = change.kind == Change::Kind::worse    ? "worse "
                       : change.kind == Change::Kind::better ? "better "
                                                             : "other ";
    return kind + change.quantity;
}

} // namespace

class tst_Compare : public QObject {
    Q_OBJECT
private slots:
    void equalReportsDifferInNothing();
    void aChangeIsFound_data();
    void aChangeIsFound();
    void timesAreComparedInCalibrations();
    void aDisturbedCalibrationIsNoMeasure();
    void noisyTimesAreNotCompared();
    void nothingBelowTheReferencesOwnErrorIsAChange();
    void answersAreComparedByTheirDeviation();
    void recordsWithoutPartnersAreNamed();
    void whatIsSwitchedOnIsPartOfAName();
    void recordsOfOneNameAreJoinedInOrder();
    void differentStudiesAreNotCompared();
};

void tst_Compare::equalReportsDifferInNothing() {
    const Comparison comparison = comparisonOf({}, {});
    QVERIFY(comparison.changes.empty() && !comparison.gotWorse());
    QCOMPARE(comparison.joined, std::size_t(1));
    QCOMPARE(study::comparisonText(comparison),
             std::string("1 records in both: 0 worse, 0 better, 0 other changes. Times of 1 were compared.\n"));
}

void tst_Compare::aChangeIsFound_data() {
    QTest::addColumn<QString>("expected");
    QTest::addColumn<double>("error");
    QTest::addColumn<double>("least");
    QTest::addColumn<int>("newton");
    QTest::addColumn<QString>("status");
    QTest::newRow("greater error, by its last digits") << "worse maximumError" << 1.0000001e-3 << 1.0 << 100 << "done";
    QTest::newRow("smaller error") << "better maximumError" << 5e-4 << 1.0 << 100 << "done";
    QTest::newRow("one more iteration") << "worse newtonIterations" << 1e-3 << 1.0 << 101 << "done";
    QTest::newRow("fewer iterations") << "better newtonIterations" << 1e-3 << 1.0 << 50 << "done";
    QTest::newRow("slower") << "worse CPU time in calibrations" << 1e-3 << 1.1 << 100 << "done";
    QTest::newRow("faster") << "better CPU time in calibrations" << 1e-3 << 0.9 << 100 << "done";
    QTest::newRow("slower within noise") << "0 changes" << 1e-3 << 1.03 << 100 << "done";
    QTest::newRow("not solved any more") << "worse status" << 1e-3 << 1.0 << 100 << "not solved";
}

void tst_Compare::aChangeIsFound() {
    QFETCH(QString, expected);
    QFETCH(double, error);
    QFETCH(double, least);
    QFETCH(int, newton);
    QFETCH(QString, status);
    const Comparison comparison = comparisonOf(
        {}, {.error = error, .least = least, .median = 1.02 * least, .newton = newton, .status = status.toStdString()});
    QCOMPARE(QString::fromStdString(onlyChange(comparison)), expected);
    QCOMPARE(comparison.gotWorse(), expected.startsWith("worse"));
}

void tst_Compare::timesAreComparedInCalibrations() {
    // A machine of half the speed takes twice the time for both.
    const Made half{.least = 2, .median = 2.04, .calibration = 0.02, .processor = "another"};
    QVERIFY(comparisonOf({}, half).changes.empty());
    QCOMPARE(onlyChange(comparisonOf({}, {.calibration = 0.02, .processor = "another"})),
             std::string("better CPU time in calibrations"));
}

void tst_Compare::aDisturbedCalibrationIsNoMeasure() {
    const Comparison far = comparisonOf({}, {.calibration = 0.02}); // of the same processor
    QVERIFY(far.changes.empty());
    QCOMPARE(far.timesNoisy, std::size_t(1));
    const Comparison near = comparisonOf({}, {.calibration = 0.012}); // the seconds are the same
    QVERIFY(near.changes.empty());
    QCOMPARE(near.timesCompared, std::size_t(1));
}

void tst_Compare::noisyTimesAreNotCompared() {
    for (const bool first : {true, false}) {
        const Made quiet{.newton = first ? 101 : 99}, noisy{.least = 3, .median = 4};
        const Comparison comparison = first ? comparisonOf(noisy, quiet) : comparisonOf(quiet, noisy);
        QCOMPARE(onlyChange(comparison), std::string("worse newtonIterations")); // counters are, all the same
        QCOMPARE(comparison.timesNoisy, std::size_t(1));
        QVERIFY(study::comparisonText(comparison).find("over 1.3 times what it is undisturbed") != std::string::npos);
    }
}

void tst_Compare::nothingBelowTheReferencesOwnErrorIsAChange() {
    QVERIFY(comparisonOf({.selfError = 1e-5}, {.error = 1.009e-3, .selfError = 1e-5}).changes.empty());
    QVERIFY(comparisonOf({.selfError = 1e-5}, {.error = 1.011e-3, .selfError = 1e-5}).gotWorse());
}

void tst_Compare::answersAreComparedByTheirDeviation() {
    const auto change = [](double before, double after) {
        return onlyChange(*study::compared({validation("tip", before, "PASS")}, {validation("tip", after, "PASS")}));
    };
    QCOMPARE(change(0.99, 1.005), std::string("better deviation")); // from the other side
    QCOMPARE(change(0.99, 1.02), std::string("worse deviation"));
    const auto failed = study::compared({validation("tip", 1, "PASS")}, {validation("tip", 1, "FAIL")});
    QCOMPARE(onlyChange(*failed), std::string("worse verdict"));
}

void tst_Compare::recordsWithoutPartnersAreNamed() {
    const auto comparison = study::compared({record({}), record({.step = 0.02})}, {record({}), record({.step = 0.04})});
    QVERIFY(comparison && !comparison->gotWorse());
    QCOMPARE(comparison->joined, std::size_t(1));
    QCOMPARE(comparison->onlyOld, std::vector<std::string>{"flap, 50, trbdf2, 0.02"});
    QCOMPARE(comparison->onlyNew, std::vector<std::string>{"flap, 50, trbdf2, 0.04"});
    QVERIFY(study::comparisonText(*comparison).starts_with("only in the old: flap, 50, trbdf2, 0.02\n"));
}

void tst_Compare::whatIsSwitchedOnIsPartOfAName() {
    const auto named = [](bool finished) {
        Json method, json;
        method.set("integrator", "xpbd").set("finished", finished);
        return json.set("schema", "toile-study-garment-1").set("method", method);
    };
    const auto comparison = study::compared({named(true), named(false)}, {named(false)});
    QVERIFY(comparison);
    QCOMPARE(comparison->onlyOld, std::vector<std::string>{"xpbd, finished yes"});
}

void tst_Compare::recordsOfOneNameAreJoinedInOrder() {
    const std::vector<Json> twice{validation("tip", 1, "PASS"), validation("tip", 1, "FAIL")};
    const auto comparison = study::compared(twice, twice);
    QVERIFY(comparison && comparison->changes.empty());
    QCOMPARE(comparison->joined, std::size_t(2));
}

void tst_Compare::differentStudiesAreNotCompared() {
    QVERIFY(!study::compared({record({})}, {validation("tip", 1, "PASS")}));
    QVERIFY(!study::compared({record({})}, {}));
    QVERIFY(!study::compared({record({}), validation("tip", 1, "PASS")}, {record({})}));
    Json nameless;
    nameless.set("case", "V5");
    QVERIFY(!study::compared({nameless}, {nameless}));
}

TOILE_TEST(tst_Compare)
#include "tst_Compare.moc"
