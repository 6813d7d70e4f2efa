// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/tools/PathTool.h"

namespace toile::ui {

/// What the tools for regions share: chosen in the bar above the pattern.
struct PaintOptions {
    int refinement = 1;   ///< m of the spacing ε_m/2^m, 0 … 5
    double radius = 0.03; ///< of the brush [m]
};

/// Paints a region by its corners.
class PaintPolygon : public PathTool {
public:
    explicit PaintPolygon(const PaintOptions& options) : PathTool(End::closed), options_(options) {}

protected:
    [[nodiscard]] Effect made(const Desk& desk, const pattern::PieceId& piece,
                              const std::vector<Vec2>& corners) const override;
    [[nodiscard]] QString firstHint() const override;

private:
    const PaintOptions& options_;
};

/// Paints a region with a round brush. A stroke that begins on a region of the same refinement, or while such a region
/// of the piece is selected and touched, adds to it; other strokes begin a new region. Alt takes away. Ctrl and the
/// wheel change the radius.
class PaintBrush : public Tool {
public:
    explicit PaintBrush(PaintOptions& options) : options_(options) {}
    Effect press(const Desk& desk, const PointerEvent& event) override;
    Effect move(const Desk& desk, const PointerEvent& event) override;
    Effect release(const Desk& desk, const PointerEvent& event) override;
    Effect doubleClick(const Desk& desk, const PointerEvent& event) override { return press(desk, event); }
    Effect key(const Desk& desk, ToolKey key) override;
    bool wheel(double notches) override;
    void cancel() override;
    [[nodiscard]] Overlay overlay(const Desk& desk) const override;
    [[nodiscard]] QString hint() const override;

private:
    struct Stroke {
        pattern::PieceId piece;
        std::vector<Vec2> points; ///< on the table
        bool erases = false;
    };
    [[nodiscard]] Effect paint(const Desk& desk, const Stroke& stroke) const;
    [[nodiscard]] Effect erase(const Desk& desk, const Stroke& stroke) const;

    PaintOptions& options_;
    std::optional<Stroke> stroke_;
    Vec2 pointer_;
};

} // namespace toile::ui
