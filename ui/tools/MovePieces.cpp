// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/MovePieces.h"

#include "core/document/DocumentEdits.h"
#include "core/pattern/PatternPieces.h"
#include "ui/values/Picking.h"
#include "ui/values/Words.h"

namespace toile::ui {
namespace {

using namespace pattern;

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
    Effect effect = dragEnd();
    const auto piece = pieceAt(desk.flat, event.position);
    drag_.reset();
    if (piece) drag_.emplace(event.position, "move pieces", ++drags_);
    effect.selection =
        pressedSelection(desk.selection, piece ? std::optional<Item>(*piece) : std::nullopt, event.modifiers.shift);
    return effect;
}

Effect MovePieces::move(const Desk& desk, const PointerEvent& event) {
    if (!drag_) {
        hovered_ = pieceAt(desk.flat, event.position);
        return {};
    }
    const auto way = drag_->wayTo(event);
    const std::vector<PieceId> pieces = piecesIn(desk.selection);
    if (!way || pieces.empty()) return {};
    Effect effect = effectOf(
        tr("Move piece"),
        document::edited(desk.document, [&](const Pattern& pattern,
                                            IdSource&) { return movedOnTable(pattern, pieces, drag_->rest(*way)); }),
        drag_->mergeKey());
    if (effect.edit) drag_->went(*way);
    return effect;
}

Effect MovePieces::release(const Desk&, const PointerEvent&) {
    drag_.reset();
    return dragEnd();
}

void MovePieces::cancel() {
    drag_.reset();
    hovered_.reset();
}

QString MovePieces::hint() const {
    return tr("Drag pieces to where you want them on the table; Shift adds to the selection, Delete takes out.");
}

} // namespace toile::ui
