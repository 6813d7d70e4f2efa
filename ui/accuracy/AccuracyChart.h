// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/GarmentAccuracy.h"

#include <QtCharts/QChartView>

class QLogValueAxis;
class QXYSeries;

namespace toile::ui {

/// What is drawn over the CPU time.
enum class AccuracyMeasure {
    floorsOff,   ///< of all quantities
    worstLength, ///< in millimetres
};

/// Error over CPU time, both logarithmic: a marker for each run, with its spacing in millimetres; those of one way and
/// layout joined; the front, which no run beats in both; grey, what is not told apart from the reference. Runs that do
/// not count stand open at the upper edge.
class AccuracyChart : public QChartView {
    Q_OBJECT
public:
    explicit AccuracyChart(QWidget* parent = nullptr);

    /// The study has to stay until the next one is shown.
    void show(const study::GarmentAccuracy* study, AccuracyMeasure measure);
    void mark(const study::GarmentRun* run); ///< null = none
    /// What the markers mean, as rich text that can be broken into lines.
    [[nodiscard]] QString legend() const;
    /// Where a run is drawn [pixels]; absent when it is not.
    [[nodiscard]] std::optional<QPointF> placeOf(const study::GarmentRun* run) const;

Q_SIGNALS:
    void clicked(const toile::study::GarmentRun* run);

protected:
    void drawForeground(QPainter* painter, const QRectF& rect) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;

private:
    struct Marker {
        const study::GarmentRun* run;
        QPointF point; ///< cost, error
        QXYSeries* series;
    };

    void addAxes();
    void addBand(double band);
    void addCurves();
    void addFront();
    void addFailures();
    [[nodiscard]] QPointF pointOf(const study::GarmentRun& run) const;
    [[nodiscard]] double bandOf() const;
    void attach(QAbstractSeries* series);
    /// The run whose marker is nearest to a pixel; null = none is near.
    [[nodiscard]] const study::GarmentRun* runAt(QPoint pixel) const;

    const study::GarmentAccuracy* study_ = nullptr;
    AccuracyMeasure measure_ = AccuracyMeasure::floorsOff;
    QLogValueAxis *cost_ = nullptr, *error_ = nullptr;
    std::vector<Marker> markers_;
    const study::GarmentRun* marked_ = nullptr;
};

} // namespace toile::ui
