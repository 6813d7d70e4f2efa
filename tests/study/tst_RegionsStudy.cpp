// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/RegionsReport.h"
#include "samples/SmallScenes.h"
#include "tests/Suite.h"
#include "tests/study/Reports.h"

#include <QTest>
#include <algorithm>
#include <map>

using namespace toile;
using study::RegionsStudy;

namespace {

/// A sheet of 0.4 m held along its upper edge, with or without a finer upper half. It hangs in one way only.
simulation::Scene hangingSheet(bool withRegion) {
    const auto document = samples::squareSheet(samples::SheetPins::oneEdge, 0.4, 0.04);
    simulation::Scene scene{document.pattern, {}, document.scene};
    scene.settings.damping = 5; // it does not swing for long
    if (withRegion) {
        pattern::Piece piece = *scene.pattern.pieces[0];
        pattern::Region upper;
        upper.id = pattern::RegionId{"upper"};
        upper.name = "upper half";
        upper.outline = {{{-0.3, 0}, {0.3, 0}, {0.3, 0.3}, {-0.3, 0.3}}};
        upper.refinement = 1;
        piece.regions = {upper};
        scene.pattern.pieces[0] = Shared<pattern::Piece>(std::move(piece));
    }
    return scene;
}

/// rms of coarse, regions, as many particles, fine; and the floor [m].
RegionsStudy madeUp(double coarse, double regions, double equal, double fine, double floor) {
    RegionsStudy study{.floor = floor};
    for (const auto& [kind, rms] :
         {std::pair(study::LayoutKind::coarse, coarse), std::pair(study::LayoutKind::regions, regions),
          std::pair(study::LayoutKind::asManyPoints, equal), std::pair(study::LayoutKind::fine, fine)}) {
        study.layouts.push_back({.kind = kind, .particles = 100, .time = {1, 1}});
        study.layouts.back().rms = rms;
    }
    return study;
}

} // namespace

class tst_RegionsStudy : public QObject {
    Q_OBJECT
private slots:
    void theFinestSpacingIsThatOfARegion();
    void aPatternWithoutRegionsHasNothingToCompare();
    void layoutsAreComparedAtTheSamePoints();
    void aStudyGoesOnWithTheDrapesThatWereKept();
    void aRecordThatIsNoDrapeIsNotReadBack();
    void theVerdictFollowsTheNumbers();
    void noisyTimesAreNotCompared();
};

void tst_RegionsStudy::theFinestSpacingIsThatOfARegion() {
    QVERIFY(!study::finestSpacing(hangingSheet(false).pattern));
    QCOMPARE(study::finestSpacing(hangingSheet(true).pattern).value_or(0), 0.02);
}

void tst_RegionsStudy::aPatternWithoutRegionsHasNothingToCompare() {
    const auto study = study::studyRegions(hangingSheet(false), {.referenceSpacing = 0.01});
    QVERIFY(!study);
    QVERIFY(says(study.error().text, "no region that is finer"));
}

void tst_RegionsStudy::layoutsAreComparedAtTheSamePoints() {
    const auto study = study::studyRegions(hangingSheet(true), {.referenceSpacing = 0.01, .repetitions = 2});
    QVERIFY2(study, study ? "" : study.error().text.c_str());
    using study::LayoutKind;
    QCOMPARE(study->layouts.size(), study::layoutKinds.size());
    const auto &coarse = *study->find(LayoutKind::coarse), &regions = *study->find(LayoutKind::regions),
               &equal = *study->find(LayoutKind::asManyPoints), &fine = *study->find(LayoutKind::fine);
    // The lower half is as large as the upper one, and the paper's two levels need no rings.
    QCOMPARE(study->find(LayoutKind::elsewhere)->particles, regions.particles);
    QVERIFY(study->find(LayoutKind::paper)->particles <= regions.particles);
    QCOMPARE(coarse.particles, 11 * 11);
    QCOMPARE(fine.particles, 21 * 21);
    QCOMPARE(study->reference.particles, 41 * 41);
    QVERIFY(coarse.particles < regions.particles && regions.particles < fine.particles);
    // Each tenth of the held edge has a whole number of cells.
    QVERIFY(std::abs(equal.particles - regions.particles) < 0.2 * regions.particles);
    QCOMPARE(study->points, 33 * 33);
    for (const auto& layout : study->layouts) QVERIFY(layout.atRest);
    QVERIFY(fine.rms < coarse.rms);
    QVERIFY(study->floor < fine.rms);
    QVERIFY(fine.maximum >= fine.rms);
    QVERIFY(says(study::regionsText(*study, "sheet", {}), "| uniform, as many particles |"));
    const auto records = study::recordsOf(*study, "sheet", {});
    QCOMPARE(records.size(), study::layoutKinds.size() + 1); // and the reference
    QVERIFY(says(study::gnuplotScript(*study, "sheet", "regions"), "title 'regions, the paper''s rule'"));
    for (const Json& record : records) {
        QCOMPARE(toLine(record).find("null"), std::string::npos);
        const Json* cost = record.find("cost");
        QVERIFY(*cost->find("cpuSecondsMinimum")->asNumber() <= *cost->find("cpuSecondsMedian")->asNumber());
    }
}

