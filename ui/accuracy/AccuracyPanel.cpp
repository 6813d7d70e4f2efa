// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/accuracy/AccuracyPanel.h"

#include "ui/accuracy/AccuracyChart.h"
#include "ui/accuracy/AccuracyTexts.h"
#include "ui/accuracy/FigureTable.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSplitter>

#include <algorithm>

namespace toile::ui {
namespace {

QString timeText(double seconds) {
    return seconds < 90 ? AccuracyPanel::tr("about %1 s left").arg(std::max(1.0, seconds), 0, 'f', 0)
                        : AccuracyPanel::tr("about %1 min left").arg(seconds / 60, 0, 'f', 0);
}

} // namespace

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
    Q_EMIT methodWanted(*run.setup.method);
    if (run.finished) Q_EMIT finishWanted();
}

void AccuracyPanel::saveReport() {
    const QString folder = QFileDialog::getExistingDirectory(this, tr("Save report in a folder"));
    if (!folder.isEmpty()) study_.save(folder, within());
}

} // namespace toile::ui
