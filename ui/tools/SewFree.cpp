// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/SewFree.h"

#include "ui/tools/DeleteSelection.h"
#include "ui/values/Words.h"

#include <cmath>

namespace toile::ui {
namespace {

using namespace pattern;

/// The place on an edge, drawn to an end or a notch within the tolerance.
std::optional<EdgeHit> snappedHit(const FlatPattern& flat, const PointerEvent& event) {
    auto hit = edgeAt(flat, event.position, event.tolerance);
    if (!hit) return hit;
    const FlatPiece& piece = *findPiece(flat, hit->edge.piece);
    const std::vector<Vec2> path = pathOf(flat, SeamPart{hit->edge.piece, hit->edge.edge});
    std::vector<double> places{0, 1};
    for (const Notch& notch : piece.piece.notches)
        if (notch.edge == hit->edge.edge) places.push_back(piece.piece.mirror ? 1 - notch.position : notch.position);
    for (const double place : places)
        if (distance(pointAlong(path, place).position, event.position) <= event.tolerance) {
            hit->fraction = place;
            hit->point = pointAlong(path, place).position;
        }
    return hit;
}

} // namespace

Effect SewFree::press(const Desk& desk, const PointerEvent& event) {
    if (event.button != Button::left) return {};
    under_ = snappedHit(desk.flat, event);
    if (!under_) return refusal(tr("There is no edge here."));
    const bool ends = picks_.size() % 2 == 1; // this click ends a side
    if (ends && !(picks_.back().edge == under_->edge)) return refusal(tr("A side ends on the edge on which it began."));
    if (ends && std::abs(picks_.back().fraction - under_->fraction) < 1e-6)
        return refusal(tr("A side needs two different points."));
    if (ends) {
        const SeamPart part = stretch(picks_.back(), *under_);
        if (const Seam* seam = seamOver(desk.document.pattern, {part.piece, part.edge, part.from, part.to}))
            return refusal(
                tr("Some of this is sewn already, by the seam “%1”.").arg(QString::fromStdString(seam->name)));
    }
    if (picks_.size() < 3) {
        picks_.push_back(*under_);
        return {};
    }
    const SeamSides sides{{{stretch(picks_[0], picks_[1])}, {stretch(picks_[2], *under_)}}};
    Effect effect = sewn(desk, withSeam(desk.document, sides));
    if (effect.edit) cancel();
    return effect;
}

Effect SewFree::move(const Desk& desk, const PointerEvent& event) {
    under_ = snappedHit(desk.flat, event);
    return {};
}

Effect SewFree::key(const Desk& desk, ToolKey key) {
    if (key == ToolKey::erase && picks_.empty()) return deleteSelection(desk);
    if (key == ToolKey::escape) cancel();
    else if (key != ToolKey::enter && !picks_.empty()) picks_.pop_back();
    return {};
}

void SewFree::cancel() {
    picks_.clear();
    under_.reset();
}

Overlay SewFree::overlay(const Desk& desk) const {
    Overlay overlay;
    std::vector<EdgeHit> picks = picks_;
    if (under_ && picks.size() % 2 == 1 && picks.back().edge == under_->edge) picks.push_back(*under_);
    const auto role = [](std::size_t side) { return side == 0 ? Overlay::Role::sideA : Overlay::Role::sideB; };
    for (std::size_t side = 0; side < 2; ++side) {
        if (picks.size() == 2 * side + 1) overlay.marks.push_back({picks.back().point, role(side)});
        if (picks.size() >= 2 * side + 2 && picks.size() < 4)
            addSide(overlay, desk.flat, {stretch(picks[2 * side], picks[2 * side + 1])}, role(side));
    }
    if (under_) overlay.marks.push_back({under_->point, Overlay::Role::hover});
    if (picks.size() == 4)
        addSeam(overlay, desk.flat, {{{stretch(picks[0], picks[1])}, {stretch(picks[2], picks[3])}}},
                picks.back().point);
    return overlay;
}

QString SewFree::hint() const {
    switch (picks_.size()) {
    case 0: return tr("Click where side one begins.");
    case 1: return tr("Click where side one ends, on the same edge.");
    case 2: return tr("Click where side two begins: it meets the beginning of side one.");
    default: return tr("Click where side two ends, on the same edge.");
    }
}

} // namespace toile::ui
