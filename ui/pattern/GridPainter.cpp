// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pattern/Colours.h"
#include "ui/pattern/PatternPainter.h"

#include <cmath>

namespace toile::ui {
namespace {

constexpr double rulerWidth = 20; // [pixel]

void paintLines(QPainter& painter, const ViewTransform& view, double step, const QColor& colour) {
    const Vec2 low = view.toPattern({0, view.size.height()}), high = view.toPattern({view.size.width(), 0});
    painter.setPen(QPen(colour, 1));
    for (double i = std::ceil(low.x / step); i <= std::floor(high.x / step); ++i) {
        const double x = std::round(view.toScreen({i * step, 0}).x()) + 0.5;
        painter.drawLine(QPointF(x, 0), QPointF(x, view.size.height()));
    }
    for (double i = std::ceil(low.y / step); i <= std::floor(high.y / step); ++i) {
        const double y = std::round(view.toScreen({0, i * step}).y()) + 0.5;
        painter.drawLine(QPointF(0, y), QPointF(view.size.width(), y));
    }
}

void paintAxes(QPainter& painter, const ViewTransform& view) {
    const QPointF origin = view.toScreen({0, 0});
    painter.setPen(QPen(colours::gridAxis, 1));
    painter.drawLine(QPointF(std::round(origin.x()) + 0.5, 0),
                     QPointF(std::round(origin.x()) + 0.5, view.size.height()));
    painter.drawLine(QPointF(0, std::round(origin.y()) + 0.5),
                     QPointF(view.size.width(), std::round(origin.y()) + 0.5));
}

QString rulerNumber(double metres) {
    const double number = metres * 1000;
    return QString::number(std::abs(number) < 1e-9 ? 0 : number, 'g', 6);
}

} // namespace

double gridStep(const ViewTransform& view, double pixels) {
    const double least = pixels / view.scale;
    const double power = std::pow(10, std::floor(std::log10(least)));
    for (const double factor : {1.0, 2.0, 5.0})
        if (factor * power >= least * (1 - 1e-9)) return factor * power;
    return 10 * power;
}

void paintGrid(QPainter& painter, const ViewTransform& view) {
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing, false);
    paintLines(painter, view, gridStep(view, 12), colours::gridFine);
    paintLines(painter, view, gridStep(view, 60), colours::gridCoarse);
    paintAxes(painter, view);
    painter.restore();
}

void paintRulers(QPainter& painter, const ViewTransform& view) {
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing, false);
    const double width = view.size.width(), height = view.size.height();
    painter.fillRect(QRectF(0, 0, width, rulerWidth), colours::ruler);
    painter.fillRect(QRectF(0, 0, rulerWidth, height), colours::ruler);
    painter.setPen(QPen(colours::gridCoarse, 1));
    painter.drawLine(QPointF(0, rulerWidth + 0.5), QPointF(width, rulerWidth + 0.5));
    painter.drawLine(QPointF(rulerWidth + 0.5, 0), QPointF(rulerWidth + 0.5, height));

    QFont font = painter.font();
    font.setPixelSize(10);
    painter.setFont(font);
    painter.setPen(colours::rulerText);
    const double step = gridStep(view, 60), small = step / 5;
    const Vec2 low = view.toPattern({0, height}), high = view.toPattern({width, 0});
    for (double i = std::ceil(low.x / small); i * small <= high.x; ++i) {
        const double x = std::round(view.toScreen({i * small, 0}).x()) + 0.5;
        const bool major = std::fmod(std::abs(i), 5) == 0;
        if (x < rulerWidth) continue;
        painter.drawLine(QPointF(x, rulerWidth - (major ? 8 : 4)), QPointF(x, rulerWidth - 1));
        if (major) painter.drawText(QPointF(x + 3, 11), rulerNumber(i * small));
    }
    for (double i = std::ceil(low.y / small); i * small <= high.y; ++i) {
        const double y = std::round(view.toScreen({0, i * small}).y()) + 0.5;
        const bool major = std::fmod(std::abs(i), 5) == 0;
        if (y < rulerWidth) continue;
        painter.drawLine(QPointF(rulerWidth - (major ? 8 : 4), y), QPointF(rulerWidth - 1, y));
        if (!major) continue;
        painter.save();
        painter.translate(11, y - 3);
        painter.rotate(-90);
        painter.drawText(QPointF(0, 0), rulerNumber(i * small));
        painter.restore();
    }
    painter.fillRect(QRectF(0, 0, rulerWidth, rulerWidth), colours::ruler);
    painter.drawText(QRectF(0, 0, rulerWidth, rulerWidth), Qt::AlignCenter, QStringLiteral("mm"));
    painter.restore();
}

} // namespace toile::ui
