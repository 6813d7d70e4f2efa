// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/EditPoints.h"

#include "core/document/DocumentEdits.h"
#include "core/pattern/PatternContours.h"
#include "core/pattern/PatternMeasures.h"
#include "ui/values/ShapeOwner.h"
#include "ui/values/Words.h"

#include <algorithm>
#include <map>
#include <set>

namespace toile::ui {
namespace {

using namespace pattern;

/// The nearest thing that this tool can select.
std::optional<Item> itemAt(const Desk& desk, const PointerEvent& event) {
    if (const auto vertex = vertexAt(desk.flat, event.position, event.tolerance)) return *vertex;
    if (const auto edge = edgeAt(desk.flat, event.position, event.tolerance)) return edge->edge;
    if (const auto piece = pieceAt(desk.flat, event.position)) return *piece;
    return std::nullopt;
}

/// Selected vertices by the piece that was touched; one that is selected in a piece and in its image counts
/// once.
std::map<PieceId, std::vector<VertexId>> byPiece(const Pattern& pattern, const Selection& selection) {
    std::map<PieceId, std::vector<VertexId>> result;
    std::set<std::pair<PieceId, VertexId>> seen;
    for (const Item& item : selection)
        if (const auto* vertex = std::get_if<VertexRef>(&item);
            vertex && seen.insert({shapeOwner(pattern, vertex->piece).piece, vertex->vertex}).second)
            result[vertex->piece].push_back(vertex->vertex);
    return result;
}

/// The vertices at the ends of an edge.
Selection endsOf(const FlatPattern& flat, const EdgeRef& edge) {
    const FlatPiece* piece = findPiece(flat, edge.piece);
    const auto place = piece ? placeOf(piece->piece, edge.edge) : std::nullopt;
    if (!place) return {};
    const auto& vertices = piece->contour(place->loop).vertices;
    return {VertexRef{edge.piece, vertices[place->edge].id},
            VertexRef{edge.piece, vertices[(place->edge + 1) % vertices.size()].id}};
}

/// The vertices that a piece, or the source of an image, has got.
Selection newVertices(const Pattern& before, const Pattern& after, const PieceId& id) {
    const PieceId owner = shapeOwner(before, id).piece;
    const Piece *old = findPiece(before, owner), *now = findPiece(after, owner);
    if (!old || !now) return {};
    Selection found;
    for (std::size_t loop = 0; loop <= now->holes.size(); ++loop)
        for (const Vertex& vertex : loopOf(*now, static_cast<int>(loop)).vertices)
            if (!findVertex(*old, vertex.id)) found.push_back(VertexRef{id, vertex.id});
    return found;
}

} // namespace

Effect EditPoints::press(const Desk& desk, const PointerEvent& event) {
    if (event.button != Button::left) return {};
    Effect effect = dragEnd();
    drag_.emplace(event.position, "drag points", ++drags_);
    const bool onVertex = vertexAt(desk.flat, event.position, event.tolerance).has_value();
    handle_ = onVertex ? std::nullopt : handleAt(desk.flat, event.position, event.tolerance);
    if (handle_) {
        effect.selection = Selection{handle_->edge};
        return effect;
    }
    const auto item = itemAt(desk, event);
    if (!item) drag_.reset();
    effect.selection = pressedSelection(desk.selection, item, event.modifiers.shift);
    return effect;
}

Effect EditPoints::move(const Desk& desk, const PointerEvent& event) {
    if (!drag_) {
        hovered_ = itemAt(desk, event);
        if (hovered_ && std::holds_alternative<PieceId>(*hovered_)) hovered_.reset();
        return {};
    }
    const auto way = drag_->wayTo(event);
    if (!way) return {};
    Effect effect = handle_ ? dragHandle(desk, *way) : dragVertices(desk, *way);
    if (effect.edit) drag_->went(*way);
    return effect;
}

Effect EditPoints::dragHandle(const Desk& desk, Vec2 way) const {
    const ShapeOwner owner = shapeOwner(desk.document.pattern, handle_->edge.piece);
    const Vec2 to = owner.point(drag_->pressedAt() + way);
    const bool first = (handle_->control == 1) != owner.mirror.has_value(); // an image's edges run against the source's
    return effectOf(tr("Move handle"),
                    document::edited(desk.document,
                                     [&](const Pattern& pattern, IdSource&) {
                                         return moveHandle(pattern, owner.piece, handle_->edge.edge,
                                                           first ? Handle::first : Handle::second, to);
                                     }),
                    drag_->mergeKey());
}

Effect EditPoints::dragVertices(const Desk& desk, Vec2 way) const {
    Selection selection = desk.selection;
    for (const Item& item : desk.selection)
        if (const auto* edge = std::get_if<EdgeRef>(&item))
            for (const Item& end : endsOf(desk.flat, *edge))
                if (!contains(selection, end)) selection.push_back(end);
    const auto moved = byPiece(desk.document.pattern, selection);
    if (moved.empty()) return {};
    return effectOf(tr("Move points"),
                    document::edited(desk.document,
                                     [&](const Pattern& pattern, IdSource&) {
                                         Result<Pattern> result = pattern;
                                         for (const auto& [piece, vertices] : moved) {
                                             const ShapeOwner owner = shapeOwner(pattern, piece);
                                             if (result)
                                                 result = moveVertices(*result, owner.piece, vertices,
                                                                       owner.way(drag_->rest(way)));
                                         }
                                         return result;
                                     }),
                    drag_->mergeKey());
}

Effect EditPoints::release(const Desk&, const PointerEvent&) {
    drag_.reset();
    return dragEnd();
}

Effect EditPoints::doubleClick(const Desk& desk, const PointerEvent& event) {
    drag_.reset();
    if (vertexAt(desk.flat, event.position, event.tolerance)) return {};
    const auto hit = edgeAt(desk.flat, event.position, event.tolerance);
    if (!hit) return {};
    Effect effect =
        effectOf(tr("Insert point"), document::edited(desk.document, [&](const Pattern& pattern, IdSource& ids) {
                     return insertVertex(pattern, shapeOwner(pattern, hit->edge.piece).piece, hit->edge.edge,
                                         hit->fraction, ids);
                 }));
    if (effect.edit) effect.selection = newVertices(desk.document.pattern, effect.edit->after.pattern, hit->edge.piece);
    return effect;
}

void EditPoints::cancel() {
    drag_.reset();
    hovered_.reset();
}

QString EditPoints::hint() const {
    return tr("Drag points, handles or edges; double-click an edge to insert a point, Delete removes. Shift adds.");
}

} // namespace toile::ui
