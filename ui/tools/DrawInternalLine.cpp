// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/DrawInternalLine.h"

#include "core/document/DocumentEdits.h"
#include "core/pattern/Editing.h"
#include "ui/tools/DeleteSelection.h"
#include "ui/tools/DrawPiece.h"
#include "ui/values/Picking.h"
#include "ui/values/ShapeOwner.h"

#include <QCoreApplication>

namespace toile::ui {
namespace {

using namespace pattern;

QString tr(const char* text) {
    return QCoreApplication::translate("DrawInternalLine", text);
}

} // namespace

Effect DrawInternalLine::press(const Desk& desk, const PointerEvent& event) {
    if (event.button != Button::left) return {};
    if (points_.empty()) {
        const auto piece = pieceAt(desk.flat, event.position);
        if (!piece) return refusal(tr("Begin on a piece."));
        piece_ = *piece;
    }
    const bool aligned = event.modifiers.shift && !points_.empty();
    points_.push_back(aligned ? alignedTo45(points_.back(), event.position) : event.position);
    pointer_ = points_.back();
    return {};
}

Effect DrawInternalLine::move(const Desk&, const PointerEvent& event) {
    const bool aligned = event.modifiers.shift && !points_.empty();
    pointer_ = aligned ? alignedTo45(points_.back(), event.position) : event.position;
    return {};
}

Effect DrawInternalLine::doubleClick(const Desk& desk, const PointerEvent&) {
    return finish(desk);
}

Effect DrawInternalLine::key(const Desk& desk, ToolKey key) {
    if (key == ToolKey::enter) return finish(desk);
    if (key == ToolKey::erase && points_.empty()) return deleteSelection(desk);
    if (key == ToolKey::escape) cancel();
    if (key == ToolKey::backspace && !points_.empty()) points_.pop_back();
    return {};
}

Effect DrawInternalLine::finish(const Desk& desk) {
    const FlatPiece* piece = findPiece(desk.flat, piece_);
    if (points_.size() < 2 || !piece) {
        cancel();
        return {};
    }
    const ShapeOwner owner = shapeOwner(desk.document.pattern, piece_);
    const std::vector<Vec2> points = owner.points(points_);
    cancel();
    const std::string name = tr("Line %1").arg(piece->piece.internalLines.size() + 1).toStdString();
    return effectOf(tr("Draw internal line"), document::edited(desk.document, [&](const Pattern& pattern, IdSource&) {
                        return changedShape(pattern, owner.piece, [&](Piece& changed) -> Result<void> {
                            changed.internalLines.push_back({name, points});
                            return {};
                        });
                    }));
}

Overlay DrawInternalLine::overlay(const Desk&) const {
    Overlay overlay;
    if (points_.empty()) return overlay;
    std::vector<Vec2> path = points_;
    path.push_back(pointer_);
    overlay.lines.push_back({path, Overlay::Role::draft, true});
    for (const Vec2 point : points_) overlay.marks.push_back({point, Overlay::Role::draft});
    return overlay;
}

QString DrawInternalLine::hint() const {
    if (points_.empty()) return tr("Click the points of the line, on a piece.");
    return tr("Press Enter or double-click to end the line; Backspace takes the last point back, Esc gives up.");
}

} // namespace toile::ui
