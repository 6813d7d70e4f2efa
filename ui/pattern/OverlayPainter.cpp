// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pattern/Colours.h"
#include "ui/pattern/PatternPainter.h"

#include <algorithm>

namespace toile::ui {
namespace {

QColor colourOf(Overlay::Role role) {
    switch (role) {
    case Overlay::Role::draft: return colours::draft;
    case Overlay::Role::accent: return colours::accent;
    case Overlay::Role::hover: return colours::hover;
    case Overlay::Role::sideA: return colours::sideA;
    case Overlay::Role::sideB: return colours::sideB;
    case Overlay::Role::warning: return colours::warning;
    }
    return colours::draft;
}

void paintLine(QPainter& painter, const ViewTransform& view, const Overlay::Line& line) {
    QPolygonF points;
    for (const Vec2 point : line.points) points << view.toScreen(point);
    const QColor colour = colourOf(line.role);
    painter.setPen(QPen(colour, line.width, line.dashed ? Qt::DashLine : Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    if (!line.filled) {
        painter.setBrush(Qt::NoBrush);
        painter.drawPolyline(points);
        return;
    }
    QColor tint = colour;
    tint.setAlphaF(0.14F);
    painter.setBrush(tint);
    painter.drawPolygon(points);
}

void paintLabel(QPainter& painter, const ViewTransform& view, const Overlay::Label& label) {
    const QFontMetricsF metrics(painter.font());
    QRectF place = metrics.boundingRect(label.text).adjusted(-6, -3, 6, 3);
    place.moveBottomLeft(view.toScreen(label.at) + QPointF(12, -10));
    place.moveRight(std::min(place.right(), view.size.width() - 4)); // it stays in the view
    place.moveTop(std::max(place.top(), 24.0));                      // and below the ruler
    painter.setPen(QPen(colourOf(label.role), 1));
    painter.setBrush(QColor(255, 255, 255, 235));
    painter.drawRoundedRect(place, 3, 3);
    painter.setPen(colours::text);
    painter.drawText(place, Qt::AlignCenter, label.text);
}

} // namespace

void paintOverlay(QPainter& painter, const ViewTransform& view, const Overlay& overlay) {
    for (const Overlay::Line& line : overlay.lines) paintLine(painter, view, line);
    for (const Overlay::Circle& circle : overlay.circles) {
        painter.setPen(QPen(colourOf(circle.role), 1.2));
        painter.setBrush(Qt::NoBrush);
        painter.drawEllipse(view.toScreen(circle.centre), circle.radius * view.scale, circle.radius * view.scale);
    }
    for (const Overlay::Arrow& arrow : overlay.arrows)
        paintArrowHead(painter, view.toScreen(arrow.at), {arrow.direction.x, -arrow.direction.y}, 13,
                       colourOf(arrow.role));
    for (const Overlay::Mark& mark : overlay.marks) {
        painter.setPen(QPen(colourOf(mark.role), 1.5));
        painter.setBrush(Qt::white);
        QRectF box(0, 0, 8, 8);
        box.moveCenter(view.toScreen(mark.at));
        if (mark.round) painter.drawEllipse(box);
        else painter.drawRect(box);
    }
    for (const Overlay::Label& label : overlay.labels) paintLabel(painter, view, label);
}

} // namespace toile::ui
