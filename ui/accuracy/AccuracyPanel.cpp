// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/accuracy/AccuracyPanel.h"

#include "ui/accuracy/AccuracyChart.h"
#include "ui/accuracy/AccuracyTexts.h"
#include "ui/accuracy/FigureTable.h"

#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSplitter>
#include <QVBoxLayout>

#include <algorithm>

namespace toile::ui {
namespace {

/// Narrower panels have the tables below the chart.
constexpr int wideEnough = 760;

template <class Widget>
Widget* named(Widget* widget, const char* name) {
    widget->setObjectName(QLatin1String(name));
    return widget;
}

QLabel* wrapped(const char* name) {
    auto* label = named(new QLabel, name);
    label->setWordWrap(true);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    return label;
}

QFont smaller(QFont font) {
    font.setPointSizeF(0.9 * font.pointSizeF());
    return font;
}

QString timeText(double seconds) {
    return seconds < 90 ? AccuracyPanel::tr("about %1 s left").arg(std::max(1.0, seconds), 0, 'f', 0)
                        : AccuracyPanel::tr("about %1 min left").arg(seconds / 60, 0, 'f', 0);
}

} // namespace

AccuracyPanel::AccuracyPanel(Workbench& workbench, AccuracyParts parts, QWidget* parent)
    : QWidget(parent), workbench_(workbench), study_(workbench, std::move(parts)) {
    setObjectName(QStringLiteral("accuracyPanel"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(8, 6, 8, 6);
    column->setSpacing(5);
    column->addWidget(makeControls());
    stale_ = wrapped("accuracyStale");
    stale_->setStyleSheet(QStringLiteral("background: #fff3d6; color: #6b4a00; padding: 3px 6px;"));
    column->addWidget(stale_);
    column->addWidget(makeSuggestion());
    sides_ = new QSplitter;
    sides_->addWidget(makeChartSide());
    sides_->addWidget(makeTableSide());
    sides_->setChildrenCollapsible(false);
    sides_->setMinimumWidth(270); // of one side: both stand below each other before it is reached
    sides_->setStretchFactor(0, 1);
    sides_->setStretchFactor(1, 1);
    column->addWidget(sides_, 1);
    tick_.setInterval(std::chrono::milliseconds(500));
    connect(&tick_, &QTimer::timeout, this, &AccuracyPanel::showProgress);
    connect(&study_, &AccuracyStudy::changed, this, &AccuracyPanel::refresh);
    connect(&study_, &AccuracyStudy::progressed, this, &AccuracyPanel::showProgress);
    connect(&study_, &AccuracyStudy::saved, this,
            [this](const QString& folder) { workbench_.tell(tr("Saved the report in %1").arg(folder)); });
    connect(&study_, &AccuracyStudy::notSaved, this, [this](const QString& why) { workbench_.tell(why, true); });
    showResult();
    refresh();
}

QWidget* AccuracyPanel::makeControls() {
    auto* box = new QWidget;
    auto* column = new QVBoxLayout(box);
    column->setContentsMargins(0, 0, 0, 0);
    auto* buttons = new QHBoxLayout;
    auto* progress = new QHBoxLayout;
    column->addLayout(buttons);
    column->addLayout(progress);
    start_ = named(new QPushButton(tr("Measure")), "accuracyStart");
    start_->setToolTip(tr("Drape the open garment by all ways on several meshes, in the background, and compare"));
    cancel_ = named(new QPushButton(tr("Cancel")), "accuracyCancel");
    progress_ = named(new QProgressBar, "accuracyProgress");
    progress_->setMaximumWidth(160);
    progress_->setTextVisible(false);
    progress_->setRange(0, 1000);
    state_ = wrapped("accuracyState");
    copy_ = named(new QPushButton(tr("Copy report")), "accuracyCopy");
    copy_->setToolTip(tr("Put the report into the clipboard, as Markdown"));
    save_ = named(new QPushButton(tr("Save report…")), "accuracySave");
    save_->setToolTip(tr("Write report, records and plot into a folder, as the command line does"));
    buttons->addWidget(start_);
    buttons->addWidget(cancel_);
    buttons->addStretch(1);
    buttons->addWidget(copy_);
    buttons->addWidget(save_);
    progress->addWidget(progress_);
    progress->addWidget(state_, 1);
    connect(start_, &QPushButton::clicked, &study_, &AccuracyStudy::start);
    connect(cancel_, &QPushButton::clicked, &study_, &AccuracyStudy::cancel);
    connect(copy_, &QPushButton::clicked, this, [this] {
        QApplication::clipboard()->setText(study_.text(within()));
        workbench_.tell(tr("The report is in the clipboard."));
    });
    connect(save_, &QPushButton::clicked, this, &AccuracyPanel::saveReport);
    return box;
}

QWidget* AccuracyPanel::makeSuggestion() {
    auto* box = new QWidget;
    auto* column = new QVBoxLayout(box);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(3);
    auto* row = new QHBoxLayout;
    within_ = named(new QDoubleSpinBox, "accuracyWithin");
    within_->setRange(0.1, 100);
    within_->setDecimals(1);
    within_->setSingleStep(0.5);
    within_->setValue(3);
    within_->setSuffix(tr(" mm"));
    auto* asked = new QLabel(tr("Every length right within"));
    asked->setBuddy(within_);
    use_ = named(new QPushButton, "accuracyUse");
    row->addWidget(asked);
    row->addWidget(within_);
    row->addStretch(1);
    row->addWidget(use_);
    column->addLayout(row);
    suggestion_ = wrapped("accuracySuggestion");
    column->addWidget(suggestion_);
    connect(within_, &QDoubleSpinBox::valueChanged, this, &AccuracyPanel::showSuggestion);
    connect(use_, &QPushButton::clicked, this, &AccuracyPanel::useRun);
    return box;
}

QWidget* AccuracyPanel::makeChartSide() {
    auto* side = new QWidget;
    auto* column = new QVBoxLayout(side);
    column->setContentsMargins(0, 0, 4, 0);
    column->setSpacing(2);
    measure_ = named(new QComboBox, "accuracyMeasure");
    measure_->addItems({tr("All quantities, in floors"), tr("Worst length, in millimetres")});
    chart_ = named(new AccuracyChart, "accuracyChart");
    unknowns_ = wrapped("accuracyUnknowns");
    legend_ = wrapped("accuracyLegend");
    for (QLabel* label : {legend_, unknowns_}) label->setFont(smaller(label->font()));
    unknowns_->setStyleSheet(QStringLiteral("color: #5b646e;"));
    column->addWidget(measure_, 0, Qt::AlignLeft);
    column->addWidget(chart_, 1);
    column->addWidget(legend_);
    column->addWidget(unknowns_);
    connect(measure_, &QComboBox::currentIndexChanged, this, &AccuracyPanel::showChart);
    connect(chart_, &AccuracyChart::clicked, this, &AccuracyPanel::choose);
    return side;
}

QWidget* AccuracyPanel::makeTableSide() {
    auto* tables = new QSplitter(Qt::Vertical);
    runs_ = new FigureTable("accuracyRuns", accuracyColumns(), 2, 7);
    quantities_ = new FigureTable("accuracyQuantities", quantityColumns(), 2, 5);
    tables->addWidget(runs_);
    tables->addWidget(quantities_);
    tables->setStretchFactor(0, 3);
    tables->setStretchFactor(1, 2);
    tables->setChildrenCollapsible(false);
    connect(runs_, &QTableWidget::currentCellChanged, this, [this](int row) {
        const auto* item = row >= 0 ? runs_->item(row, 0) : nullptr;
        const int index = item ? item->data(Qt::UserRole).toInt() : -1;
        choose(shown() && index >= 0 ? &shown()->runs[static_cast<std::size_t>(index)] : nullptr);
    });
    return tables;
}

void AccuracyPanel::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    sides_->setOrientation(width() < wideEnough ? Qt::Vertical : Qt::Horizontal);
}

double AccuracyPanel::within() const {
    return 1e-3 * within_->value();
}

const study::GarmentAccuracy* AccuracyPanel::shown() const {
    return study_.result() ? &study_.result()->accuracy : nullptr;
}

void AccuracyPanel::refresh() {
    if (study_.resultNumber() != seen_) showResult();
    showState();
}

void AccuracyPanel::showState() {
    const bool runs = study_.isRunning(), stale = study_.isStale();
    start_->setEnabled(!runs);
    cancel_->setVisible(runs);
    progress_->setVisible(runs);
    copy_->setEnabled(shown());
    save_->setEnabled(shown());
    stale_->setVisible(stale);
    stale_->setText(tr("The garment was changed since: these figures are of the one before. Measure again."));
    if (runs) tick_.start();
    else tick_.stop();
    showProgress();
    showRun();
}

void AccuracyPanel::showProgress() {
    progress_->setValue(static_cast<int>(1000 * study_.fraction()));
    QString state = study_.problem();
    if (study_.isRunning()) {
        const auto left = study_.secondsLeft();
        state = left ? tr("%1 · %2").arg(doingText(study_.doing()), timeText(*left)) : doingText(study_.doing());
    } else if (state.isEmpty() && !shown()) {
        state =
            tr("How far is the drape from a finer one, and what would less cost? Measuring takes some minutes in the "
               "background.");
    }
    state_->setText(state);
    state_->setVisible(!state.isEmpty());
}

void AccuracyPanel::showResult() {
    seen_ = study_.resultNumber();
    chosen_ = nullptr;
    sides_->setVisible(shown());
    suggestion_->parentWidget()->setVisible(shown());
    runs_->setRowCount(0);
    if (!shown()) return;
    const auto rows = accuracyRowsOf(*shown());
    runs_->setRowCount(static_cast<int>(rows.size()));
    for (int row = 0; row < runs_->rowCount(); ++row) {
        const AccuracyRow& line = rows[static_cast<std::size_t>(row)];
        runs_->setLine(row, line.cells, line.onFront);
        runs_->item(row, 0)->setData(Qt::UserRole, line.run ? static_cast<int>(line.run - shown()->runs.data()) : -1);
    }
    runs_->resizeColumnsToContents();
    unknowns_->setText(unknownsOf(*shown()));
    showChart();
    showSuggestion();
    Q_EMIT resultShown();
}

void AccuracyPanel::showChart() {
    chart_->show(shown(), static_cast<AccuracyMeasure>(measure_->currentIndex()));
    chart_->mark(chosen_);
    legend_->setText(chart_->legend());
}

/// The suggested setting is chosen at once: another may be, afterwards.
void AccuracyPanel::showSuggestion() {
    if (!shown()) return;
    const Suggestion suggestion = suggestionFor(*shown(), within());
    suggestion_->setText(suggestion.text);
    choose(suggestion.run);
}

void AccuracyPanel::choose(const study::GarmentRun* run) {
    if (!shown()) return;
    chosen_ = run;
    const QSignalBlocker quiet(runs_);
    runs_->clearSelection();
    for (int row = 0; row < runs_->rowCount() && run; ++row)
        if (runs_->item(row, 0)->data(Qt::UserRole).toInt() == run - shown()->runs.data()) runs_->selectRow(row);
    chart_->mark(run);
    showRun();
}

/// What is told of the chosen run, and whether it can be taken over.
void AccuracyPanel::showRun() {
    if (!shown()) return;
    const auto rows = quantityRowsOf(*shown(), chosen_);
    quantities_->setRowCount(static_cast<int>(rows.size()));
    for (int row = 0; row < quantities_->rowCount(); ++row)
        quantities_->setLine(row, rows[static_cast<std::size_t>(row)]);
    quantities_->resizeColumnsToContents();
    const bool usable = chosen_ && chosen_->drape.status.empty() && isOfTheWindow(*chosen_) && !study_.isStale();
    use_->setEnabled(usable);
    use_->setText(chosen_ ? tr("Use %1").arg(meshText(*chosen_)) : tr("Use the setting"));
    use_->setToolTip(!chosen_                   ? tr("Choose a run in the table or the chart.")
                     : study_.isStale()         ? tr("The garment was changed since.")
                     : !isOfTheWindow(*chosen_) ? tr("This method is on the command line only.")
                                                : tr("Give the pieces this spacing: one step that can be undone"));
}

void AccuracyPanel::useRun() {
    if (!chosen_ || study_.isStale()) return;
    const study::GarmentRun run = *chosen_;
    if (auto next = study_.withMeshOf(run)) workbench_.apply({tr("Set mesh"), std::move(*next)});
    else workbench_.tell(tr("The garment has this mesh already."));
    if (run.finished) Q_EMIT finishWanted();
}

void AccuracyPanel::saveReport() {
    const QString folder = QFileDialog::getExistingDirectory(this, tr("Save report in a folder"));
    if (!folder.isEmpty()) study_.save(folder, within());
}

} // namespace toile::ui
