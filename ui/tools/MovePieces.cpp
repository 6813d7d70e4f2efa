// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/MovePieces.h"

#include "core/document/DocumentEdits.h"
#include "core/pattern/PatternPieces.h"
#include "ui/tools/DrawPiece.h"
#include "ui/values/Picking.h"

#include <QCoreApplication>

namespace toile::ui {
namespace {

using namespace pattern;

QString tr(const char* text) { return QCoreApplication::translate("MovePieces", text); }

std::vector<PieceId> piecesIn(const Selection& selection) {
    std::vector<PieceId> pieces;
    for (const Item& item : selection)
        if (const auto* piece = std::get_if<PieceId>(&item)) pieces.push_back(*piece);
    return pieces;
}

Result<Pattern> movedOnTable(Result<Pattern> pattern, const std::vector<PieceId>& pieces, Vec2 by) {
    for (const PieceId& id : pieces)
        if (const Piece* piece = pattern ? findPiece(*pattern, id) : nullptr)
            pattern = movePiece(*pattern, id, piece->tablePosition + by);
    return pattern;
}

} // namespace

Effect MovePieces::press(const Desk& desk, const PointerEvent& event) {
    if (event.button != Button::left) return {};
    Effect effect;
    effect.endsMerge = true;
    const auto piece = pieceAt(desk.flat, event.position);
    ++drags_;
    if (!piece) {
        drag_.reset();
        if (!event.modifiers.shift) effect.selection = Selection{};
        return effect;
    }
    drag_ = Drag{event.position, {}, false};
    if (event.modifiers.shift) effect.selection = toggled(desk.selection, *piece);
    else if (!contains(desk.selection, *piece)) effect.selection = Selection{*piece};
    return effect;
}

Effect MovePieces::move(const Desk& desk, const PointerEvent& event) {
    if (!drag_) {
        hovered_ = pieceAt(desk.flat, event.position);
        return {};
    }
    Vec2 to = event.position;
    if (event.modifiers.shift) to = alignedTo45(drag_->pressedAt, to);
    const Vec2 by = to - drag_->pressedAt;
    if (!drag_->started && length(by) <= event.tolerance / 2) return {};
    drag_->started = true;
    const std::vector<PieceId> pieces = piecesIn(desk.selection);
    if (pieces.empty()) return {};
    Effect effect = effectOf(tr("Move piece"), document::edited(desk.document, [&](const Pattern& pattern, IdSource&) {
        return movedOnTable(pattern, pieces, by - drag_->last);
    }), "move pieces " + std::to_string(drags_));
    if (effect.edit) drag_->last = by;
    return effect;
}

Effect MovePieces::release(const Desk&, const PointerEvent&) {
    drag_.reset();
    Effect effect;
    effect.endsMerge = true;
    return effect;
}

Effect MovePieces::key(const Desk& desk, ToolKey key) {
    Effect effect;
    if (key == ToolKey::escape) effect.selection = Selection{};
    if (key != ToolKey::erase && key != ToolKey::backspace) return effect;
    const std::vector<PieceId> doomed = piecesIn(desk.selection);
    if (doomed.empty()) return {};
    QString remarks;
    effect = effectOf(tr("Delete piece"), document::edited(desk.document, [&](const Pattern& pattern, IdSource&) {
        Result<Pattern> result = pattern;
        for (const PieceId& piece : doomed) {
            if (!findPiece(*result, piece)) continue; // a mirror image that went with its source
            auto edited = deletePiece(*result, piece);
            if (!edited) return Result<Pattern>(tl::unexpected(edited.error()));
            for (const Warning& warning : edited->warnings) remarks += QString::fromStdString(warning.text) + QLatin1Char(' ');
            result = std::move(edited->pattern);
        }
        return result;
    }));
    if (effect.edit) effect.message = remarks.trimmed();
    return effect;
}

void MovePieces::cancel() {
    drag_.reset();
    hovered_.reset();
}

std::vector<Item> MovePieces::hovered() const {
    return hovered_ ? std::vector<Item>{*hovered_} : std::vector<Item>{};
}

QString MovePieces::hint() const {
    return tr("Drag pieces to where you want them on the table; Shift adds to the selection, Delete takes out.");
}

} // namespace toile::ui
