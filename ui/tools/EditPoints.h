// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/tools/Tool.h"
#include "ui/values/Picking.h"

namespace toile::ui {

/// Selects and moves vertices, Bézier handles and edges of pieces. A double click on an edge inserts a vertex, Delete
/// removes the selected ones; Shift while picking adds, while dragging keeps the way on a multiple of 45°.
class EditPoints : public Tool {
public:
    Effect press(const Desk& desk, const PointerEvent& event) override;
    Effect move(const Desk& desk, const PointerEvent& event) override;
    Effect release(const Desk& desk, const PointerEvent& event) override;
    Effect doubleClick(const Desk& desk, const PointerEvent& event) override;
    Effect key(const Desk& desk, ToolKey key) override;
    void cancel() override;
    [[nodiscard]] std::vector<Item> hovered() const override;
    [[nodiscard]] QString hint() const override;
    [[nodiscard]] bool showsPoints() const override { return true; }

private:
    /// What is being dragged: the selected vertices, or one handle.
    struct Drag {
        std::optional<HandleRef> handle;
        Vec2 pressedAt;
        Vec2 last; ///< where the dragged things are now, relative to pressedAt
        bool started = false;
    };
    Effect drag(const Desk& desk, Vec2 by);

    std::optional<Drag> drag_;
    std::optional<Item> hovered_;
    int drags_ = 0; ///< makes the merge key of each drag its own
};

} // namespace toile::ui
