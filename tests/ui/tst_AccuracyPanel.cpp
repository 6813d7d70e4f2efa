// SPDX-License-Identifier: GPL-3.0-or-later
#include "UiFixtures.h"
#include "WindowFixture.h"
#include "core/pattern/PatternRegions.h"
#include "tests/Suite.h"
#include "ui/accuracy/AccuracyChart.h"
#include "ui/accuracy/AccuracyPanel.h"
#include "ui/accuracy/AccuracyTexts.h"
#include "ui/window/Translation.h"

#include <QClipboard>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>
#include <QSemaphore>
#include <QSignalSpy>
#include <QTableWidget>

using namespace toile;
using namespace toile::ui;

namespace {

using dynamics::Method;

/// Two rectangles; the front has a region of half the spacing.
document::Document garmentWithRegion() {
    return *document::edited(twoRectangles(), [](const pattern::Pattern& p, pattern::IdSource& ids) {
        return addRegion(p, p.pieces[0]->id, {{-0.05, -0.05}, {0.05, -0.05}, {0, 0.05}}, "1", 1, ids);
    });
}

/// Hem and strain: how far a run is off, of floors of 1 mm and 0.1 %.
study::GarmentRun runOf(const study::GarmentReference& reference, study::GarmentSetup setup, bool finished,
                        double seconds, double hem) {
    study::GarmentRun run{.setup = setup, .finished = finished, .spacing = 0.02 * setup.factor};
    run.drape.quantities = reference.mean;
    run.drape.quantities[0].value = *reference.mean[0].value + hem;
    run.drape.particles = 1000;
    run.time = {seconds, seconds, false};
    run.repetitions = 2;
    study::judge(run, reference);
    return run;
}

/// By rising cost nearer, but for the last, which does not count.
study::GarmentAccuracy madeStudy() {
    study::GarmentAccuracy study{.name = "made", .mainSpacing = 0.02};
    study.reference = {.spacing = 0.016, .particles = 4000, .runs = 5, .floor = {1e-3, 1e-3}, .band = 0.5};
    study.reference.mean = {{"hem at the centre front", "hemFront", study::Measure::length, 0.9, {}},
                            {"strain along warp, 95 %", "warpStrain", study::Measure::strain, 0.01, {}}};
    const auto add = [&](study::GarmentSetup setup, bool finished, double seconds, double hem) {
        study.runs.push_back(runOf(study.reference, setup, finished, seconds, hem));
    };
    add({true, 1.4, Method::xpbd}, false, 1, 0.012);
    add({false, 1.4, std::nullopt}, true, 1.5, 0.0025);
    add({false, 1.4, Method::xpbd}, true, 2, -0.004);
    add({false, 1.2, Method::xpbd}, true, 3, -0.0028);
    add({true, 1, Method::xpbd}, true, 5, 0.0011);
    add({true, 1, std::nullopt}, true, 4, 0.02);
    study.runs.back().drape.status = "seams are open";
    study.notRun.push_back({{true, 1.4, Method::trBdf2}, "it was given up after 90 s of CPU time"});
    return study;
}

/// The panel on a garment, with a study that the test makes.
struct PanelFixture {
    study::GarmentAccuracy made = madeStudy();
    QSemaphore mayEnd{1000}; ///< a study waits for one of them
    std::atomic<int> begun{0}, stopped{0};
    std::string savedIn;
    Workbench workbench;
    std::unique_ptr<AccuracyPanel> panel;

    PanelFixture() : workbench(workbenchParts()) {
        workbench.startFrom(garmentWithRegion(), {}, false);
        panel = std::make_unique<AccuracyPanel>(workbench, parts());
        panel->resize(1100, 420);
        panel->show();
    }
    ~PanelFixture() { mayEnd.release(1000); }

