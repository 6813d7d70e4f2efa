// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/DocumentEdits.h"
#include "core/pattern/PatternRegions.h"
#include "ui/tools/PaintRegion.h"
#include "ui/values/Picking.h"

#include <QCoreApplication>

namespace toile::ui {
namespace {

using namespace pattern;

QString tr(const char* text) { return QCoreApplication::translate("PaintRegion", text); }

} // namespace

Effect deleteRegions(const Desk& desk) {
    if (!lastOf<RegionRef>(desk.selection)) return {};
    return effectOf(tr("Delete region"), document::edited(desk.document, [&](const Pattern& pattern, IdSource&) {
        Result<Pattern> result = pattern;
        for (const Item& item : desk.selection)
            if (const auto* region = std::get_if<RegionRef>(&item); region && result)
                result = removeRegion(*result, region->piece, region->region);
        return result;
    }));
}

Effect PaintPolygon::press(const Desk& desk, const PointerEvent& event) {
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

Effect PaintPolygon::move(const Desk&, const PointerEvent& event) {
    pointer_ = event.position;
    return {};
}

Effect PaintPolygon::doubleClick(const Desk& desk, const PointerEvent&) { return finish(desk); }

Effect PaintPolygon::key(const Desk& desk, ToolKey key) {
    switch (key) {
    case ToolKey::enter: return finish(desk);
    case ToolKey::backspace:
        if (!corners_.empty()) corners_.pop_back();
        return {};
    case ToolKey::escape: cancel(); return {};
    case ToolKey::erase: return deleteRegions(desk);
    }
    return {};
}

void PaintPolygon::cancel() { corners_.clear(); }

bool PaintPolygon::closes(const PointerEvent& event) const {
    return corners_.size() >= 3 && distance(corners_.front(), event.position) <= event.tolerance;
}

Effect PaintPolygon::finish(const Desk& desk) {
    if (corners_.empty()) return {};
    const FlatPiece* piece = findPiece(desk.flat, piece_);
    if (!piece) { // it was deleted meanwhile
        cancel();
        return {};
    }
    Polygon outline = corners_;
    for (Vec2& corner : outline) corner -= piece->piece.tablePosition;
    const std::string name = tr("Region %1").arg(piece->piece.regions.size() + 1).toStdString();
    Effect effect = effectOf(tr("Paint region"), document::edited(desk.document, [&](const Pattern& pattern, IdSource& ids) {
        return addRegion(pattern, piece_, outline, name, options_.refinement, ids);
    }));
    if (!effect.edit) return effect;
    effect.selection = Selection{RegionRef{piece_, findPiece(effect.edit->after.pattern, piece_)->regions.back().id}};
    cancel();
    return effect;
}

Overlay PaintPolygon::overlay(const Desk&) const {
    Overlay overlay;
    if (corners_.empty()) return overlay;
    std::vector<Vec2> shape = corners_;
    shape.push_back(pointer_);
    overlay.lines.push_back({shape, Overlay::Role::accent, true, shape.size() > 2});
    for (const Vec2 corner : corners_) overlay.marks.push_back({corner, Overlay::Role::accent, false});
    return overlay;
}

QString PaintPolygon::hint() const {
    if (corners_.empty()) return tr("Click the corners of the region, on a piece.");
    return tr("Click the first corner, double-click or press Enter to close; Backspace takes the last back, Esc gives up.");
}

} // namespace toile::ui
