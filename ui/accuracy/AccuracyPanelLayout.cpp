// SPDX-License-Identifier: GPL-3.0-or-later
// Which parts the panel has and where they stand. What they show: AccuracyPanel.cpp.
#include "ui/accuracy/AccuracyChart.h"
#include "ui/accuracy/AccuracyPanel.h"
#include "ui/accuracy/AccuracyTexts.h"
#include "ui/accuracy/FigureTable.h"

#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSplitter>
#include <QVBoxLayout>

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

} // namespace toile::ui
