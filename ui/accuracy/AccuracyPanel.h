// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/accuracy/AccuracyStudy.h"

#include <QTimer>
#include <QWidget>

class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QProgressBar;
class QPushButton;
class QSplitter;

namespace toile::ui {

class AccuracyChart;
class FigureTable;

/// How wrong the open garment's drape is and what less would cost: the study with its progress, chart, tables, and the
/// setting that it suggests, which can be taken over.
class AccuracyPanel : public QWidget {
    Q_OBJECT
public:
    AccuracyPanel(Workbench& workbench, AccuracyParts parts, QWidget* parent = nullptr);

    [[nodiscard]] AccuracyStudy& study() { return study_; }

Q_SIGNALS:
    void resultShown();
    void methodWanted(toile::dynamics::Method method); ///< the setting that was taken over drapes by it
    void finishWanted(); ///< the setting that was taken over finishes its drape by statics

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    [[nodiscard]] QWidget* makeControls();
    [[nodiscard]] QWidget* makeSuggestion();
    [[nodiscard]] QWidget* makeChartSide();
    [[nodiscard]] QWidget* makeTableSide();
    [[nodiscard]] double within() const;                       ///< [m]
    [[nodiscard]] const study::GarmentAccuracy* shown() const; ///< null = nothing was measured yet

    void refresh();
    void showState();
    void showProgress();
    void showResult(); ///< another one
    void showChart();
    void showSuggestion();
    void showRun();
    void choose(const study::GarmentRun* run);
    void useRun();
    void saveReport();

    Workbench& workbench_;
    AccuracyStudy study_;
    int seen_ = 0; ///< the result that tables and chart show, by its number
    const study::GarmentRun* chosen_ = nullptr;
    QTimer tick_;

    QPushButton *start_, *cancel_, *use_, *copy_, *save_;
    QProgressBar* progress_;
    QLabel *state_, *stale_, *suggestion_, *legend_, *unknowns_;
    QDoubleSpinBox* within_;
    QComboBox* measure_;
    AccuracyChart* chart_;
    FigureTable *runs_, *quantities_;
    QSplitter* sides_;
};

} // namespace toile::ui