    static WorkbenchParts workbenchParts() {
        WorkbenchParts parts;
        parts.mesh = [mesh = std::make_shared<meshing::GarmentMesh>()](
                         const pattern::Pattern& pattern) -> Result<const meshing::GarmentMesh*> {
            mesh->pieces.resize(pattern.pieces.size());
            return mesh.get();
        };
        return parts;
    }
    AccuracyParts parts() {
        return {[this](const std::string&, const simulation::Scene&, const study::GarmentPlan&, std::stop_token stop,
                       const Progress& progress) -> Result<study::GarmentAccuracy> {
                    ++begun;
                    report(progress, 0, "reference 1 of 5");
                    mayEnd.acquire();
                    if (!stop.stop_requested()) return made;
                    ++stopped;
                    return fail(ErrorCode::cancelled, "The run was stopped.");
                },
                [](std::string command) {
                    return study::Circumstances{"toile", std::move(command), "a processor"};
                },
                [this](const std::string& folder, const auto&, const auto&, const auto&) -> Result<void> {
                    savedIn = folder;
                    return {};
                }};
    }
    template <class Widget>
    Widget* find(const char* name) {
        return panel->findChild<Widget*>(QLatin1String(name));
    }
    void measure() {
        QTest::mouseClick(find<QPushButton>("accuracyStart"), Qt::LeftButton);
        QVERIFY(QTest::qWaitFor([&] { return !panel->study().isRunning(); }));
    }
    /// Keeps a picture of the panel where TOILE_PICTURES names a folder: to be looked at.
    void picture(const char* name) {
        const QString folder = qEnvironmentVariable("TOILE_PICTURES");
        if (!folder.isEmpty()) QVERIFY(panel->grab().save(folder + QLatin1Char('/') + QLatin1String(name)));
    }
    QString suggestion() { return find<QLabel>("accuracySuggestion")->text(); }
    double spacing() { return workbench.document().pattern.pieces[0]->spacing; }
    int refinement() { return workbench.document().pattern.pieces[0]->regions[0].refinement; }
    void edit() {
        workbench.apply({QStringLiteral("Draw"), withRectangle(workbench.document(), "Pocket", {0.6, 0}, 0.1, 0.1)});
    }
};

} // namespace

/// Error against run time in the window.
class tst_AccuracyPanel : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { prepareApplication(); }
    void theTablesAreTheStudys();
    void theChartHasEveryRunThatCounts();
    void itRunsInTheBackgroundAndTellsHowFarItIs();
    void cancelAnswersAtOnce();
    void anEditMakesItStaleAndUndoDoesNot();
    void theSuggestionIsTheCheapestThatMeetsIt();
    void aSettingIsTakenOverInOneStep();
    void noisyRunsSuggestNothing();
    void whatCannotBeMeasuredIsSaid();
    void theReportIsTheCommandLines();
    void narrowOnesHaveTheTablesBelow();
    void theWindowShowsIt();
    void everyTextIsTranslated();
};

void tst_AccuracyPanel::theTablesAreTheStudys() {
    PanelFixture f;
    f.measure();
    auto* runs = f.find<QTableWidget>("accuracyRuns");
    QCOMPARE(runs->rowCount(), 7);
    QStringList costs;
    for (int row = 0; row < runs->rowCount(); ++row) costs << runs->item(row, 3)->text();
    QCOMPARE(costs, QStringList({"1", "1.5", "2", "3", "4", "5", ""}));
    QCOMPARE(runs->item(5, 5)->text(), QStringLiteral("1.1")); // its worst length
    QVERIFY(runs->item(5, 0)->font().bold());                  // on the front
    QVERIFY(!runs->item(2, 0)->font().bold());                 // statics is nearer and cheaper
    QVERIFY(runs->item(4, 7)->text().contains(QStringLiteral("seams are open")));
    QVERIFY(runs->item(6, 7)->text().contains(QStringLiteral("given up")));

    runs->setCurrentCell(0, 0);
    auto* quantities = f.find<QTableWidget>("accuracyQuantities");
    QCOMPARE(quantities->rowCount(), 2);
    QStringList hem;
    for (int column = 0; column < 5; ++column) hem << quantities->item(0, column)->text();
    QCOMPARE(hem, QStringList({"hem at the centre front", "mm", "900.0", "1.0", "+12.0"}));
    const QString unknown = f.find<QLabel>("accuracyUnknowns")->text();
    for (const char* part : {"16 mm", "0.5 floors", "given up: 1", "numerical"})
        QVERIFY2(unknown.contains(QLatin1String(part)), part);
}

void tst_AccuracyPanel::theChartHasEveryRunThatCounts() {
    PanelFixture f;
    f.measure();
    auto* chart = f.find<AccuracyChart>("accuracyChart");
    const auto& study = f.panel->study().result()->accuracy;
    for (const int measure : {0, 1}) {
        f.find<QComboBox>("accuracyMeasure")->setCurrentIndex(measure);
        QTest::qWait(20);
        for (const study::GarmentRun& run : study.runs) QVERIFY(chart->placeOf(&run));
        // dearer is farther right, nearer to the reference is lower
        QVERIFY(chart->placeOf(&study.runs[0])->x() < chart->placeOf(&study.runs[4])->x());
        QVERIFY(chart->placeOf(&study.runs[0])->y() < chart->placeOf(&study.runs[4])->y());
    }
    QSignalSpy clicked(chart, &AccuracyChart::clicked);
    QTest::mouseClick(chart->viewport(), Qt::LeftButton, {}, chart->placeOf(&study.runs[0])->toPoint() + QPoint(4, 3));
    QCOMPARE(clicked.size(), 1);
    QCOMPARE(f.find<QTableWidget>("accuracyRuns")->currentRow(), 0);
}

