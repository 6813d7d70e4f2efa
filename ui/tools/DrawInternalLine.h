// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/tools/Tool.h"

namespace toile::ui {

/// Draws a line on a piece that is not cut: clicks, then Enter or a double click; Backspace takes the last point back.
class DrawInternalLine : public Tool {
public:
    Effect press(const Desk& desk, const PointerEvent& event) override;
    Effect move(const Desk& desk, const PointerEvent& event) override;
    Effect doubleClick(const Desk& desk, const PointerEvent& event) override;
    Effect key(const Desk& desk, ToolKey key) override;
    void cancel() override { points_.clear(); }
    [[nodiscard]] Overlay overlay(const Desk& desk) const override;
    [[nodiscard]] QString hint() const override;

private:
    Effect finish(const Desk& desk);

    pattern::PieceId piece_;
    std::vector<Vec2> points_; ///< on the table
    Vec2 pointer_;
};

} // namespace toile::ui
