// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/SewSegments.h"

#include "core/document/DocumentEdits.h"
#include "core/pattern/PatternSeams.h"
#include "ui/tools/DeleteSelection.h"
#include "ui/values/Words.h"

#include <algorithm>

namespace toile::ui {
namespace {

using namespace pattern;

/// The picks without edges that have gone from the document since.
std::vector<EdgeHit> existing(const Desk& desk, std::vector<EdgeHit> picks) {
    std::erase_if(picks, [&](const EdgeHit& hit) { return pathOf(desk.flat, hit.edge).size() < 2; });
    return picks;
}

} // namespace

Effect SewSegments::press(const Desk& desk, const PointerEvent& event) {
    if (event.button != Button::left) return {};
    for (auto& side : picks_) side = existing(desk, side);
    under_ = edgeAt(desk.flat, event.position, event.tolerance);
    if (!under_) return refusal(tr("There is no edge here."));
    if (const Seam* seam = seamOver(desk.document.pattern, wholeEdge(*under_))) {
        if (!picks_[0].empty() || seam->id != made_)
            return refusal(tr("This edge is sewn already, by the seam “%1”.").arg(QString::fromStdString(seam->name)));
        return effectOf(tr("Reverse seam"), document::edited(desk.document, [&](const Pattern& pattern, IdSource&) {
                            return reverseSeam(pattern, seam->id);
                        }));
    }
    if (isPicked(under_->edge)) {
        if (picks_[0].size() > 1 || !picks_[1].empty())
            return refusal(tr("This edge is picked already; Backspace takes the last one back."));
        picks_[0].front() = *under_; // a second click may be nearer to its other end
        return {};
    }
    picks_[side_].push_back(*under_);
    return event.modifiers.shift ? Effect{} : endSide(desk);
}

/// Side one is complete, or both are.
Effect SewSegments::endSide(const Desk& desk) {
    if (picks_[side_].empty()) return {};
    if (side_ == 0) {
        side_ = 1;
        return {};
    }
    Effect effect = sewn(desk, withSeam(desk, picks_[0], picks_[1]));
    if (effect.edit) {
        made_ = effect.edit->after.pattern.seams.back().id;
        dropPicks();
    } else {
        picks_[1].pop_back();
    }
    return effect;
}

bool SewSegments::isPicked(const EdgeRef& edge) const {
    return std::ranges::any_of(
        picks_, [&](const auto& side) { return std::ranges::find(side, edge, &EdgeHit::edge) != side.end(); });
}

Effect SewSegments::move(const Desk& desk, const PointerEvent& event) {
    under_ = edgeAt(desk.flat, event.position, event.tolerance);
    return {};
}

Effect SewSegments::key(const Desk& desk, ToolKey key) {
    switch (key) {
    case ToolKey::enter: return endSide(desk);
    case ToolKey::escape: dropPicks(); return {};
    case ToolKey::erase:
        if (picks_[0].empty()) return deleteSelection(desk);
        [[fallthrough]];
    case ToolKey::backspace: takeBack(); return {};
    }
    return {};
}

void SewSegments::takeBack() {
    if (picks_[1].empty()) side_ = 0;
    if (!picks_[side_].empty()) picks_[side_].pop_back();
}

void SewSegments::cancel() {
    dropPicks();
    made_ = {};
}

void SewSegments::dropPicks() {
    for (auto& side : picks_) side.clear();
    side_ = 0;
    under_.reset();
}

Overlay SewSegments::overlay(const Desk& desk) const {
    Overlay overlay;
    std::array<std::vector<EdgeHit>, 2> picks{existing(desk, picks_[0]), existing(desk, picks_[1])};
    if (under_ && !isPicked(under_->edge) && !existing(desk, {*under_}).empty() &&
        !seamOver(desk.document.pattern, wholeEdge(*under_)))
        picks[side_].push_back(*under_); // what a click would do
    if (!picks[0].empty() && !picks[1].empty())
        if (const auto draft = withSeam(desk, picks[0], picks[1])) {
            addSeam(overlay, desk.flat, draft->pattern.seams.back().sides, picks[1].back().point);
            return overlay;
        }
    addSide(overlay, desk.flat, chainOf(desk, picks[0]), Overlay::Role::sideA);
    return overlay;
}

std::optional<Item> SewSegments::hovered() const {
    if (!under_) return std::nullopt;
    return under_->edge;
}

QString SewSegments::hint() const {
    if (side_ == 1 && !picks_[1].empty())
        return tr("Shift-click further edges of side two; click the last one or press Enter to sew.");
    if (side_ == 1)
        return tr("Click side two near the end that meets the dot; Shift-click if more edges follow. "
                  "Backspace takes back.");
    if (!picks_[0].empty())
        return tr("Shift-click further edges of side one; click the last one or press Enter to go on to side two.");
    if (!made_.empty())
        return tr("Click side one near the end where the seam begins; click the seam just made to reverse it.");
    return tr("Click side one near the end where the seam begins; Shift-click if more edges follow.");
}

} // namespace toile::ui
