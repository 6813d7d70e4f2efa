// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/tools/Tool.h"

namespace toile::ui {

/// Selects seams; a double click reverses, Delete takes the seam out.
class EditSewing : public Tool {
public:
    Effect press(const Desk& desk, const PointerEvent& event) override;
    Effect move(const Desk& desk, const PointerEvent& event) override;
    Effect doubleClick(const Desk& desk, const PointerEvent& event) override;
    void cancel() override { hovered_.reset(); }
    [[nodiscard]] std::optional<Item> hovered() const override { return hovered_; }
    [[nodiscard]] QString hint() const override;

private:
    std::optional<pattern::SeamId> hovered_;
};

} // namespace toile::ui
