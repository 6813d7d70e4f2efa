// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/tools/DragWay.h"

namespace toile::ui {

/// Selects pieces and moves them on the table; Delete takes them out. Shape and drape do not change.
class MovePieces : public Tool {
public:
    Effect press(const Desk& desk, const PointerEvent& event) override;
    Effect move(const Desk& desk, const PointerEvent& event) override;
    Effect release(const Desk& desk, const PointerEvent& event) override;
    void cancel() override;
    [[nodiscard]] std::optional<Item> hovered() const override { return hovered_; }
    [[nodiscard]] QString hint() const override;

private:
    std::optional<DragWay> drag_;
    std::optional<pattern::PieceId> hovered_;
    int drags_ = 0;
};

} // namespace toile::ui
