// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/SetTacks.h"

#include "core/document/DocumentEdits.h"
#include "core/pattern/PatternTacks.h"
#include "ui/values/Words.h"

#include <fmt/format.h>
#include <utility>

namespace toile::ui {
namespace {

using namespace pattern;

/// The place of the cloth under the pointer, in the piece's own plane.
std::optional<ClothPoint> clothAt(const Desk& desk, Vec2 onTable) {
    const auto piece = pieceAt(desk.flat, onTable);
    const Piece* touched = piece ? findPiece(desk.document.pattern, *piece) : nullptr;
    if (!touched) return std::nullopt;
    return ClothPoint{*piece, onTable - touched->tablePosition};
}

} // namespace

Effect SetTacks::press(const Desk& desk, const PointerEvent& event) {
    if (event.button != Button::left) return {};
    pointer_ = event.position;
    if (!first_) {
        dragged_ = tackEndAt(desk.document.pattern, desk.flat, event.position, event.tolerance);
        if (dragged_) return {.selection = Selection{dragged_->tack}};
    }
    const auto place = clothAt(desk, event.position);
    if (!place) return refusal(tr("There is no piece here."));
    if (!first_) {
        first_ = place;
        return {.selection = Selection{}};
    }
    TackId made;
    Effect effect = effectOf(
        tr("Set tack"), document::edited(desk.document, [&](const Pattern& pattern, IdSource& ids) {
            return addTack(pattern, {*first_, *place}, tr("Tack %1").arg(pattern.tacks.size() + 1).toStdString(), ids)
                .map([&](Pattern next) {
                    made = next.tacks.back().id;
                    return next;
                });
        }));
    if (effect.edit) {
        effect.selection = Selection{made};
        first_.reset();
    }
    return effect;
}

Effect SetTacks::move(const Desk& desk, const PointerEvent& event) {
    pointer_ = event.position;
    if (!dragged_) {
        under_ = first_ ? std::nullopt : tackEndAt(desk.document.pattern, desk.flat, event.position, event.tolerance);
        return {};
    }
    const Tack* tack = findTack(desk.document.pattern, dragged_->tack);
    const Piece* piece = tack ? findPiece(desk.document.pattern, tack->ends[dragged_->end].piece) : nullptr;
    if (!piece) return {};
    return effectOf(tr("Move tack"),
                    document::edited(desk.document,
                                     [&](const Pattern& pattern, IdSource&) {
                                         return moveTackEnd(pattern, dragged_->tack, dragged_->end,
                                                            event.position - piece->tablePosition);
                                     }),
                    fmt::format("tack {} {}", dragged_->tack.value, dragged_->end));
}

Effect SetTacks::release(const Desk&, const PointerEvent&) {
    return {.endsMerge = std::exchange(dragged_, std::nullopt).has_value()};
}

Effect SetTacks::key(const Desk& desk, ToolKey key) {
    if (key == ToolKey::escape) cancel();
    return Tool::key(desk, key);
}

void SetTacks::cancel() {
    first_.reset();
    dragged_.reset();
    under_.reset();
}

Overlay SetTacks::overlay(const Desk& desk) const {
    Overlay overlay;
    const Piece* piece = first_ ? findPiece(desk.document.pattern, first_->piece) : nullptr;
    if (!piece) return overlay;
    const Vec2 from = first_->point + piece->tablePosition;
    overlay.lines.push_back({{from, pointer_}, Overlay::Role::draft, true});
    overlay.marks.push_back({from, Overlay::Role::accent});
    return overlay;
}

std::optional<Item> SetTacks::hovered() const {
    if (!under_) return std::nullopt;
    return under_->tack;
}

QString SetTacks::hint() const {
    return first_ ? tr("Click the place that it is held to.")
                  : tr("Click two places to hold them together; drag an end to move it, Delete takes it out.");
}

} // namespace toile::ui
