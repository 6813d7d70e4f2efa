// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pattern/PatternPainter.h"
#include "ui/pattern/Colours.h"
#include "ui/pattern/NamePlace.h"
#include "ui/values/Picking.h"

#include <QPainterPath>

#include <algorithm>
#include <cmath>

namespace toile::ui {
namespace {

using namespace pattern;

/// Mesh lines nearer than this are not drawn one by one: they would only darken the piece [pixel].
constexpr double densestMesh = 2.5;

QPolygonF onScreen(const ViewTransform& view, std::span<const Vec2> points) {
    QPolygonF polygon;
    for (const Vec2 point : points) polygon << view.toScreen(point);
    return polygon;
}

void addClosed(QPainterPath& path, const ViewTransform& view, std::span<const Vec2> points) {
    path.addPolygon(onScreen(view, points));
    path.closeSubpath();
}

QPainterPath shapeOf(const FlatPiece& piece, const ViewTransform& view) {
    QPainterPath path;
    addClosed(path, view, piece.outline.polygon);
    for (const FlatContour& hole : piece.holes) addClosed(path, view, hole.polygon);
    return path;
}

std::size_t fabricIndex(const Pattern& pattern, const FabricId& fabric) {
    for (std::size_t i = 0; i < pattern.fabrics.size(); ++i)
        if (pattern.fabrics[i]->id == fabric) return i;
    return 0;
}

/// What is cut, under the piece: of it the seam allowances stay to be seen.
void paintCutLine(QPainter& painter, const ViewTransform& view, const FlatPiece& piece) {
    QPainterPath path;
    for (const Area& area : piece.cut) {
        addClosed(path, view, area.outline);
        for (const Polygon& hole : area.holes) addClosed(path, view, hole);
    }
    painter.setBrush(colours::allowance);
    painter.setPen(QPen(colours::quiet, 1));
    painter.drawPath(path);
}

/// Round a piece that is selected or pointed at: its seams keep their colours.
void paintHalo(QPainter& painter, const QPainterPath& shape, QColor colour) {
    colour.setAlphaF(0.35F);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(colour, 9, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPath(shape);
}

/// Inside the piece; a region that is selected or pointed at is seen as it was painted.
void paintRegions(QPainter& painter, const ViewTransform& view, const FlatPiece& piece, const PatternPicture& picture) {
    for (const Region& region : piece.piece.regions) {
        QPainterPath path;
        addClosed(path, view, region.outline);
        for (const Polygon& hole : region.holes) addClosed(path, view, hole);
        const Item item = RegionRef{piece.piece.id, region.id};
        const bool selected = contains(picture.selection, item);
        const bool hovered = picture.hovered == item;
        QColor border = colours::regionTint(region.refinement).darker(150);
        border.setAlphaF(1);
        painter.setBrush(colours::regionTint(region.refinement));
        painter.setPen(selected  ? QPen(colours::accent, 2)
                       : hovered ? QPen(colours::hover, 2)
                                 : QPen(border, 1, Qt::DashLine));
        if (!selected && !hovered) painter.setClipPath(shapeOf(piece, view));
        painter.drawPath(path);
        painter.setClipping(false);
    }
}

void paintMesh(QPainter& painter, const ViewTransform& view, const PieceLines& mesh, Vec2 tablePosition) {
    if (mesh.spacing * view.scale < densestMesh) return;
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing, mesh.spacing * view.scale > 8);
    painter.setTransform(view.matrix(), true);
    painter.translate(tablePosition.x, tablePosition.y);
    QColor colour = colours::outline;
    colour.setAlphaF(mesh.spacing * view.scale > 8 ? 0.34F : 0.22F);
    QPen pen(colour, 1);
    pen.setCosmetic(true);
    painter.setPen(pen);
    painter.drawLines(mesh.lines);
    painter.restore();
}

/// The grain line on the screen, from its tail to its head; none where the piece is too small to show it.
std::optional<QLineF> grainLine(const ViewTransform& view, const FlatPiece& piece) {
    const geometry::Box2 box = boundsOf(piece);
    const double half = 0.28 * std::min(box.high.y - box.low.y, box.high.x - box.low.x);
    const Vec2 centre = lerp(box.low, box.high, 0.5), warp = geometry::rotated({0, 1}, piece.piece.grain);
    const QLineF line(view.toScreen(centre - warp * half), view.toScreen(centre + warp * half));
    return line.length() < 24 ? std::nullopt : std::optional(line);
}

void paintGrain(QPainter& painter, const ViewTransform& view, const FlatPiece& piece) {
    const auto line = grainLine(view, piece);
    if (!line) return;
    painter.setPen(QPen(colours::quiet, 1));
    painter.drawLine(*line);
    paintArrowHead(painter, line->p2(), line->p2() - line->p1(), 7, colours::quiet);
}

void paintNotches(QPainter& painter, const ViewTransform& view, const FlatPiece& piece) {
    constexpr double depth = 6, apart = 4; // [pixel]
    painter.setPen(QPen(colours::outline, 1.4));
    for (const Notch& notch : piece.piece.notches) {
        const auto place = placeOf(piece.piece, notch.edge);
        if (!place) continue;
        const PathPoint point = pointAlong(piece.flat(place->loop).edges[place->edge], notch.position);
        const double size = length(point.direction);
        if (size <= 0) continue;
        const QPointF at = view.toScreen(point.position);
        const QPointF along(point.direction.x / size, -point.direction.y / size);
        const QPointF inward(along.y(), -along.x()); // left of the contour, on a screen with y down
        const auto mark = [&](QPointF from) {
            if (notch.kind == NotchKind::v) {
                painter.drawLine(from - along * 3, from + inward * depth);
                painter.drawLine(from + along * 3, from + inward * depth);
            } else {
                painter.drawLine(from, from + inward * depth);
                if (notch.kind == NotchKind::t)
                    painter.drawLine(from + inward * depth - along * 3, from + inward * depth + along * 3);
            }
        };
        if (notch.isDouble) {
            mark(at - along * (apart / 2));
            mark(at + along * (apart / 2));
        } else {
            mark(at);
        }
    }
}

void paintInternalLines(QPainter& painter, const ViewTransform& view, const Piece& piece) {
    painter.setPen(QPen(colours::quiet, 1, Qt::DashLine));
    painter.setBrush(Qt::NoBrush);
    for (const InternalLine& line : piece.internalLines) painter.drawPolyline(onScreen(view, line.points));
}

void paintName(QPainter& painter, const ViewTransform& view, const FlatPiece& piece) {
    const geometry::Box2 box = boundsOf(piece);
    const QString name = QString::fromStdString(piece.piece.name);
    const QFontMetricsF metrics(painter.font());
    const QRectF text = metrics.boundingRect(name);
    if (text.width() > (box.high.x - box.low.x) * view.scale) return;
    const QRectF place = placeOfName(view, piece, grainLine(view, piece), {text.width() + 12, metrics.height() + 4});
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(255, 255, 255, 200));
    painter.drawRoundedRect(place, 3, 3);
    painter.setPen(colours::text);
    painter.drawText(place, Qt::AlignCenter, name);
}

/// Selected and hovered edges and pieces, above everything else of the piece.
void paintHighlights(QPainter& painter, const ViewTransform& view, const FlatPiece& piece,
                     const PatternPicture& picture) {
    painter.setBrush(Qt::NoBrush);
    const auto highlight = [&](const Item& item, const QColor& colour) {
        if (pieceOf(item) != piece.piece.id) return;
        painter.setPen(QPen(colour, 2.4, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        if (std::holds_alternative<PieceId>(item)) paintHalo(painter, shapeOf(piece, view), colour);
        if (const auto* edge = std::get_if<EdgeRef>(&item))
            if (const auto place = placeOf(piece.piece, edge->edge))
                painter.drawPolyline(onScreen(view, piece.flat(place->loop).edges[place->edge]));
    };
    for (const Item& item : picture.selection) highlight(item, colours::accent);
    if (picture.hovered && !contains(picture.selection, *picture.hovered)) highlight(*picture.hovered, colours::hover);
}

} // namespace

void paintArrowHead(QPainter& painter, QPointF at, QPointF direction, double size, const QColor& colour) {
    const double length = std::hypot(direction.x(), direction.y());
    if (length <= 0) return;
    const QPointF along = direction / length, across(-along.y(), along.x());
    painter.save();
    painter.setPen(Qt::NoPen);
    painter.setBrush(colour);
    painter.drawPolygon(
        QPolygonF{at, at - along * size + across * (size * 0.45), at - along * size - across * (size * 0.45)});
    painter.restore();
}

void paintPieces(QPainter& painter, const ViewTransform& view, const PatternPicture& picture) {
    for (std::size_t i = 0; i < picture.flat.pieces.size(); ++i) {
        const FlatPiece& piece = picture.flat.pieces[i];
        const QPainterPath shape = shapeOf(piece, view);
        if (picture.look.cutLines) paintCutLine(painter, view, piece);
        painter.setPen(Qt::NoPen);
        QColor tint = colours::fabricTint(fabricIndex(picture.pattern, piece.piece.fabric));
        tint.setAlphaF(0.92F);
        painter.fillPath(shape, tint);
        if (picture.look.regions) paintRegions(painter, view, piece, picture);
        if (picture.look.mesh && i < picture.mesh.size())
            paintMesh(painter, view, picture.mesh[i], piece.piece.tablePosition);
        paintInternalLines(painter, view, piece.piece);
        paintFolds(painter, view, piece, picture);
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(colours::outline, 1.4, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        painter.drawPath(shape);
        paintNotches(painter, view, piece);
        paintGrain(painter, view, piece);
        paintHighlights(painter, view, piece, picture);
        if (picture.look.names) paintName(painter, view, piece);
    }
}

void paintPoints(QPainter& painter, const ViewTransform& view, const PatternPicture& picture) {
    for (const FlatPiece& piece : picture.flat.pieces)
        for (std::size_t loop = 0; loop < piece.loops(); ++loop) {
            const Contour& contour = piece.contour(loop);
            for (std::size_t edge = 0; edge < contour.edges.size(); ++edge)
                if (const auto* cubic = std::get_if<geometry::CubicShape>(&contour.edges[edge].shape)) {
                    const geometry::Curve curve = curveOf(contour, edge);
                    painter.setPen(QPen(colours::handle, 1));
                    painter.drawLine(view.toScreen(curve.start), view.toScreen(cubic->control1));
                    painter.drawLine(view.toScreen(curve.end), view.toScreen(cubic->control2));
                    painter.setBrush(colours::handle);
                    painter.drawEllipse(view.toScreen(cubic->control1), 3, 3);
                    painter.drawEllipse(view.toScreen(cubic->control2), 3, 3);
                }
            for (const Vertex& vertex : contour.vertices) {
                const Item item = VertexRef{piece.piece.id, vertex.id};
                const bool selected = contains(picture.selection, item);
                const bool hovered = picture.hovered == item;
                painter.setPen(QPen(selected || hovered ? colours::accent : colours::outline, 1.2));
                painter.setBrush(selected ? colours::accent : hovered ? colours::hover : QColor(Qt::white));
                QRectF square(0, 0, 7, 7);
                square.moveCenter(view.toScreen(vertex.position));
                painter.drawRect(square);
            }
        }
}

/// A ring; two for a pin to the body.
void paintPins(QPainter& painter, const ViewTransform& view, const PatternPicture& picture) {
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(colours::warning, 2.4));
    for (const Pin& pin : picture.pattern.pins)
        if (const auto at = positionOf(picture.flat, VertexRef{pin.piece, pin.vertex})) {
            painter.drawEllipse(view.toScreen(*at), 7, 7);
            if (pin.toBody) painter.drawEllipse(view.toScreen(*at), 11, 11);
        }
}

void paint(QPainter& painter, const ViewTransform& view, const PatternPicture& picture) {
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(QRectF({0, 0}, view.size), colours::canvas);
    if (picture.look.grid) paintGrid(painter, view);
    paintPieces(painter, view, picture);
    if (picture.look.seams) paintSeams(painter, view, picture);
    if (picture.look.vertices) paintPoints(painter, view, picture);
    paintTacks(painter, view, picture);
    paintPins(painter, view, picture);
    paintOverlay(painter, view, picture.overlay);
    if (picture.look.grid) paintRulers(painter, view);
}

} // namespace toile::ui
