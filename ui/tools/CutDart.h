// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/tools/Tool.h"
#include "ui/values/Picking.h"

namespace toile::ui {

/// Chosen in the bar above the pattern.
struct DartOptions {
    double width = 0.03; ///< of the mouth [m]
};

/// Cuts a dart and sews it shut: one click on an edge, the middle of its mouth, one for its tip. With Shift
/// the dart stands upright on the edge. Esc and Backspace drop the mouth.
class CutDart : public Tool {
public:
    explicit CutDart(const DartOptions& options) : options_(options) {}
    Effect press(const Desk& desk, const PointerEvent& event) override;
    Effect move(const Desk& desk, const PointerEvent& event) override;
    Effect key(const Desk& desk, ToolKey key) override;
    void cancel() override;
    [[nodiscard]] Overlay overlay(const Desk& desk) const override;
    [[nodiscard]] QString hint() const override;

private:
    [[nodiscard]] Vec2 tipAt(const Desk& desk, const PointerEvent& event) const;

    const DartOptions& options_;
    std::optional<EdgeHit> mouth_, under_;
    Vec2 tip_; ///< on the table
};

} // namespace toile::ui
