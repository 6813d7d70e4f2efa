// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/dynamics/Xpbd.h"
#include "core/study/validation/Layers.h"
#include "tests/cloth/Fixtures.h"

#include <QTest>

/// Sheets of cloth above and beside each other, for the tests of self-contact.
namespace toile::layers {

using study::validation::append;
using Cloth = study::validation::LayeredCloth;
constexpr double thickness = study::validation::layerThickness; // [m]

inline void pin(Cloth& cloth, int first, int last) {
    for (int p = first; p < last; ++p) cloth.model.pinned.push_back(p);
}

/// A bent sheet of 0.1 m, turned a little, `gap` above a pinned flat one of 0.2 m; both of square cells.
inline Cloth sheetOverPinnedSheet(int cellsBelow, int cellsAbove, double gap) {
    Cloth cloth;
    append(cloth, 0.2, cellsBelow, 0.2, cellsBelow, 0.3, [](const Vec2& m) { return Vec3{m.x - 0.1, 0, 0.1 - m.y}; });
    pin(cloth, 0, cloth.model.particleCount());
    append(cloth, 0.1, cellsAbove, 0.1, cellsAbove, 0.3, [=](const Vec2& m) {
        const Vec2 p = geometry::rotated(m - Vec2{0.05, 0.05}, 0.3);
        return Vec3{p.x, gap + 0.02 * p.x * p.x, -p.y};
    });
    return cloth;
}

} // namespace toile::layers
