// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/DragWay.h"

#include "ui/tools/DrawPiece.h"

namespace toile::ui {

std::optional<Vec2> DragWay::wayTo(const PointerEvent& event) {
    const Vec2 to = event.modifiers.shift ? alignedTo45(pressedAt_, event.position) : event.position;
    const Vec2 way = to - pressedAt_;
    if (!started_ && length(way) <= event.tolerance / 2) return std::nullopt;
    started_ = true;
    return way;
}

Effect dragEnd() {
    Effect effect;
    effect.endsMerge = true;
    return effect;
}

std::optional<Selection> pressedSelection(const Selection& selection, const std::optional<Item>& item, bool shift) {
    if (!item) return shift ? std::nullopt : std::optional(Selection{});
    if (shift) return toggled(selection, *item);
    return contains(selection, *item) ? std::nullopt : std::optional(Selection{*item});
}

} // namespace toile::ui
