// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/accuracy/AccuracyChart.h"

#include "core/study/Advice.h"
#include "core/study/GarmentReport.h"
#include "ui/accuracy/AccuracyTexts.h"

#include <QGraphicsLayout>
#include <QMouseEvent>
#include <QToolTip>
#include <QtCharts/QAreaSeries>
#include <QtCharts/QLineSeries>
#include <QtCharts/QLogValueAxis>
#include <QtCharts/QScatterSeries>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace toile::ui {
namespace {

using study::GarmentRun;

/// Of methods, so that they are told apart by the colour-blind, too.
QColor colourOf(const GarmentRun& run) {
    if (!run.setup.method) return QColor(0xd5, 0x5e, 0x00);
    if (*run.setup.method != dynamics::Method::xpbd) return QColor(0x8a, 0x4f, 0x9e);
    return run.finished ? QColor(0x00, 0x8a, 0x66) : QColor(0x1f, 0x6f, 0xb5);
}

constexpr double markerSize = 9;

/// A band that lies so many times below the nearest run is left out: it would press the runs together.
constexpr double farthestBand = 6;

/// Powers of two, or of its root: a study spans a decade or two, which decades alone would leave without numbers.
QLogValueAxis* logarithmic(const QString& title, double from, double to) {
    constexpr double wide = 24;
    auto* axis = new QLogValueAxis;
    axis->setBase(to / from > wide ? 2 : std::numbers::sqrt2);
    axis->setRange(from, to);
    axis->setTitleText(title);
    axis->setLabelFormat(QStringLiteral("%.2g"));
    axis->setGridLineColor(QColor(0xe4, 0xe8, 0xec));
    axis->setMinorTickCount(0);
    QFont font = axis->labelsFont();
    font.setPointSizeF(8);
    axis->setLabelsFont(font);
    axis->setTitleFont(font);
    return axis;
}

} // namespace

AccuracyChart::AccuracyChart(QWidget* parent) : QChartView(parent) {
    setRenderHint(QPainter::Antialiasing);
    setFrameShape(QFrame::NoFrame);
    setMinimumSize(260, 200);
    setMouseTracking(true);
    chart()->setMargins({2, 2, 2, 2});
    chart()->layout()->setContentsMargins(0, 0, 0, 0);
    chart()->setBackgroundRoundness(0);
    chart()->setBackgroundBrush(QColor(0xfc, 0xfd, 0xfd));
    chart()->legend()->hide(); // its entries would be cut off: see legend()
}

void AccuracyChart::show(const study::GarmentAccuracy* study, AccuracyMeasure measure) {
    study_ = study;
    measure_ = measure;
    marked_ = nullptr;
    markers_.clear();
    chart()->removeAllSeries();
    for (QAbstractAxis* axis : chart()->axes()) {
        chart()->removeAxis(axis);
        delete axis;
    }
    cost_ = error_ = nullptr;
    if (!study_ || study::countedRuns(*study_).empty()) return viewport()->update();
    addAxes();
    addBand(bandOf());
    addFront();
    addCurves();
    addFailures();
    viewport()->update();
}

double AccuracyChart::bandOf() const {
    const study::GarmentReference& reference = study_->reference;
    if (measure_ == AccuracyMeasure::floorsOff) return reference.band;
    double widest = 0;
    for (std::size_t q = 0; q < reference.mean.size(); ++q)
        if (reference.mean[q].value && reference.mean[q].measure == study::Measure::length)
            widest = std::max(widest, 1e3 * reference.floor[q]);
    return widest;
}

/// What may be claimed: what is nearer than the band stands at its edge.
QPointF AccuracyChart::pointOf(const GarmentRun& run) const {
    if (measure_ == AccuracyMeasure::worstLength) return {run.time.least, 1e3 * run.lengthError};
    const study::CostError claimed = study::claimedOf(run, study_->reference);
    return {claimed.cost, claimed.error};
}

