// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/CutDart.h"

#include "core/document/DocumentEdits.h"
#include "core/pattern/PatternDarts.h"
#include "ui/tools/DeleteSelection.h"
#include "ui/values/ShapeOwner.h"
#include "ui/values/Units.h"
#include "ui/values/Words.h"

#include <algorithm>

namespace toile::ui {
namespace {

using namespace pattern;

/// The edge as its source walks it: fractions count along it.
std::vector<Vec2> edgePath(const FlatPattern& flat, const EdgeRef& edge) {
    return pathOf(flat, SeamPart{edge.piece, edge.edge, 0, 1, false});
}

/// The two ends of the mouth.
std::array<Vec2, 2> mouthEnds(const std::vector<Vec2>& path, double middle, double width) {
    const double half = width / 2 / lengthOf(path);
    return {pointAlong(path, middle - half).position, pointAlong(path, middle + half).position};
}

/// Darts are seams of a piece with itself.
QString newName(const Pattern& pattern) {
    const auto darts = std::ranges::count_if(pattern.seams, [](const Seam& seam) {
        const auto &in = seam.sides[0], &out = seam.sides[1];
        return in.size() == 1 && out.size() == 1 && in.front().piece == out.front().piece;
    });
    return tr("Dart %1").arg(darts + 1);
}

} // namespace

Vec2 CutDart::tipAt(const Desk& desk, const PointerEvent& event) const {
    const std::vector<Vec2> path = edgePath(desk.flat, mouth_->edge);
    if (!event.modifiers.shift || path.size() < 2) return event.position;
    const Vec2 across = normalized(geometry::leftOf(pointAlong(path, mouth_->fraction).direction));
    return mouth_->point + across * dot(event.position - mouth_->point, across);
}

Effect CutDart::press(const Desk& desk, const PointerEvent& event) {
    if (event.button != Button::left) return {};
    if (!mouth_) {
        mouth_ = edgeAt(desk.flat, event.position, event.tolerance);
        tip_ = event.position;
        return mouth_ ? Effect{} : refusal(tr("There is no edge here."));
    }
    const ShapeOwner owner = shapeOwner(desk.document.pattern, mouth_->edge.piece);
    const Dart dart{mouth_->edge.edge, mouth_->fraction, options_.width, owner.point(tipAt(desk, event))};
    const std::size_t seams = desk.document.pattern.seams.size();
    Effect effect =
        effectOf(tr("Cut dart"), document::edited(desk.document, [&](const Pattern& pattern, IdSource& ids) {
                     return addDart(pattern, owner.piece, dart, newName(pattern).toStdString(), ids);
                 }));
    if (!effect.edit) return effect; // the mouth stays: the tip may be better elsewhere
    if (const auto& now = effect.edit->after.pattern.seams; now.size() > seams)
        effect.selection = Selection{now[seams].id};
    cancel();
    return effect;
}

Effect CutDart::move(const Desk& desk, const PointerEvent& event) {
    if (mouth_) tip_ = tipAt(desk, event);
    else under_ = edgeAt(desk.flat, event.position, event.tolerance);
    return {};
}

Effect CutDart::key(const Desk& desk, ToolKey key) {
    if (key == ToolKey::erase && !mouth_) return deleteSelection(desk);
    if (key == ToolKey::escape || key == ToolKey::backspace) cancel();
    return {};
}

void CutDart::cancel() {
    mouth_.reset();
    under_.reset();
}

Overlay CutDart::overlay(const Desk& desk) const {
    Overlay overlay;
    const auto& hit = mouth_ ? mouth_ : under_;
    if (!hit) return overlay;
    const std::vector<Vec2> path = edgePath(desk.flat, hit->edge);
    if (path.size() < 2) return overlay;
    const auto [from, to] = mouthEnds(path, hit->fraction, options_.width);
    if (!mouth_) {
        overlay.lines.push_back({{from, to}, Overlay::Role::accent, false, false, 4});
        return overlay;
    }
    overlay.lines.push_back({{from, tip_, to}, Overlay::Role::sideA, false, true, 2});
    overlay.lines.push_back({{mouth_->point, tip_}, Overlay::Role::sideA, true, false, 1});
    overlay.marks.push_back({tip_, Overlay::Role::sideA});
    overlay.labels.push_back(
        {tip_,
         tr("%1 wide, %2 deep")
             .arg(textOf(Quantity::length, options_.width), textOf(Quantity::length, distance(mouth_->point, tip_))),
         Overlay::Role::sideA});
    return overlay;
}

QString CutDart::hint() const {
    if (mouth_) return tr("Click the tip of the dart; Shift keeps it upright on the edge, Esc drops it.");
    return tr("Click an edge where the middle of the dart's mouth is to be.");
}

} // namespace toile::ui
