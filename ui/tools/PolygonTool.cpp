// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/PolygonTool.h"

#include "ui/tools/DeleteSelection.h"
#include "ui/values/Picking.h"

#include <QCoreApplication>

namespace toile::ui {
namespace {

QString tr(const char* text) {
    return QCoreApplication::translate("PolygonTool", text);
}

} // namespace

Effect PolygonTool::press(const Desk& desk, const PointerEvent& event) {
    if (event.button != Button::left) return {};
    if (closes(event)) return finish(desk);
    if (corners_.empty()) {
        const auto piece = pieceAt(desk.flat, event.position);
        if (!piece) return refusal(tr("Begin on a piece."));
        piece_ = *piece;
    }
    corners_.push_back(event.position);
    pointer_ = event.position;
    return {};
}

Effect PolygonTool::move(const Desk&, const PointerEvent& event) {
    pointer_ = event.position;
    return {};
}

Effect PolygonTool::doubleClick(const Desk& desk, const PointerEvent&) {
    return finish(desk);
}

Effect PolygonTool::key(const Desk& desk, ToolKey key) {
    switch (key) {
    case ToolKey::enter: return finish(desk);
    case ToolKey::backspace:
        if (!corners_.empty()) corners_.pop_back();
        return {};
    case ToolKey::escape: cancel(); return {};
    case ToolKey::erase: return corners_.empty() ? deleteSelection(desk) : Effect{};
    }
    return {};
}

bool PolygonTool::closes(const PointerEvent& event) const {
    return corners_.size() >= 3 && distance(corners_.front(), event.position) <= event.tolerance;
}

Effect PolygonTool::finish(const Desk& desk) {
    if (corners_.empty()) return {};
    if (!findPiece(desk.flat, piece_)) { // it was deleted meanwhile
        cancel();
        return {};
    }
    Effect effect = made(desk, piece_, corners_);
    if (effect.edit) cancel();
    return effect;
}

Overlay PolygonTool::overlay(const Desk&) const {
    Overlay overlay;
    if (corners_.empty()) return overlay;
    std::vector<Vec2> shape = corners_;
    shape.push_back(pointer_);
    overlay.lines.push_back({shape, Overlay::Role::accent, true, shape.size() > 2});
    for (const Vec2 corner : corners_) overlay.marks.push_back({corner, Overlay::Role::accent, false});
    return overlay;
}

QString PolygonTool::hint() const {
    if (corners_.empty()) return firstHint();
    return tr("Click the first corner, double-click or press Enter to close; Backspace takes the last back, "
              "Esc gives up.");
}

} // namespace toile::ui
