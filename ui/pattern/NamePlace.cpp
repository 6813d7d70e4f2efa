// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pattern/NamePlace.h"

#include <QPolygonF>

#include <algorithm>
#include <array>

namespace toile::ui {
namespace {

constexpr double margin = 3; // [pixel] between a name and what it must not hide

bool meets(const QRectF& rect, const QLineF& line) {
    if (rect.contains(line.p1()) || rect.contains(line.p2())) return true;
    const std::array sides{QLineF(rect.topLeft(), rect.topRight()), QLineF(rect.topRight(), rect.bottomRight()),
                           QLineF(rect.bottomRight(), rect.bottomLeft()), QLineF(rect.bottomLeft(), rect.topLeft())};
    return std::ranges::any_of(
        sides, [&](const QLineF& side) { return line.intersects(side, nullptr) == QLineF::BoundedIntersection; });
}

/// On the screen.
std::vector<QLineF> borderOf(const ViewTransform& view, const FlatPiece& piece) {
    std::vector<QLineF> lines;
    for (std::size_t loop = 0; loop < piece.loops(); ++loop)
        for (const auto& edge : piece.flat(loop).edges)
            for (std::size_t i = 1; i < edge.size(); ++i)
                lines.emplace_back(view.toScreen(edge[i - 1]), view.toScreen(edge[i]));
    return lines;
}

} // namespace

QRectF placeOfName(const ViewTransform& view, const FlatPiece& piece, const std::optional<QLineF>& grain, QSizeF size) {
    const geometry::Box2 box = boundsOf(piece);
    const QRectF whole = QRectF(view.toScreen(box.low), view.toScreen(box.high)).normalized();
    QRectF wished({}, size);
    wished.moveCenter(whole.center());
    if (grain) wished.moveTop(std::max(grain->y1(), grain->y2()) + margin);

    std::vector<QLineF> kept = borderOf(view, piece);
    if (grain) kept.push_back(*grain);
    const auto isFree = [&](const QRectF& rect) {
        const QRectF room = rect.adjusted(-margin, -margin, margin, margin);
        return covers(piece, view.toPattern(room.center())) &&
               std::ranges::none_of(kept, [&](const QLineF& line) { return meets(room, line); });
    };
    constexpr int steps = 8; // each way
    std::vector<QRectF> places{wished};
    for (int row = -steps; row <= steps; ++row)
        for (int column = -steps; column <= steps; ++column)
            places.push_back(
                wished.translated(column * whole.width() / (2 * steps), row * whole.height() / (2 * steps)));
    std::ranges::stable_sort(places, {},
                             [&](const QRectF& place) { return QLineF(place.center(), wished.center()).length(); });
    if (const auto found = std::ranges::find_if(places, isFree); found != places.end()) return *found;
    wished.moveTop(whole.bottom() + margin + 1);
    wished.moveLeft(whole.center().x() - wished.width() / 2);
    return wished;
}

} // namespace toile::ui
