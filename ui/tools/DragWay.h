// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/tools/Tool.h"

namespace toile::ui {

/// How far something is dragged. Edits of one drag are one step: they share a merge key.
class DragWay {
public:
    /// `name` makes the merge key, `number` makes it this drag's own.
    DragWay(Vec2 pressedAt, const char* name, int number)
        : pressedAt_(pressedAt), mergeKey_(std::string(name) + ' ' + std::to_string(number)) {}

    /// Where the pointer has got to since the press; none while it has hardly moved. With Shift on a multiple
    /// of 45°.
    [[nodiscard]] std::optional<Vec2> wayTo(const PointerEvent& event);
    /// What of a way is still to go.
    [[nodiscard]] Vec2 rest(Vec2 way) const { return way - gone_; }
    void went(Vec2 way) { gone_ = way; }

    [[nodiscard]] Vec2 pressedAt() const { return pressedAt_; }
    [[nodiscard]] const std::string& mergeKey() const { return mergeKey_; }

private:
    Vec2 pressedAt_, gone_;
    std::string mergeKey_;
    bool started_ = false;
};

/// The end of a drag: the next edit is a step of its own.
[[nodiscard]] Effect dragEnd();
/// What a press on a thing selects: it alone, or with Shift it besides the others. Nothing where the press is
/// the beginning of a drag of all that is selected.
[[nodiscard]] std::optional<Selection> pressedSelection(const Selection& selection, const std::optional<Item>& item,
                                                        bool shift);

} // namespace toile::ui
