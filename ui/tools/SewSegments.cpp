// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/SewSegments.h"

#include "core/document/DocumentEdits.h"
#include "core/pattern/PatternSeams.h"

#include <QCoreApplication>

#include <cmath>

namespace toile::ui {
namespace {

using namespace pattern;

QString tr(const char* text) { return QCoreApplication::translate("Sewing", text); }

/// The picked ends meet; where an edge was picked near its middle, the pattern decides.
Meeting meetingOf(const EdgeHit& a, const EdgeHit& b) {
    const auto nearMiddle = [](const EdgeHit& hit) { return std::abs(hit.fraction - 0.5) < 0.2; };
    if (nearMiddle(a) || nearMiddle(b)) return Meeting::best;
    return (a.fraction < 0.5) == (b.fraction < 0.5) ? Meeting::alike : Meeting::across;
}

/// The part of a seam that an edge would be alone: from the end nearer to the pick.
SeamPart partFrom(const EdgeHit& hit) { return {hit.edge.piece, hit.edge.edge, 0, 1, hit.fraction > 0.5}; }

} // namespace

Effect SewSegments::press(const Desk& desk, const PointerEvent& event) {
    if (event.button != Button::left) return {};
    under_ = edgeAt(desk.flat, event.position, event.tolerance);
    if (!under_) return refusal(tr("There is no edge here."));
    if (const Seam* seam = seamOver(desk.document.pattern, wholeEdge(*under_))) {
        if (first_ || seam->id != made_)
            return refusal(tr("This edge is sewn already, by the seam “%1”.").arg(QString::fromStdString(seam->name)));
        return effectOf(tr("Reverse seam"), document::edited(desk.document, [&](const Pattern& pattern, IdSource&) {
            return reverseSeam(pattern, seam->id);
        }));
    }
    if (!first_ || first_->edge == under_->edge) { // a second click on the same edge may be nearer to its other end
        first_ = under_;
        return {};
    }
    Effect effect = sewn(desk, wholeEdge(*first_), wholeEdge(*under_), meetingOf(*first_, *under_));
    if (effect.edit) {
        made_ = effect.edit->after.pattern.seams.back().id;
        cancel();
    }
    return effect;
}

Effect SewSegments::move(const Desk& desk, const PointerEvent& event) {
    under_ = edgeAt(desk.flat, event.position, event.tolerance);
    return {};
}

Effect SewSegments::key(const Desk&, ToolKey key) {
    if (key == ToolKey::escape || key == ToolKey::erase || key == ToolKey::backspace) cancel();
    return {};
}

void SewSegments::cancel() {
    first_.reset();
    under_.reset();
}

Overlay SewSegments::overlay(const Desk& desk) const {
    Overlay overlay;
    const auto alone = [&](const EdgeHit& hit) {
        if (!seamOver(desk.document.pattern, wholeEdge(hit)))
            addSide(overlay, desk.flat, partFrom(hit), Overlay::Role::sideA);
    };
    if (!first_) {
        if (under_) alone(*under_);
        return overlay;
    }
    const bool both = under_ && !(first_->edge == under_->edge);
    if (!both) {
        alone(*first_);
        return overlay;
    }
    const auto draft = withSeam(desk.document, wholeEdge(*first_), wholeEdge(*under_), meetingOf(*first_, *under_));
    if (!draft) {
        alone(*first_);
        return overlay;
    }
    addSeam(overlay, desk.flat, draft->pattern.seams.back(), under_->point);
    return overlay;
}

std::vector<Item> SewSegments::hovered() const {
    return under_ ? std::vector<Item>{under_->edge} : std::vector<Item>{};
}

QString SewSegments::hint() const {
    if (first_) return tr("Click the second edge near the end that meets the dot on the first; Esc drops the first.");
    if (!made_.empty()) return tr("Click the first edge near the end where the seam begins; click the seam just made to reverse it.");
    return tr("Click the first edge near the end where the seam begins.");
}

} // namespace toile::ui
