// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pattern/Colours.h"
#include "ui/pattern/PatternPainter.h"

#include <algorithm>
#include <cmath>

namespace toile::ui {
namespace {

using namespace pattern;

void paintPath(QPainter& painter, const ViewTransform& view, const std::vector<Vec2>& path) {
    QPolygonF line;
    for (const Vec2 point : path) line << view.toScreen(point);
    painter.drawPolyline(line);
}

QPointF screenDirection(Vec2 direction) {
    return {direction.x, -direction.y};
}

/// A dot where the side begins and an arrow head a little later: the points that meet, not flags.
void paintDirection(QPainter& painter, const ViewTransform& view, const std::vector<std::vector<Vec2>>& paths,
                    const QColor& colour) {
    if (paths.empty()) return;
    painter.setBrush(colour);
    painter.setPen(Qt::NoPen);
    painter.drawEllipse(view.toScreen(paths.front().front()), 3.2, 3.2);
    for (const auto& path : paths) {
        const PathPoint middle = pointAlong(path, 0.5);
        if (lengthOf(path) * view.scale < 26) continue;
        const QPointF along = screenDirection(middle.direction);
        const double size = std::max(std::hypot(along.x(), along.y()), 1e-12);
        paintArrowHead(painter, view.toScreen(middle.position) + along / size * 5, along, 10, colour);
    }
}

void paintPartners(QPainter& painter, const ViewTransform& view, const std::vector<std::vector<Vec2>>& a,
                   const std::vector<std::vector<Vec2>>& b, QColor colour) {
    constexpr int links = 8;
    if (a.empty() || b.empty()) return;
    colour.setAlphaF(0.65F);
    painter.setPen(QPen(colour, 1, Qt::DashLine));
    for (int i = 0; i <= links; ++i) {
        const double fraction = double(i) / links;
        painter.drawLine(view.toScreen(pointAlong(a, fraction).position),
                         view.toScreen(pointAlong(b, fraction).position));
    }
}

} // namespace

void paintSeams(QPainter& painter, const ViewTransform& view, const PatternPicture& picture) {
    for (std::size_t i = 0; i < picture.pattern.seams.size(); ++i) {
        const Seam& seam = picture.pattern.seams[i];
        const Item item = seam.id;
        const bool selected = contains(picture.selection, item);
        const bool hovered = picture.hovered == item;
        const QColor colour = hovered && !selected ? colours::hover : colours::distinct(i);
        const auto sideA = pathsOf(picture.flat, seam.sides[0]), sideB = pathsOf(picture.flat, seam.sides[1]);
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(colour, selected || hovered ? 4 : 2.2, Qt::SolidLine, Qt::FlatCap, Qt::RoundJoin));
        for (const auto* side : {&sideA, &sideB})
            for (const auto& path : *side) paintPath(painter, view, path);
        if (selected) paintPartners(painter, view, sideA, sideB, colour);
        paintDirection(painter, view, sideA, colour);
        paintDirection(painter, view, sideB, colour);
    }
}

} // namespace toile::ui
