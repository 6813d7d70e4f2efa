// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/DocumentEdits.h"
#include "ui/panels/PropertySheet.h"
#include "ui/values/Words.h"

namespace toile::ui {

/// An edit of core/pattern, edit(pattern, value…), as the setter of a property.
inline auto setting(auto edit) {
    return [edit](const document::Document& document, auto... value) -> DocumentResult {
        return document::edited(document,
                                [&](const pattern::Pattern& p, pattern::IdSource&) { return edit(p, value...); });
    };
}

/// The same of edits of one thing: edit(pattern, id, value…).
inline auto setting(const auto& id, auto edit) {
    return setting([id, edit](const pattern::Pattern& p, auto... value) { return edit(p, id, value...); });
}

} // namespace toile::ui