void AccuracyChart::addAxes() {
    double least = HUGE_VAL, most = 0, lowest = HUGE_VAL, highest = 0;
    for (const GarmentRun& run : study_->runs) {
        least = std::min(least, run.time.least);
        most = std::max(most, run.time.least);
        if (!run.drape.status.empty()) continue;
        lowest = std::min(lowest, pointOf(run).y());
        highest = std::max(highest, pointOf(run).y());
    }
    if (const double band = bandOf(); band > lowest / farthestBand) lowest = std::min(lowest, band);
    cost_ = logarithmic(tr("CPU time of the drape, s"), least / 1.25, most * 1.25);
    error_ = logarithmic(measure_ == AccuracyMeasure::floorsOff ? tr("error, floors off") : tr("worst length, mm"),
                         std::max(lowest, 1e-6) / 1.4, std::max(highest, 2e-6) * 1.4);
    chart()->addAxis(cost_, Qt::AlignBottom);
    chart()->addAxis(error_, Qt::AlignLeft);
}

void AccuracyChart::attach(QAbstractSeries* series) {
    chart()->addSeries(series);
    series->attachAxis(cost_);
    series->attachAxis(error_);
}

void AccuracyChart::addBand(double band) {
    if (band <= error_->min()) return;
    auto* upper = new QLineSeries;
    auto* lower = new QLineSeries;
    for (const double cost : {cost_->min(), cost_->max()}) {
        upper->append(cost, band);
        lower->append(cost, error_->min());
    }
    auto* area = new QAreaSeries(upper, lower);
    upper->setParent(area);
    lower->setParent(area);
    area->setBrush(QColor(0xd9, 0xde, 0xe3));
    area->setPen(Qt::NoPen);
    attach(area);
}

void AccuracyChart::addCurves() {
    std::map<std::pair<QString, bool>, std::vector<const GarmentRun*>> curves;
    for (const GarmentRun* run : study::countedRuns(*study_))
        curves[{methodText(run->setup.method, run->finished), run->setup.regions}].push_back(run);
    for (const auto& [key, runs] : curves) {
        const QColor colour = colourOf(*runs.front());
        const bool drawn = key.second;
        auto* line = new QLineSeries;
        line->setPen(QPen(colour, 1.2, drawn ? Qt::SolidLine : Qt::DashLine));
        auto* points = new QScatterSeries;
        points->setMarkerSize(markerSize);
        points->setMarkerShape(drawn ? QScatterSeries::MarkerShapeCircle : QScatterSeries::MarkerShapeRectangle);
        points->setColor(drawn ? colour : QColor(Qt::white));
        points->setBorderColor(colour);
        for (const GarmentRun* run : runs) {
            const QPointF point = pointOf(*run);
            line->append(point);
            points->append(point);
            markers_.push_back({run, point, points});
        }
        attach(line);
        attach(points);
    }
}

