// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/EditPoints.h"

#include "core/document/DocumentEdits.h"
#include "core/pattern/PatternContours.h"
#include "core/pattern/PatternMeasures.h"
#include "ui/tools/DrawPiece.h"

#include <QCoreApplication>

#include <algorithm>
#include <map>

namespace toile::ui {
namespace {

using namespace pattern;

QString tr(const char* text) { return QCoreApplication::translate("EditPoints", text); }

/// The nearest thing that this tool can select.
std::optional<Item> itemAt(const Desk& desk, const PointerEvent& event) {
    if (const auto vertex = vertexAt(desk.flat, event.position, event.tolerance)) return *vertex;
    if (const auto edge = edgeAt(desk.flat, event.position, event.tolerance)) return edge->edge;
    if (const auto piece = pieceAt(desk.flat, event.position)) return *piece;
    return std::nullopt;
}

std::map<PieceId, std::vector<VertexId>> byPiece(const Selection& selection) {
    std::map<PieceId, std::vector<VertexId>> result;
    for (const Item& item : selection)
        if (const auto* vertex = std::get_if<VertexRef>(&item)) result[vertex->piece].push_back(vertex->vertex);
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

/// The vertices that a piece has got.
Selection newVertices(const Pattern& before, const Pattern& after, const PieceId& id) {
    const Piece *old = findPiece(before, id), *now = findPiece(after, id);
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
    Effect effect;
    effect.endsMerge = true;
    drag_ = Drag{std::nullopt, event.position, {}, false};
    ++drags_;
    const bool onVertex = vertexAt(desk.flat, event.position, event.tolerance).has_value();
    if (const auto handle = onVertex ? std::nullopt : handleAt(desk.flat, event.position, event.tolerance)) {
        drag_->handle = handle;
        effect.selection = Selection{handle->edge};
        return effect;
    }
    const auto item = itemAt(desk, event);
    if (!item) {
        drag_.reset();
        if (!event.modifiers.shift) effect.selection = Selection{};
    } else if (event.modifiers.shift) {
        effect.selection = toggled(desk.selection, *item);
    } else if (!contains(desk.selection, *item)) {
        effect.selection = Selection{*item};
    }
    return effect;
}

Effect EditPoints::move(const Desk& desk, const PointerEvent& event) {
    if (!drag_) {
        hovered_ = itemAt(desk, event);
        if (hovered_ && std::holds_alternative<PieceId>(*hovered_)) hovered_.reset();
        return {};
    }
    Vec2 to = event.position;
    if (event.modifiers.shift) to = alignedTo45(drag_->pressedAt, to);
    const Vec2 by = to - drag_->pressedAt;
    if (!drag_->started && length(by) <= event.tolerance / 2) return {};
    drag_->started = true;
    return drag(desk, by);
}

/// Moves what is dragged so that it lies `by` from where it was when the button went down.
Effect EditPoints::drag(const Desk& desk, Vec2 by) {
    const std::string key = "drag points " + std::to_string(drags_);
    if (drag_->handle) {
        const HandleRef handle = *drag_->handle;
        const FlatPiece* piece = findPiece(desk.flat, handle.edge.piece);
        if (!piece) return {};
        const Vec2 to = drag_->pressedAt + by - piece->piece.tablePosition;
        return effectOf(tr("Move handle"), document::edited(desk.document, [&](const Pattern& pattern, IdSource&) {
            return moveHandle(pattern, handle.edge.piece, handle.edge.edge,
                              handle.control == 1 ? Handle::first : Handle::second, to);
        }), key);
    }
    Selection selection = desk.selection;
    for (const Item& item : desk.selection)
        if (const auto* edge = std::get_if<EdgeRef>(&item))
            for (const Item& end : endsOf(desk.flat, *edge))
                if (!contains(selection, end)) selection.push_back(end);
    const Vec2 way = by - drag_->last;
    const auto moved = byPiece(selection);
    if (moved.empty()) return {};
    Effect effect = effectOf(tr("Move points"), document::edited(desk.document, [&](const Pattern& pattern, IdSource&) {
        Result<Pattern> result = pattern;
        for (const auto& [piece, vertices] : moved)
            if (result) result = moveVertices(*result, piece, vertices, way);
        return result;
    }), key);
    if (effect.edit) drag_->last = by;
    return effect;
}

Effect EditPoints::release(const Desk&, const PointerEvent&) {
    drag_.reset();
    Effect effect;
    effect.endsMerge = true;
    return effect;
}

Effect EditPoints::doubleClick(const Desk& desk, const PointerEvent& event) {
    drag_.reset();
    if (vertexAt(desk.flat, event.position, event.tolerance)) return {};
    const auto hit = edgeAt(desk.flat, event.position, event.tolerance);
    if (!hit) return {};
    Effect effect = effectOf(tr("Insert point"), document::edited(desk.document, [&](const Pattern& pattern, IdSource& ids) {
        return insertVertex(pattern, hit->edge.piece, hit->edge.edge, hit->fraction, ids);
    }));
    if (effect.edit) effect.selection = newVertices(desk.document.pattern, effect.edit->after.pattern, hit->edge.piece);
    return effect;
}

Effect EditPoints::key(const Desk& desk, ToolKey key) {
    if (key == ToolKey::escape) {
        Effect effect;
        effect.selection = Selection{};
        return effect;
    }
    if (key != ToolKey::erase && key != ToolKey::backspace) return {};
    const auto doomed = byPiece(desk.selection);
    if (doomed.empty()) return {};
    QString remarks;
    Effect effect = effectOf(tr("Delete points"), document::edited(desk.document, [&](const Pattern& pattern, IdSource&) {
        Result<Pattern> result = pattern;
        for (const auto& [piece, vertices] : doomed)
            for (const VertexId& vertex : vertices) {
                auto edited = deleteVertex(*result, piece, vertex);
                if (!edited) return Result<Pattern>(tl::unexpected(edited.error()));
                for (const Warning& warning : edited->warnings) remarks += QString::fromStdString(warning.text) + QLatin1Char(' ');
                result = std::move(edited->pattern);
            }
        return result;
    }));
    if (effect.edit) effect.message = remarks.trimmed();
    return effect;
}

void EditPoints::cancel() {
    drag_.reset();
    hovered_.reset();
}

std::vector<Item> EditPoints::hovered() const {
    return hovered_ ? std::vector<Item>{*hovered_} : std::vector<Item>{};
}

QString EditPoints::hint() const {
    return tr("Drag points, handles or edges; double-click an edge to insert a point, Delete removes. Shift adds.");
}

} // namespace toile::ui
