// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/Simulation.h"
#include "core/study/lean/Records.h"
#include "core/study/lean/Report.h"
#include "core/study/validation/Pieces.h"
#include "tests/Suite.h"
#include "tests/study/Reports.h"

#include <QTest>
#include <algorithm>

using namespace toile;
using namespace toile::study::lean;

namespace {

constexpr LeanSettings brief{.frames = 12, .repetitions = 1};

Feature featureNamed(const std::string& name) {
    const auto all = allFeatures(true);
    return *std::ranges::find(all, name, &Feature::name);
}

FeatureResult resultOf(const Feature& feature, const LeanSettings& settings = brief) {
    auto result = studied(feature, settings);
    if (!result) qFatal("%s", toString(result.error()).c_str());
    return std::move(*result);
}

} // namespace

class tst_Lean : public QObject {
    Q_OBJECT
private slots:
    void whatIsNotNeededCostsNothing_data();
    void whatIsNotNeededCostsNothing();
    void aPartWithoutNeedIsFoundOut();
    void aPartThatMovesClothIsNotIdle();
    void aPartWithoutEffectIsNotInUse();
    void everyPartOfThePlanIsLookedAt();
    void aGarmentIsLookedAtAsItIsDrawn();
    void whatIsUnusedTakesNoInstructions();
    void theReportSaysWhatWasMeasured();
    void aResultIsReadFromItsRecords();
};

void tst_Lean::whatIsNotNeededCostsNothing_data() {
    QTest::addColumn<int>("index");
    int index = 0;
    for (const Feature& feature : allFeatures(true)) QTest::newRow(feature.name.c_str()) << index++;
}

void tst_Lean::whatIsNotNeededCostsNothing() {
    QFETCH(int, index);
    const FeatureResult result = resultOf(allFeatures(true)[static_cast<std::size_t>(index)]);
    for (const study::lean::Row& row : result.rows)
        QVERIFY2(row.why.empty(), (std::string(nameOf(row.role)) + ", " + row.what + ": " + row.why).c_str());
}

/// A negative control: a body in the air is said to be left out.
void tst_Lean::aPartWithoutNeedIsFoundOut() {
    Feature feature = featureNamed("body contact");
    feature.variants[1].role = Role::unused;
    const FeatureResult result = resultOf(feature);
    QVERIFY(!passes(result));
    QCOMPARE(result.rows[1].why, std::string("It is in the plan."));
    QVERIFY(says(summaryOf({result}), "2 of 3 rows pass. Failing: body contact."));
}

void tst_Lean::aPartThatMovesClothIsNotIdle() {
    Feature feature = featureNamed("body contact");
    feature.variants[2].role = Role::forced;
    QVERIFY(says(resultOf(feature).rows[2].why, "Leaving it out moves the cloth by"));
}

void tst_Lean::aPartWithoutEffectIsNotInUse() {
    Feature feature = featureNamed("body contact");
    feature.variants[1].role = Role::inUse;
    QCOMPARE(resultOf(feature).rows[1].why, std::string("It has no effect."));
}

/// What plans leave out has a feature here.
void tst_Lean::everyPartOfThePlanIsLookedAt() {
    std::vector<std::string> parts;
    for (const Feature& feature : allFeatures(true)) parts.push_back(feature.part);
    const auto simulation = simulation::Simulation::create(study::validation::twoSquares());
    QVERIFY(simulation);
    for (const auto& left : simulation->plan().leftOut())
        QVERIFY2(std::ranges::find(parts, left.stage) != parts.end(), left.stage.c_str());
    for (const auto* stage : simulation->plan().stages())
        QVERIFY(std::ranges::find(parts, stage->name()) != parts.end());
}

void tst_Lean::aGarmentIsLookedAtAsItIsDrawn() {
    const Feature feature = garmentFeature("two squares", study::validation::twoSquares());
    QCOMPARE(feature.variants.size(), std::size_t(3));
    QCOMPARE(feature.variants[1].forced, std::vector<std::string>{"hands"});
    const FeatureResult result = resultOf(feature);
    QVERIFY2(passes(result), summaryOf({result}).c_str());
    QCOMPARE(result.rows[2].taken.stages, (std::vector<std::string>{"seams", "self-contact"}));
}

void tst_Lean::whatIsUnusedTakesNoInstructions() {
    const Feature feature = featureNamed("hands");
    FeatureResult result = resultOf(feature);
    addInstructions(result, feature, std::vector<double>{12e6, 12.001e6, 13e6, 15e6});
    QVERIFY(passes(result));
    QCOMPARE(result.rows[1].taken.instructions.value_or(0), 12.001e6 / 12);
    addInstructions(result, feature, std::vector<double>{12e6, 12.1e6, 13e6, 15e6});
    QCOMPARE(result.rows[1].why, std::string("Its steps take 1008333 instructions, not 1000000."));
}

void tst_Lean::theReportSaysWhatWasMeasured() {
    const FeatureResult result = resultOf(featureNamed("hands"), {.frames = 2, .repetitions = 3});
    const std::string text = leanText({result}, {.command = "toile-cli study lean"});
    for (const char* words : {"`toile-cli study lean`", "**4 of 4 rows pass.**", "| hands | unused | taken hold of"})
        QVERIFY2(says(text, words), text.c_str());
    const auto records = recordsOf(result, {});
    QCOMPARE(records.size(), std::size_t(4));
    for (const Json& record : records) {
        QCOMPARE(*record.find("verdict")->asString(), std::string("PASS"));
        QVERIFY(*record.find("cost")->find("cpuSecondsMinimum")->asNumber() > 0);
        QVERIFY(record.find("result")->find("resultHash")->asString()->size() == 64);
    }
}

void tst_Lean::aResultIsReadFromItsRecords() {
    Feature feature = featureNamed("body contact");
    feature.variants[1].role = Role::unused; // a row that fails
    FeatureResult result = resultOf(feature);
    for (study::lean::Row& row : result.rows) row.taken.instructions = 123456;
    result.rows[0].taken.frame = {1, 2, true};
    const auto written = recordsOf(result, {});
    QVERIFY(*written[0].find("cost")->find("noisy")->asBool());
    std::vector<Json> read;
    for (const Json& record : written) read.push_back(*parseJson(toLine(record)));
    const FeatureResult again = resultFrom(feature, read);
    QVERIFY(recordsOf(again, {}) == written);
    QCOMPARE(leanText({again}, {}), leanText({result}, {}));
    LeanSettings settings = brief;
    settings.counted = true;
    const auto keys = keysOf(feature, settings);
    QCOMPARE(keys.size(), written.size());
    for (std::size_t i = 0; i < keys.size(); ++i) {
        QVERIFY(*keys[i].find("scene") == *read[i].find("scene"));
        QVERIFY(*keys[i].find("method") == *read[i].find("method"));
    }
}

TOILE_TEST(tst_Lean)
#include "tst_Lean.moc"