void AccuracyChart::addFront() {
    std::vector<QPointF> points;
    for (const GarmentRun* run : study::countedRuns(*study_)) points.push_back(pointOf(*run));
    std::vector<study::CostError> costs;
    for (const QPointF& point : points) costs.push_back({point.x(), point.y()});
    auto* front = new QLineSeries;
    front->setPen(QPen(QColor(40, 48, 58, 70), 6, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    for (const int i : study::paretoFront(costs)) front->append(points[static_cast<std::size_t>(i)]);
    attach(front);
}

void AccuracyChart::addFailures() {
    auto* open = new QScatterSeries;
    open->setMarkerSize(markerSize);
    open->setColor(Qt::transparent);
    open->setBorderColor(QColor(0xb0, 0x2a, 0x2a));
    for (const GarmentRun& run : study_->runs)
        if (!run.drape.status.empty()) {
            const QPointF point(run.time.least, error_->max() / 1.15);
            open->append(point);
            markers_.push_back({&run, point, open});
        }
    if (open->count() == 0) {
        delete open;
        return;
    }
    attach(open);
}

const GarmentRun* AccuracyChart::runAt(QPoint pixel) const {
    constexpr double near = 12; // [pixels]
    const auto distance = [&](const Marker& marker) { return QLineF(pixel, *placeOf(marker.run)).length(); };
    const auto nearest = std::ranges::min_element(markers_, {}, distance);
    return nearest == markers_.end() || distance(*nearest) > near ? nullptr : nearest->run;
}

void AccuracyChart::mousePressEvent(QMouseEvent* event) {
    if (const GarmentRun* run = runAt(event->pos())) Q_EMIT clicked(run);
}

void AccuracyChart::mouseMoveEvent(QMouseEvent* event) {
    const GarmentRun* run = runAt(event->pos());
    if (!run) return QToolTip::hideText();
    QStringList lines{settingText(*run),
                      tr("%1 CPU s, %2 floors off, worst length %3 mm")
                          .arg(QString::number(run->time.least, 'g', 3), QString::number(run->score, 'g', 2),
                               QString::number(1e3 * run->lengthError, 'g', 2))};
    if (const QString remark = remarkOn(*run); !remark.isEmpty()) lines << remark;
    QToolTip::showText(event->globalPosition().toPoint(), lines.join(QLatin1Char('\n')), this);
}

QString AccuracyChart::legend() const {
    if (!study_) return {};
    const auto coloured = [](const QColor& colour, const char* sign, const QString& text) {
        return QStringLiteral("<span style=\"color:%1\">%2</span>&nbsp;%3")
            .arg(colour.name(), QString::fromUtf8(sign),
                 QString(text).replace(QLatin1Char(' '), QChar(0xa0)).replace(QLatin1Char('-'), QChar(0x2011)));
    };
    QStringList entries;
    for (const GarmentRun* run : study::countedRuns(*study_))
        if (const QString entry = coloured(colourOf(*run), "●", methodText(run->setup.method, run->finished));
            !entries.contains(entry))
            entries << entry;
    entries << coloured(QColor(40, 48, 58), "●", tr("as drawn")) << coloured(QColor(40, 48, 58), "□", tr("uniform"))
            << coloured(QColor(0xb9, 0xbd, 0xc2), "▬", tr("front"));
    if (error_ && bandOf() > error_->min()) entries << coloured(QColor(0xd0, 0xd6, 0xdc), "█", tr("not told apart"));
    if (study::countedRuns(*study_).size() < study_->runs.size())
        entries << coloured(QColor(0xb0, 0x2a, 0x2a), "○", tr("does not count"));
    return entries.join(QStringLiteral("&ensp; "));
}

void AccuracyChart::mark(const GarmentRun* run) {
    marked_ = run;
    viewport()->update();
}

std::optional<QPointF> AccuracyChart::placeOf(const GarmentRun* run) const {
    const auto found = std::ranges::find(markers_, run, &Marker::run);
    if (!run || found == markers_.end()) return {};
    return mapFromScene(chart()->mapToScene(chart()->mapToPosition(found->point, found->series)));
}

/// Spacings beside the markers, and a ring round the one that is chosen.
void AccuracyChart::drawForeground(QPainter* painter, const QRectF& rect) {
    QChartView::drawForeground(painter, rect);
    painter->save();
    painter->resetTransform(); // pixels of the view, as placeOf()
    QFont small = font();
    small.setPointSizeF(7.5);
    painter->setFont(small);
    for (const Marker& marker : markers_) {
        const QPointF at = *placeOf(marker.run);
        painter->setPen(colourOf(*marker.run));
        painter->drawText(at + QPointF(markerSize * 0.7, -markerSize * 0.4),
                          QString::number(1e3 * marker.run->spacing, 'g', 3));
    }
    if (const auto at = placeOf(marked_)) {
        painter->setPen(QPen(palette().color(QPalette::Highlight), 2.5));
        painter->drawEllipse(*at, markerSize, markerSize);
    }
    painter->restore();
}

} // namespace toile::ui
