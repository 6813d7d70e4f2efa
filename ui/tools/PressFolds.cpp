// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/PressFolds.h"

#include "core/document/DocumentEdits.h"
#include "core/pattern/PatternFolds.h"
#include "ui/tools/DrawPiece.h"
#include "ui/values/ShapeOwner.h"
#include "ui/values/Words.h"

#include <fmt/format.h>
#include <numbers>
#include <utility>

namespace toile::ui {
namespace {

using namespace pattern;

/// Wrong side to wrong side: hems, collars and plackets.
constexpr double pressedFlat = -std::numbers::pi;

} // namespace

Effect PressFolds::press(const Desk& desk, const PointerEvent& event) {
    if (event.button != Button::left) return {};
    pointer_ = event.position;
    return first_ ? goOn(desk, event) : begin(desk, event);
}

Effect PressFolds::begin(const Desk& desk, const PointerEvent& event) {
    if ((dragged_ = foldEndAt(desk.flat, event.position, event.tolerance)))
        return {.selection = Selection{dragged_->fold}};
    if (const auto fold = foldAt(desk.flat, event.position, event.tolerance)) return {.selection = Selection{*fold}};
    first_ = edgeAt(desk.flat, event.position, event.tolerance);
    if (!first_) return refusal(tr("A fold begins on an edge."));
    return {.selection = Selection{}};
}

Effect PressFolds::goOn(const Desk& desk, const PointerEvent& event) {
    const auto end = edgeAt(desk.flat, event.position, event.tolerance);
    if (end && end->edge.piece == first_->edge.piece) return finish(desk, *end);
    if (pieceAt(desk.flat, event.position) != first_->edge.piece)
        return refusal(tr("A fold stays on its piece and ends on an edge of it."));
    between_.push_back(event.position);
    return {};
}

Effect PressFolds::finish(const Desk& desk, const EdgeHit& end) {
    const ShapeOwner owner = shapeOwner(desk.document.pattern, first_->edge.piece);
    FoldRef made{first_->edge.piece, {}};
    Effect effect = effectOf(
        tr("Press fold"), document::edited(desk.document, [&](const Pattern& pattern, IdSource& ids) {
            const std::size_t folds = findPiece(pattern, owner.piece)->folds.size();
            return addFold(pattern, owner.piece,
                           {{{first_->edge.edge, first_->fraction}, {end.edge.edge, end.fraction}}},
                           owner.points(between_), pressedFlat, tr("Fold %1").arg(folds + 1).toStdString(), ids)
                .map([&](Pattern next) {
                    made.fold = findPiece(next, owner.piece)->folds.back().id;
                    return next;
                });
        }));
    if (effect.edit) {
        effect.selection = Selection{made};
        cancel();
    }
    return effect;
}

Effect PressFolds::move(const Desk& desk, const PointerEvent& event) {
    pointer_ = event.position;
    const auto edge = edgeAt(desk.flat, event.position, event.tolerance);
    border_ = edge ? std::optional(edge->point) : std::nullopt;
    if (!dragged_) {
        under_ = first_ ? std::nullopt : foldAt(desk.flat, event.position, event.tolerance);
        return {};
    }
    if (!edge || edge->edge.piece != dragged_->fold.piece) return {};
    const PieceId owner = shapeOwner(desk.document.pattern, dragged_->fold.piece).piece;
    return effectOf(tr("Move fold"),
                    document::edited(desk.document,
                                     [&](const Pattern& pattern, IdSource&) {
                                         return moveFoldEnd(pattern, owner, dragged_->fold.fold, dragged_->end,
                                                            {edge->edge.edge, edge->fraction});
                                     }),
                    fmt::format("fold {} {} {}", owner.value, dragged_->fold.fold.value, dragged_->end));
}

Effect PressFolds::release(const Desk&, const PointerEvent&) {
    return {.endsMerge = std::exchange(dragged_, std::nullopt).has_value()};
}

Effect PressFolds::key(const Desk& desk, ToolKey key) {
    if (key == ToolKey::escape) cancel();
    if (!first_) return Tool::key(desk, key);
    if (key == ToolKey::backspace) {
        if (between_.empty()) first_.reset();
        else between_.pop_back();
    }
    return {};
}

void PressFolds::cancel() {
    first_.reset();
    between_.clear();
    dragged_.reset();
    under_.reset();
    border_.reset();
}

Overlay PressFolds::overlay(const Desk&) const {
    Overlay overlay;
    if (border_) overlay.marks.push_back({*border_, Overlay::Role::hover});
    if (!first_) return overlay;
    std::vector<Vec2> line{first_->point};
    line.insert(line.end(), between_.begin(), between_.end());
    for (const Vec2 point : line) overlay.marks.push_back({point, Overlay::Role::accent});
    line.push_back(border_.value_or(pointer_));
    overlay.lines.push_back({line, Overlay::Role::draft, true});
    return overlay;
}

QString PressFolds::hint() const {
    return first_ ? tr("Click where the fold turns, and the edge that it ends on; Backspace takes the last point back.")
                  : tr("Click an edge to begin a fold; drag an end to move it, Delete takes it out.");
}

} // namespace toile::ui
