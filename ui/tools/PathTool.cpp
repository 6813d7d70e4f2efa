// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/PathTool.h"

#include "ui/tools/DeleteSelection.h"
#include "ui/tools/DrawPiece.h"
#include "ui/values/Picking.h"
#include "ui/values/Words.h"

namespace toile::ui {

Effect PathTool::press(const Desk& desk, const PointerEvent& event) {
    if (event.button != Button::left) return {};
    if (closes(event)) return finish(desk);
    if (points_.empty()) {
        const auto piece = pieceAt(desk.flat, event.position);
        if (!piece) return refusal(tr("Begin on a piece."));
        piece_ = *piece;
    }
    pointer_ = next(event);
    points_.push_back(pointer_);
    return {};
}

Effect PathTool::move(const Desk&, const PointerEvent& event) {
    pointer_ = next(event);
    return {};
}

Effect PathTool::doubleClick(const Desk& desk, const PointerEvent&) {
    return finish(desk);
}

Effect PathTool::key(const Desk& desk, ToolKey key) {
    switch (key) {
    case ToolKey::enter: return finish(desk);
    case ToolKey::backspace:
        if (!points_.empty()) points_.pop_back();
        return {};
    case ToolKey::escape: cancel(); return {};
    case ToolKey::erase: return points_.empty() ? deleteSelection(desk) : Effect{};
    }
    return {};
}

Vec2 PathTool::next(const PointerEvent& event) const {
    const bool aligned = event.modifiers.shift && !points_.empty();
    return aligned ? alignedTo45(points_.back(), event.position) : event.position;
}

bool PathTool::closes(const PointerEvent& event) const {
    return end_ == End::closed && points_.size() >= 3 && distance(points_.front(), event.position) <= event.tolerance;
}

Effect PathTool::finish(const Desk& desk) {
    const bool isNothing = points_.size() < (end_ == End::open ? 2 : 1);
    if (isNothing || !findPiece(desk.flat, piece_)) { // the piece was deleted meanwhile
        cancel();
        return {};
    }
    Effect effect = made(desk, piece_, points_);
    if (effect.edit) cancel();
    return effect;
}

Overlay PathTool::overlay(const Desk&) const {
    Overlay overlay;
    if (points_.empty()) return overlay;
    std::vector<Vec2> shape = points_;
    shape.push_back(pointer_);
    const bool isClosed = end_ == End::closed && shape.size() > 2;
    overlay.lines.push_back({shape, Overlay::Role::accent, true, isClosed});
    for (const Vec2 point : points_) overlay.marks.push_back({point, Overlay::Role::accent, false});
    return overlay;
}

QString PathTool::hint() const {
    if (points_.empty()) return firstHint();
    if (end_ == End::open)
        return tr("Press Enter or double-click to end the line; Backspace takes the last point back, Esc gives up.");
    return tr("Click the first corner, double-click or press Enter to close; Backspace takes the last back, "
              "Esc gives up.");
}

} // namespace toile::ui
