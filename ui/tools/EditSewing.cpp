// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/EditSewing.h"

#include "core/document/DocumentEdits.h"
#include "core/pattern/PatternSeams.h"
#include "ui/values/Picking.h"
#include "ui/values/Words.h"

namespace toile::ui {
namespace {

using namespace pattern;

std::optional<SeamId> under(const Desk& desk, const PointerEvent& event) {
    return seamAt(desk.document.pattern, desk.flat, event.position, event.tolerance);
}

} // namespace

Effect EditSewing::press(const Desk& desk, const PointerEvent& event) {
    if (event.button != Button::left) return {};
    const auto seam = under(desk, event);
    Effect effect;
    if (seam && event.modifiers.shift) effect.selection = toggled(desk.selection, *seam);
    else effect.selection = seam ? Selection{*seam} : Selection{};
    return effect;
}

Effect EditSewing::move(const Desk& desk, const PointerEvent& event) {
    hovered_ = under(desk, event);
    return {};
}

Effect EditSewing::doubleClick(const Desk& desk, const PointerEvent& event) {
    const auto seam = under(desk, event);
    if (!seam) return {};
    return effectOf(tr("Reverse seam"), document::edited(desk.document, [&](const Pattern& pattern, IdSource&) {
                        return reverseSeam(pattern, *seam);
                    }));
}

QString EditSewing::hint() const {
    return tr("Click a seam to select it; double-click reverses it, Delete takes it out.");
}

} // namespace toile::ui
