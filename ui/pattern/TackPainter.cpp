// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pattern/Colours.h"
#include "ui/pattern/PatternPainter.h"
#include "ui/values/Picking.h"

#include <algorithm>

namespace toile::ui {
namespace {

using namespace pattern;

/// A button with its four holes; its hole on the other piece is a slit of the same length.
void paintButton(QPainter& painter, const ViewTransform& view, QPointF at, double diameter) {
    const double radius = std::max(4.0, 0.5 * diameter * view.scale), hole = 0.3 * radius;
    painter.drawEllipse(at, radius, radius);
    for (const QPointF way : {QPointF(hole, hole), QPointF(hole, -hole), QPointF(-hole, hole), QPointF(-hole, -hole)})
        painter.drawPoint(at + way);
}

void paintButtonhole(QPainter& painter, const ViewTransform& view, QPointF at, double diameter) {
    const double half = std::max(4.0, 0.5 * diameter * view.scale);
    painter.drawLine(at - QPointF(half, 0), at + QPointF(half, 0));
    for (const double end : {-half, half}) painter.drawLine(at + QPointF(end, -2.5), at + QPointF(end, 2.5));
}

void paintCross(QPainter& painter, QPointF at) {
    constexpr double half = 4; // [pixel]
    painter.drawLine(at + QPointF(-half, -half), at + QPointF(half, half));
    painter.drawLine(at + QPointF(-half, half), at + QPointF(half, -half));
}

} // namespace

void paintTacks(QPainter& painter, const ViewTransform& view, const PatternPicture& picture) {
    painter.setBrush(Qt::NoBrush);
    for (const Tack& tack : picture.pattern.tacks) {
        const Item item = tack.id;
        const auto a = positionOf(picture.flat, tack.ends[0]), b = positionOf(picture.flat, tack.ends[1]);
        if (!a || !b) continue;
        const bool hovered = picture.hovered == item;
        const QColor colour = contains(picture.selection, item) ? colours::accent
                              : hovered                         ? colours::hover
                                                                : colours::handle;
        const QPointF from = view.toScreen(*a), to = view.toScreen(*b);
        painter.setPen(QPen(colour, 1, Qt::DotLine));
        painter.drawLine(from, to);
        painter.setPen(QPen(colour, 1.8, Qt::SolidLine, Qt::RoundCap));
        if (tack.buttonDiameter) {
            paintButton(painter, view, from, *tack.buttonDiameter);
            paintButtonhole(painter, view, to, *tack.buttonDiameter);
        } else {
            paintCross(painter, from);
            paintCross(painter, to);
        }
    }
}

} // namespace toile::ui
