// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/tools/Tool.h"
#include "ui/values/Picking.h"

namespace toile::ui {

/// Sets notches: a click on an edge adds one, drawn to the middle of the edge when near; Shift makes it
/// double. Alt takes the one that is touched out. The properties of the edge tell kind and place of each.
class EditNotches : public Tool {
public:
    Effect press(const Desk& desk, const PointerEvent& event) override;
    Effect move(const Desk& desk, const PointerEvent& event) override;
    Effect key(const Desk& desk, ToolKey key) override;
    void cancel() override { under_.reset(); }
    [[nodiscard]] Overlay overlay(const Desk& desk) const override;
    [[nodiscard]] QString hint() const override;

private:
    std::optional<EdgeHit> under_;
};

} // namespace toile::ui
