// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/tools/PathTool.h"

namespace toile::ui {

/// Cuts a hole into a piece by its corners. Its edges are edges like others: they can be bent and sewn.
class CutHole : public PathTool {
public:
    CutHole() : PathTool(End::closed) {}

protected:
    [[nodiscard]] Effect made(const Desk& desk, const pattern::PieceId& piece,
                              const std::vector<Vec2>& corners) const override;
    [[nodiscard]] QString firstHint() const override;
};

} // namespace toile::ui
