// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/tools/SeamDraft.h"

namespace toile::ui {

/// Sews stretches of edges: four clicks, where side one begins and ends, where side two begins and ends. Clicks snap to
/// the ends of the edge and to notches. Backspace takes the last click back, Esc all.
class SewFree : public Tool {
public:
    Effect press(const Desk& desk, const PointerEvent& event) override;
    Effect move(const Desk& desk, const PointerEvent& event) override;
    Effect key(const Desk& desk, ToolKey key) override;
    void cancel() override;
    [[nodiscard]] Overlay overlay(const Desk& desk) const override;
    [[nodiscard]] QString hint() const override;

private:
    std::vector<EdgeHit> picks_; ///< at most three: the fourth sews
    std::optional<EdgeHit> under_;
};

} // namespace toile::ui
