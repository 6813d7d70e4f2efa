// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/Document.h"
#include "ui/tools/Overlay.h"
#include "ui/values/FlatPattern.h"
#include "ui/values/PointerEvent.h"
#include "ui/values/Selection.h"

#include <optional>
#include <string>

namespace toile::ui {

/// What lies before a tool: the document, the same as it is drawn, and what is selected.
struct Desk {
    const document::Document& document;
    const FlatPattern& flat;
    const Selection& selection;
};

/// One step that can be undone.
struct Edit {
    QString name; ///< for the menu
    document::Document after;
    std::string mergeKey = {}; ///< steps in a row with the same key that is not empty are one
};

/// What comes of an event: nothing, or some of these.
struct Effect {
    std::optional<Edit> edit;
    bool endsMerge = false; ///< a drag has ended: the next edit is a step of its own
    std::optional<Selection> selection;
    QString message;      ///< for the status line
    bool refused = false; ///< the message says why something was not done
};

/// The edit, or a refusal with the error's sentence.
[[nodiscard]] Effect effectOf(const QString& name, Result<document::Document> after, std::string mergeKey = {});
[[nodiscard]] Effect refusal(const QString& why);

/// A state machine fed with plain events. It keeps ids and points, never references into a document: the document may
/// change between two events.
class Tool {
public:
    virtual ~Tool() = default;

    virtual Effect press(const Desk&, const PointerEvent&) { return {}; }
    virtual Effect move(const Desk&, const PointerEvent&) { return {}; }
    virtual Effect release(const Desk&, const PointerEvent&) { return {}; }
    /// The second press of a double click comes here, not to `press`.
    virtual Effect doubleClick(const Desk&, const PointerEvent&) { return {}; }
    /// Esc selects nothing; Delete and Backspace take out what is selected.
    virtual Effect key(const Desk& desk, ToolKey key);
    /// Turns of the wheel with Ctrl held; true when the tool used them.
    virtual bool wheel(double) { return false; }
    /// Back to the beginning, without an edit.
    virtual void cancel() {}

    [[nodiscard]] virtual Overlay overlay(const Desk&) const { return {}; }
    /// What a click would take hold of.
    [[nodiscard]] virtual std::optional<Item> hovered() const { return std::nullopt; }
    /// What to do next, for the status line.
    [[nodiscard]] virtual QString hint() const = 0;
    /// Vertices and handles are drawn while this tool is in use.
    [[nodiscard]] virtual bool showsPoints() const { return false; }
};

} // namespace toile::ui