void tst_AccuracyPanel::itRunsInTheBackgroundAndTellsHowFarItIs() {
    PanelFixture f;
    f.mayEnd.acquire(1000);
    QTest::mouseClick(f.find<QPushButton>("accuracyStart"), Qt::LeftButton);
    QVERIFY(f.panel->study().isRunning());
    const auto* state = f.find<QLabel>("accuracyState");
    QVERIFY(QTest::qWaitFor([&] { return state->text().contains(QStringLiteral("Reference drape 1 of 5")); }));
    f.edit(); // nothing is blocked, and the study is of the garment before
    f.mayEnd.release();
    QVERIFY(QTest::qWaitFor([&] { return !f.panel->study().isRunning(); }));
    QVERIFY(f.panel->study().result() && f.panel->study().isStale());
}

void tst_AccuracyPanel::cancelAnswersAtOnce() {
    PanelFixture f;
    f.mayEnd.acquire(1000); // the run under way does not look at its stop
    QTest::mouseClick(f.find<QPushButton>("accuracyStart"), Qt::LeftButton);
    QVERIFY(QTest::qWaitFor([&] { return f.begun == 1; }));
    QTest::mouseClick(f.find<QPushButton>("accuracyCancel"), Qt::LeftButton); // the run is held until mayEnd.release
    QVERIFY(!f.panel->study().isRunning());
    QVERIFY(f.find<QPushButton>("accuracyStart")->isEnabled());

    QTest::mouseClick(f.find<QPushButton>("accuracyStart"), Qt::LeftButton); // another, while the first still ends
    f.mayEnd.release(2);
    QVERIFY(QTest::qWaitFor([&] { return !f.panel->study().isRunning() && f.stopped == 1; }));
    QVERIFY(f.panel->study().result() && f.panel->study().problem().isEmpty());
    QCOMPARE(f.panel->study().resultNumber(), 1);
}

void tst_AccuracyPanel::anEditMakesItStaleAndUndoDoesNot() {
    PanelFixture f;
    f.measure();
    auto* stale = f.find<QLabel>("accuracyStale");
    QVERIFY(stale->isHidden());
    QVERIFY(f.find<QPushButton>("accuracyUse")->isEnabled());
    f.edit();
    QVERIFY(!stale->isHidden());
    QVERIFY(!f.find<QPushButton>("accuracyUse")->isEnabled());
    f.workbench.undo();
    QVERIFY(stale->isHidden());
    QVERIFY(f.find<QPushButton>("accuracyUse")->isEnabled());
}

void tst_AccuracyPanel::theSuggestionIsTheCheapestThatMeetsIt() {
    PanelFixture f;
    f.measure();
    auto* within = f.find<QDoubleSpinBox>("accuracyWithin");
    within->setValue(5);
    QVERIFY2(f.suggestion().contains(QStringLiteral("Statics alone, 28 mm uniform")), qPrintable(f.suggestion()));
    QVERIFY(f.suggestion().contains(QStringLiteral("In the window: XPBD, finished, 28 mm uniform")));
    within->setValue(1.5);
    QVERIFY(f.suggestion().contains(QStringLiteral("XPBD, finished, 20 mm as drawn")));
    QVERIFY(f.find<QPushButton>("accuracyUse")->text().contains(QStringLiteral("20 mm as drawn")));
    within->setValue(1);
    QVERIFY(f.suggestion().contains(QStringLiteral("Nothing that was tried")));
    within->setValue(0.5);
    QVERIFY(f.suggestion().contains(QStringLiteral("“hem at the centre front” differs by 1 mm")));
}

void tst_AccuracyPanel::aSettingIsTakenOverInOneStep() {
    PanelFixture f;
    f.measure();
    const double drawn = f.spacing();
    QSignalSpy finish(f.panel.get(), &AccuracyPanel::finishWanted);
    std::vector<Method> methods;
    QObject::connect(f.panel.get(), &AccuracyPanel::methodWanted, [&](Method method) { methods.push_back(method); });
    f.find<QDoubleSpinBox>("accuracyWithin")->setValue(5);
    QTest::mouseClick(f.find<QPushButton>("accuracyUse"), Qt::LeftButton);
    QCOMPARE(f.spacing(), 1.4 * drawn);
    QCOMPARE(f.refinement(), 0);
    QCOMPARE(finish.size(), 1);
    QVERIFY(methods == std::vector{Method::xpbd});
    QVERIFY(!f.panel->study().isStale()); // that mesh was measured
    f.find<QDoubleSpinBox>("accuracyWithin")->setValue(1.5);
    QTest::mouseClick(f.find<QPushButton>("accuracyUse"), Qt::LeftButton); // of the drawn spacing, not of the last
    QCOMPARE(f.spacing(), drawn);
    QCOMPARE(f.refinement(), 1);
    f.workbench.undo();
    QCOMPARE(f.spacing(), 1.4 * drawn);
    f.workbench.undo();
    QVERIFY(f.workbench.document() == garmentWithRegion());
}

