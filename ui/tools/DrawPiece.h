// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/tools/Tool.h"

namespace toile::ui {

/// Draws the outline of a new piece. A click sets a point; a drag from it pulls out the handles of a curve. A click on
/// the first point or Enter closes the outline, Backspace takes the last point back, Esc gives up. Shift keeps the next
/// edge on a multiple of 45°.
class DrawPiece : public Tool {
public:
    Effect press(const Desk& desk, const PointerEvent& event) override;
    Effect move(const Desk& desk, const PointerEvent& event) override;
    Effect release(const Desk& desk, const PointerEvent& event) override;
    Effect doubleClick(const Desk& desk, const PointerEvent& event) override;
    Effect key(const Desk& desk, ToolKey key) override;
    void cancel() override;
    [[nodiscard]] Overlay overlay(const Desk& desk) const override;
    [[nodiscard]] QString hint() const override;

private:
    /// A point with the way to its outgoing handle; the incoming one lies opposite.
    struct Point {
        Vec2 at;
        std::optional<Vec2> handle;
    };
    [[nodiscard]] Vec2 next(const PointerEvent& event) const;
    [[nodiscard]] bool closes(const PointerEvent& event) const;
    [[nodiscard]] static geometry::EdgeShape shapeBetween(const Point& from, const Point& to);
    Effect finish(const Desk& desk);

    std::vector<Point> points_;
    Vec2 pointer_;
    bool pulling_ = false; ///< the button is held on the last point
    double tolerance_ = 0; ///< of the last event [m]
};

/// Where a new piece starts: upright before the chest of an adult, its right side to the front.
[[nodiscard]] pattern::Placement startingPlace();
/// The point turned round `from` on to the nearest multiple of 45°.
[[nodiscard]] Vec2 alignedTo45(Vec2 from, Vec2 point);

} // namespace toile::ui
