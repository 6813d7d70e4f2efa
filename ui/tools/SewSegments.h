// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/tools/SeamDraft.h"

namespace toile::ui {

/// Sews two whole edges: one click each. The end of an edge that lies nearer to the click is where the seam begins, so
/// the two picked ends meet; arrows and links show it before the second click. A click on an edge of the seam just made
/// reverses it. Esc drops the pick.
class SewSegments : public Tool {
public:
    Effect press(const Desk& desk, const PointerEvent& event) override;
    Effect move(const Desk& desk, const PointerEvent& event) override;
    Effect doubleClick(const Desk&, const PointerEvent&) override { return {}; }
    Effect key(const Desk& desk, ToolKey key) override;
    void cancel() override;
    [[nodiscard]] Overlay overlay(const Desk& desk) const override;
    [[nodiscard]] std::vector<Item> hovered() const override;
    [[nodiscard]] QString hint() const override;

private:
    std::optional<EdgeHit> first_, under_; ///< picked, and below the pointer
    pattern::SeamId made_;                 ///< the seam made last
};

} // namespace toile::ui
