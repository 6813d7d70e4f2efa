// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/tools/Tool.h"

namespace toile::ui {

/// Draws points on the piece below the first of them. A click sets a point, with Shift on a multiple of 45° from the
/// last; a double click or Enter ends the path, and a click on the first point of one that closes; Backspace takes the
/// last back, Esc gives up. Tools say what becomes of it.
class PathTool : public Tool {
public:
    enum class End { closed, open };
    explicit PathTool(End end) : end_(end) {}

    Effect press(const Desk& desk, const PointerEvent& event) override;
    Effect move(const Desk& desk, const PointerEvent& event) override;
    Effect doubleClick(const Desk& desk, const PointerEvent& event) override;
    Effect key(const Desk& desk, ToolKey key) override;
    void cancel() override { points_.clear(); }
    [[nodiscard]] Overlay overlay(const Desk& desk) const override;
    [[nodiscard]] QString hint() const override;

protected:
    /// The points lie on the table. An effect without an edit keeps them, to be mended.
    [[nodiscard]] virtual Effect made(const Desk& desk, const pattern::PieceId& piece,
                                      const std::vector<Vec2>& points) const = 0;
    [[nodiscard]] virtual QString firstHint() const = 0;

private:
    [[nodiscard]] Vec2 next(const PointerEvent& event) const;
    [[nodiscard]] bool closes(const PointerEvent& event) const;
    Effect finish(const Desk& desk);

    End end_;
    pattern::PieceId piece_;
    std::vector<Vec2> points_;
    Vec2 pointer_;
};

} // namespace toile::ui
