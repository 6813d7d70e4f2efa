// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/tools/Tool.h"

namespace toile::ui {

/// Draws a polygon on the piece below its first corner: clicks set corners, a click on the first, a double
/// click or Enter closes, Backspace takes the last back, Esc gives up. Tools say what becomes of it.
class PolygonTool : public Tool {
public:
    Effect press(const Desk& desk, const PointerEvent& event) override;
    Effect move(const Desk& desk, const PointerEvent& event) override;
    Effect doubleClick(const Desk& desk, const PointerEvent& event) override;
    Effect key(const Desk& desk, ToolKey key) override;
    void cancel() override { corners_.clear(); }
    [[nodiscard]] Overlay overlay(const Desk& desk) const override;
    [[nodiscard]] QString hint() const override;

protected:
    /// The corners lie on the table. An effect without an edit keeps them, to be mended.
    [[nodiscard]] virtual Effect made(const Desk& desk, const pattern::PieceId& piece,
                                      const std::vector<Vec2>& corners) const = 0;
    [[nodiscard]] virtual QString firstHint() const = 0;

private:
    [[nodiscard]] bool closes(const PointerEvent& event) const;
    Effect finish(const Desk& desk);

    pattern::PieceId piece_;
    std::vector<Vec2> corners_;
    Vec2 pointer_;
};

} // namespace toile::ui