void tst_RegionsStudy::aStudyGoesOnWithTheDrapesThatWereKept() {
    std::map<std::string, std::string> kept; // lines by their key
    int runs = 0;
    const auto keeper = [&](const Json& key, const auto& run) -> Result<study::LayoutGo> {
        std::string& line = kept[toLine(key)];
        if (!line.empty()) return study::layoutGoFrom(*parseJson(line)).value();
        ++runs;
        auto go = run();
        if (go) line = toLine(toJson(*go));
        return go;
    };
    const auto studied = [&] {
        return study::studyRegions(hangingSheet(true), {.referenceSpacing = 0.01, .repetitions = 2}, {}, {}, keeper);
    };
    const auto first = studied();
    QVERIFY(first);
    const int all = 2 * static_cast<int>(study::layoutKinds.size()) + 2; // and the reference, twice
    QCOMPARE(runs, all);
    QCOMPARE(static_cast<int>(kept.size()), all);
    const auto again = studied();
    QCOMPARE(runs, all);
    QCOMPARE(study::regionsText(*again, "sheet", {}), study::regionsText(*first, "sheet", {}));
    for (std::size_t i = 0; i < first->layouts.size(); ++i) QCOMPARE(again->layouts[i].rms, first->layouts[i].rms);
    kept.erase(std::ranges::find_if(kept, [](const auto& line) { return says(line.first, "repetition 2"); }));
    QVERIFY(studied());
    QCOMPARE(runs, all + 1);
}

void tst_RegionsStudy::aRecordThatIsNoDrapeIsNotReadBack() {
    study::LayoutGo go{.result = {.kind = study::LayoutKind::paper, .particles = 3}, .seconds = 0.5};
    go.lattice = {Vec3{1, 2, 3}, std::nullopt, Vec3{0.1, 0.2, 0.3}};
    go.parts = {{.piece = "Back", .region = "yoke", .finer = true, .area = 0.01}};
    const auto back = study::layoutGoFrom(toJson(go));
    QVERIFY(back);
    QVERIFY(back->result.kind == study::LayoutKind::paper);
    QCOMPARE(back->lattice.size(), std::size_t(3));
    QVERIFY(back->lattice[0] == go.lattice[0] && !back->lattice[1] && back->lattice[2] == go.lattice[2]);
    QCOMPARE(back->parts.front().area, 0.01);
    for (const auto& [key, wrong] : {std::pair("layout", Json("spiral")), std::pair("cpuSeconds", Json("long")),
                                     std::pair("lattice", Json(Json::Array{1.0, 2.0})), std::pair("strain", Json())}) {
        Json json = toJson(go);
        QVERIFY2(!study::layoutGoFrom(json.set(key, wrong)), key);
    }
}

void tst_RegionsStudy::theVerdictFollowsTheNumbers() {
    QVERIFY(says(study::verdictOn(madeUp(5e-3, 1e-3, 4e-3, 5e-4, 1e-4)), "Here the regions pay."));
    QVERIFY(says(study::verdictOn(madeUp(5e-3, 4e-3, 1e-3, 5e-4, 1e-4)), "do not pay"));
    QVERIFY(says(study::verdictOn(madeUp(5e-3, 4e-3, 3e-3, 5e-4, 2e-3)), "makes no difference"));
}

void tst_RegionsStudy::noisyTimesAreNotCompared() {
    RegionsStudy study = madeUp(5e-3, 1e-3, 4e-3, 5e-4, 1e-4);
    QVERIFY(says(study::verdictOn(study), "1.00 times the CPU time"));
    study.layouts[2].time = study::runTimeOf({1, 1.4, 1.5});
    QVERIFY(says(study::verdictOn(study), "No conclusion about cost"));
    QVERIFY(!says(study::verdictOn(study), "times the CPU time"));
    QVERIFY(says(study::verdictOn(study), "Here the regions pay."));
}

TOILE_TEST(tst_RegionsStudy)
#include "tst_RegionsStudy.moc"
