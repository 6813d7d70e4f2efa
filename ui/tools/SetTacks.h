// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/tools/Tool.h"
#include "ui/values/Picking.h"

namespace toile::ui {

/// Sets tacks and buttons: a click on a piece and a click on another, or on the same, hold the two places together.
/// An end that is there is selected by a click and dragged; Delete takes the tack out.
class SetTacks : public Tool {
public:
    Effect press(const Desk& desk, const PointerEvent& event) override;
    Effect move(const Desk& desk, const PointerEvent& event) override;
    Effect release(const Desk& desk, const PointerEvent& event) override;
    Effect key(const Desk& desk, ToolKey key) override;
    void cancel() override;
    [[nodiscard]] Overlay overlay(const Desk& desk) const override;
    [[nodiscard]] std::optional<Item> hovered() const override;
    [[nodiscard]] QString hint() const override;

private:
    std::optional<pattern::ClothPoint> first_; ///< where the tack begins that is being set
    std::optional<TackEnd> dragged_, under_;
    Vec2 pointer_; ///< on the table [m]
};

} // namespace toile::ui
