// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/tools/DragWay.h"
#include "ui/values/Picking.h"

namespace toile::ui {

/// Selects and moves vertices, Bézier handles and edges of pieces. A double click on an edge inserts a
/// vertex, Delete removes the selected ones; Shift while picking adds, while dragging keeps the way on a
/// multiple of 45°. What is done to a mirror image is done to its source.
class EditPoints : public Tool {
public:
    Effect press(const Desk& desk, const PointerEvent& event) override;
    Effect move(const Desk& desk, const PointerEvent& event) override;
    Effect release(const Desk& desk, const PointerEvent& event) override;
    Effect doubleClick(const Desk& desk, const PointerEvent& event) override;
    void cancel() override;
    [[nodiscard]] std::optional<Item> hovered() const override { return hovered_; }
    [[nodiscard]] QString hint() const override;
    [[nodiscard]] bool showsPoints() const override { return true; }

private:
    Effect dragHandle(const Desk& desk, Vec2 way) const;
    Effect dragVertices(const Desk& desk, Vec2 way) const;

    std::optional<DragWay> drag_;
    std::optional<HandleRef> handle_; ///< that is dragged; none = the selected vertices are
    std::optional<Item> hovered_;
    int drags_ = 0; ///< makes the merge key of each drag its own
};

} // namespace toile::ui