void tst_AccuracyPanel::noisyRunsSuggestNothing() {
    PanelFixture f;
    f.made.runs[1].time = {1.5, 3, true};
    f.measure();
    QVERIFY(f.suggestion().startsWith(QStringLiteral("Nothing is suggested")));
    QVERIFY(!f.find<QPushButton>("accuracyUse")->isEnabled());
    QVERIFY(f.find<QTableWidget>("accuracyRuns")->item(1, 7)->text().contains(QStringLiteral("noisy")));
}

void tst_AccuracyPanel::whatCannotBeMeasuredIsSaid() {
    PanelFixture f;
    f.workbench.startNew();
    QTest::mouseClick(f.find<QPushButton>("accuracyStart"), Qt::LeftButton);
    QVERIFY(!f.panel->study().isRunning());
    QVERIFY(f.find<QLabel>("accuracyState")->text().contains(QStringLiteral("no garment")));
}

void tst_AccuracyPanel::theReportIsTheCommandLines() {
    PanelFixture f;
    f.measure();
    QTest::mouseClick(f.find<QPushButton>("accuracyCopy"), Qt::LeftButton);
    const QString text = QApplication::clipboard()->text();
    QVERIFY(text.startsWith(QStringLiteral("# Error against run time: made")));
    QVERIFY(text.contains(QStringLiteral("not saved")));
    QSignalSpy saved(&f.panel->study(), &AccuracyStudy::saved);
    f.panel->study().save(QStringLiteral("a folder"), 0.003);
    QVERIFY(saved.wait());
    QCOMPARE(f.savedIn, std::string("a folder"));
}

void tst_AccuracyPanel::narrowOnesHaveTheTablesBelow() {
    PanelFixture f;
    f.measure();
    const auto below = [&] {
        QTest::qWait(50);
        auto* chart = f.find<AccuracyChart>("accuracyChart");
        auto* runs = f.find<QTableWidget>("accuracyRuns");
        return runs->mapTo(f.panel.get(), QPoint()).y() >
               chart->mapTo(f.panel.get(), QPoint()).y() + chart->height() / 2;
    };
    QVERIFY(!below());
    f.picture("accuracy-wide.png");
    f.panel->resize(420, 900);
    QVERIFY(below());
    f.picture("accuracy-narrow.png");
    QVERIFY(f.panel->width() <= 420); // it fits
}

void tst_AccuracyPanel::theWindowShowsIt() {
    Bench bench;
    auto* dock = bench.find<QWidget>("accuracyDock");
    QVERIFY(dock->isHidden());
    bench.action("simulation.accuracy")->trigger();
    QVERIFY(!dock->isHidden());
    bench.action("simulation.accuracy")->trigger();
    QVERIFY(dock->isHidden());
    QVERIFY(bench.action("simulation.finish")->isChecked()); // unless its user does not want it
}

void tst_AccuracyPanel::everyTextIsTranslated() {
    const auto translation = Translation::of(QLocale(QLocale::Chinese, QLocale::China));
    QCoreApplication::installTranslator(translation.get());
    const auto isChinese = [](const QString& text) {
        return std::ranges::any_of(text, [](QChar c) { return c.unicode() >= 0x2E80; });
    };
    PanelFixture f;
    f.measure();
    for (const QStringList& texts :
         {accuracyColumns(), quantityColumns(),
          QStringList{unknownsOf(f.made), settingText(f.made.runs[0]), remarkOn(f.made.runs.back()),
                      doingText("reference 1 of 5"), doingText("as drawn × 1.4, xpbd"), doingText("")}})
        for (const QString& text : texts) QVERIFY2(isChinese(text), qPrintable(text));
    for (const double within : {0.05, 0.005, 0.001, 0.0005}) QVERIFY(isChinese(suggestionFor(f.made, within).text));
    for (const study::Quantity& quantity : study::noQuantities())
        QVERIFY2(isChinese(QCoreApplication::translate("", std::string(quantity.name).c_str())),
                 std::string(quantity.name).c_str());
    for (QWidget* widget : f.panel->findChildren<QWidget*>()) {
        if (!widget->toolTip().isEmpty()) QVERIFY2(isChinese(widget->toolTip()), qPrintable(widget->toolTip()));
        if (const auto* button = qobject_cast<QPushButton*>(widget); button && !button->text().isEmpty())
            QVERIFY2(isChinese(button->text()), qPrintable(button->text()));
    }
    QCoreApplication::removeTranslator(translation.get());
}

TOILE_TEST(tst_AccuracyPanel, QApplication)
#include "tst_AccuracyPanel.moc"
