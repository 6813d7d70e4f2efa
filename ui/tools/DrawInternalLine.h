// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/tools/PathTool.h"

namespace toile::ui {

/// Draws a line on a piece that is not cut.
class DrawInternalLine : public PathTool {
public:
    DrawInternalLine() : PathTool(End::open) {}

protected:
    [[nodiscard]] Effect made(const Desk& desk, const pattern::PieceId& piece,
                              const std::vector<Vec2>& points) const override;
    [[nodiscard]] QString firstHint() const override;
};

} // namespace toile::ui
