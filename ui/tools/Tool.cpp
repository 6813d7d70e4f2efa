// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/Tool.h"

#include "ui/tools/DeleteSelection.h"

namespace toile::ui {

Effect effectOf(const QString& name, Result<document::Document> after, std::string mergeKey) {
    if (!after) return refusal(QString::fromStdString(after.error().text));
    Effect effect;
    effect.edit = Edit{name, std::move(*after), std::move(mergeKey)};
    return effect;
}

Effect refusal(const QString& why) {
    Effect effect;
    effect.message = why;
    effect.refused = true;
    return effect;
}

Effect Tool::key(const Desk& desk, ToolKey key) {
    switch (key) {
    case ToolKey::escape: return {.selection = Selection{}};
    case ToolKey::backspace:
    case ToolKey::erase: return deleteSelection(desk);
    case ToolKey::enter: return {};
    }
    return {};
}

} // namespace toile::ui
