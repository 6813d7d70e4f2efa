// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/DocumentEdits.h"
#include "core/pattern/Brush.h"
#include "core/pattern/PatternRegions.h"
#include "ui/tools/DeleteSelection.h"
#include "ui/tools/PaintRegion.h"
#include "ui/values/Picking.h"
#include "ui/values/ShapeOwner.h"
#include "ui/values/Words.h"

#include <algorithm>
#include <cmath>

namespace toile::ui {
namespace {

using namespace pattern;

constexpr double smallestRadius = 0.002, largestRadius = 0.3; // [m]

const Region* findRegion(const Pattern& pattern, const RegionRef& ref) {
    const Piece* piece = findPiece(pattern, shapeOwner(pattern, ref.piece).piece);
    if (!piece) return nullptr;
    const auto found = std::ranges::find(piece->regions, ref.region, &Region::id);
    return found == piece->regions.end() ? nullptr : &*found;
}

/// The region that a stroke beginning at a point would add to, the likelier first.
std::vector<RegionRef> candidates(const Desk& desk, const PieceId& piece, Vec2 begin, int refinement) {
    std::vector<RegionRef> result;
    const auto consider = [&](const RegionRef& ref) {
        const Region* region = findRegion(desk.document.pattern, ref);
        if (region && ref.piece == piece && region->refinement == refinement) result.push_back(ref);
    };
    if (const auto under = regionAt(desk.flat, begin)) consider(*under);
    if (const auto* selected = lastOf<RegionRef>(desk.selection)) consider(*selected);
    return result;
}

} // namespace

Effect PaintBrush::press(const Desk& desk, const PointerEvent& event) {
    pointer_ = event.position;
    if (event.button != Button::left) return {};
    const auto piece = pieceAt(desk.flat, event.position);
    if (!piece) return refusal(tr("Begin on a piece."));
    stroke_ = Stroke{*piece, {event.position}, event.modifiers.alt};
    return {};
}

Effect PaintBrush::move(const Desk&, const PointerEvent& event) {
    pointer_ = event.position;
    if (stroke_ && distance(stroke_->points.back(), event.position) > options_.radius / 8)
        stroke_->points.push_back(event.position);
    return {};
}

Effect PaintBrush::release(const Desk& desk, const PointerEvent&) {
    if (!stroke_) return {};
    Stroke stroke = std::move(*stroke_);
    stroke_.reset();
    const FlatPiece* piece = findPiece(desk.flat, stroke.piece);
    if (!piece) return {};
    return stroke.erases ? erase(desk, stroke) : paint(desk, stroke);
}

Effect PaintBrush::paint(const Desk& desk, const Stroke& drawn) const {
    const ShapeOwner owner = shapeOwner(desk.document.pattern, drawn.piece);
    const pattern::Stroke stroke{owner.points(drawn.points), options_.radius};
    for (const RegionRef& region : candidates(desk, drawn.piece, drawn.points.front(), options_.refinement)) {
        Effect effect =
            effectOf(tr("Paint region"), document::edited(desk.document, [&](const Pattern& pattern, IdSource&) {
                         return paintRegion(pattern, owner.piece, region.region, stroke);
                     }));
        if (!effect.edit) continue; // the stroke does not touch it
        effect.selection = Selection{region};
        return effect;
    }
    const std::string name =
        tr("Region %1").arg(findPiece(desk.flat, drawn.piece)->piece.regions.size() + 1).toStdString();
    Effect effect =
        effectOf(tr("Paint region"), document::edited(desk.document, [&](const Pattern& pattern, IdSource& ids) {
                     return paintNewRegion(pattern, owner.piece, stroke, name, options_.refinement, ids);
                 }));
    if (effect.edit)
        effect.selection =
            Selection{RegionRef{drawn.piece, findPiece(effect.edit->after.pattern, owner.piece)->regions.back().id}};
    return effect;
}

Effect PaintBrush::erase(const Desk& desk, const Stroke& drawn) const {
    std::optional<RegionRef> region = regionAt(desk.flat, drawn.points.front());
    if (const auto* selected = lastOf<RegionRef>(desk.selection); !region && selected && selected->piece == drawn.piece)
        region = *selected;
    if (!region) return refusal(tr("There is no region here to take away from."));
    const ShapeOwner owner = shapeOwner(desk.document.pattern, drawn.piece);
    const pattern::Stroke stroke{owner.points(drawn.points), options_.radius};
    return effectOf(tr("Erase region"), document::edited(desk.document, [&](const Pattern& pattern, IdSource& ids) {
                        return eraseRegion(pattern, owner.piece, region->region, stroke, ids);
                    }));
}

Effect PaintBrush::key(const Desk& desk, ToolKey key) {
    if (key == ToolKey::escape) cancel();
    if (key == ToolKey::erase) return deleteSelection(desk);
    return {};
}

bool PaintBrush::wheel(double notches) {
    options_.radius = std::clamp(options_.radius * std::pow(1.15, notches), smallestRadius, largestRadius);
    return true;
}

void PaintBrush::cancel() {
    stroke_.reset();
}

Overlay PaintBrush::overlay(const Desk&) const {
    Overlay overlay;
    const bool erases = stroke_ && stroke_->erases;
    const Overlay::Role role = erases ? Overlay::Role::warning : Overlay::Role::accent;
    if (stroke_)
        for (const Area& area : swept(stroke_->points, options_.radius)) {
            overlay.lines.push_back({area.outline, role, false, true, 1});
            for (const Polygon& hole : area.holes) overlay.lines.push_back({hole, role, false, false, 1});
        }
    overlay.circles.push_back({pointer_, options_.radius, role});
    return overlay;
}

QString PaintBrush::hint() const {
    return tr(
        "Paint on a piece; Alt takes away, Ctrl and the wheel change the brush, Delete removes the selected region.");
}

} // namespace toile::ui
