// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/tools/Tool.h"
#include "ui/values/Picking.h"

namespace toile::ui {

/// Presses folds: a click on an edge begins one, clicks on the piece make it turn, a click on another edge ends it. A
/// fold that is there is selected by a click on it; its ends are dragged along the border, Delete takes it out.
class PressFolds : public Tool {
public:
    Effect press(const Desk& desk, const PointerEvent& event) override;
    Effect move(const Desk& desk, const PointerEvent& event) override;
    Effect release(const Desk& desk, const PointerEvent& event) override;
    Effect key(const Desk& desk, ToolKey key) override;
    void cancel() override;
    [[nodiscard]] Overlay overlay(const Desk& desk) const override;
    [[nodiscard]] std::optional<Item> hovered() const override { return under_; }
    [[nodiscard]] QString hint() const override;

private:
    Effect begin(const Desk& desk, const PointerEvent& event);
    Effect goOn(const Desk& desk, const PointerEvent& event);
    [[nodiscard]] Effect finish(const Desk& desk, const EdgeHit& end);

    std::optional<EdgeHit> first_; ///< where the fold begins that is being drawn
    std::vector<Vec2> between_;    ///< on the table [m]
    std::optional<FoldEnd> dragged_;
    std::optional<FoldRef> under_;
    std::optional<Vec2> border_; ///< of the edge under the pointer, on the table [m]
    Vec2 pointer_;               ///< on the table [m]
};

} // namespace toile::ui
