// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/EditNotches.h"

#include "core/document/DocumentEdits.h"
#include "core/pattern/PatternContours.h"
#include "ui/tools/DeleteSelection.h"
#include "ui/values/ShapeOwner.h"
#include "ui/values/Units.h"
#include "ui/values/Words.h"

#include <cmath>

namespace toile::ui {
namespace {

using namespace pattern;

/// The place on an edge; its middle when that is near.
std::optional<EdgeHit> hitAt(const FlatPattern& flat, const PointerEvent& event) {
    auto hit = edgeAt(flat, event.position, event.tolerance);
    if (!hit) return hit;
    const std::vector<Vec2> path = pathOf(flat, hit->edge);
    if (const Vec2 middle = pointAlong(path, 0.5).position; distance(middle, event.position) <= event.tolerance) {
        hit->fraction = 0.5;
        hit->point = middle;
    }
    return hit;
}

/// The notch of the edge within the tolerance, as its owner counts them.
std::optional<std::size_t> notchAt(const Desk& desk, const EdgeHit& hit, double tolerance) {
    const Piece* owner = findPiece(desk.document.pattern, shapeOwner(desk.document.pattern, hit.edge.piece).piece);
    const double length = lengthOf(pathOf(desk.flat, hit.edge));
    for (std::size_t i = 0; owner && i < owner->notches.size(); ++i)
        if (owner->notches[i].edge == hit.edge.edge &&
            std::abs(owner->notches[i].position - hit.fraction) * length <= tolerance)
            return i;
    return std::nullopt;
}

} // namespace

Effect EditNotches::press(const Desk& desk, const PointerEvent& event) {
    if (event.button != Button::left) return {};
    under_ = hitAt(desk.flat, event);
    if (!under_) return refusal(tr("There is no edge here."));
    const PieceId piece = shapeOwner(desk.document.pattern, under_->edge.piece).piece;
    const auto touched = notchAt(desk, *under_, event.tolerance);
    Effect effect;
    if (event.modifiers.alt && !touched) return refusal(tr("There is no notch here."));
    if (!event.modifiers.alt && touched)
        return refusal(tr("There is a notch here already; its edge's properties change it."));
    if (event.modifiers.alt)
        effect = effectOf(tr("Take notch out"), document::edited(desk.document, [&](const Pattern& pattern, IdSource&) {
                              return removeNotch(pattern, piece, *touched);
                          }));
    else
        effect =
            effectOf(tr("Set notch"), document::edited(desk.document, [&](const Pattern& pattern, IdSource&) {
                         return addNotch(pattern, piece,
                                         {under_->edge.edge, under_->fraction, NotchKind::slit, event.modifiers.shift});
                     }));
    effect.selection = Selection{under_->edge};
    return effect;
}

Effect EditNotches::move(const Desk& desk, const PointerEvent& event) {
    under_ = hitAt(desk.flat, event);
    return {};
}

Effect EditNotches::key(const Desk& desk, ToolKey key) {
    return key == ToolKey::erase ? deleteSelection(desk) : Effect{};
}

Overlay EditNotches::overlay(const Desk& desk) const {
    Overlay overlay;
    if (!under_) return overlay;
    const std::vector<Vec2> path = pathOf(desk.flat, SeamPart{under_->edge.piece, under_->edge.edge, 0, 1, false});
    if (path.size() < 2) return overlay;
    const double length = lengthOf(path);
    overlay.lines.push_back({path, Overlay::Role::hover});
    overlay.marks.push_back({under_->point, Overlay::Role::accent});
    overlay.labels.push_back({under_->point,
                              tr("%1 and %2 from the ends")
                                  .arg(textOf(Quantity::length, under_->fraction * length),
                                       textOf(Quantity::length, (1 - under_->fraction) * length)),
                              Overlay::Role::accent});
    return overlay;
}

QString EditNotches::hint() const {
    return tr("Click an edge to set a notch, Shift-click a double one; Alt-click takes one out.");
}

} // namespace toile::ui
