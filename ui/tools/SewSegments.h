// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/tools/SeamDraft.h"

namespace toile::ui {

/// Sews whole edges: one click for side one, one for side two. With Shift a click says that more edges follow
/// on its side, so that sides can be chains (1:N, M:N); Enter ends a chain. The end of an edge that lies
/// nearer to the click is where the seam begins; arrows and links show it before the last click. A click on
/// an edge of the seam just made reverses it. Backspace takes the last pick back, Esc all.
class SewSegments : public Tool {
public:
    Effect press(const Desk& desk, const PointerEvent& event) override;
    Effect move(const Desk& desk, const PointerEvent& event) override;
    Effect key(const Desk& desk, ToolKey key) override;
    void cancel() override;
    [[nodiscard]] Overlay overlay(const Desk& desk) const override;
    [[nodiscard]] std::optional<Item> hovered() const override;
    [[nodiscard]] QString hint() const override;

private:
    [[nodiscard]] bool isPicked(const EdgeRef& edge) const;
    Effect endSide(const Desk& desk);
    void takeBack();
    void dropPicks();

    std::array<std::vector<EdgeHit>, 2> picks_; ///< of the two sides, in order
    std::size_t side_ = 0;                      ///< that is being picked
    std::optional<EdgeHit> under_;              ///< below the pointer
    pattern::SeamId made_;                      ///< the seam made last
};

} // namespace toile::ui
