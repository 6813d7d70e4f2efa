// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cloth/DrawnSides.h"

#include <algorithm>
#include <cmath>

namespace toile::cloth {

double drawnBy(const Patch& patch, int a, int b) {
    if (patch.drawn.empty()) return 1;
    const std::pair<int, int> ends = std::minmax(a, b);
    const auto side = std::ranges::lower_bound(patch.drawn, ends, {}, &DrawnSide::ends);
    return side != patch.drawn.end() && side->ends == ends ? side->factor : 1;
}

DrawnRectangle drawnRectangle(const Patch& patch, const PatchRectangle& cell) {
    const Vec2 size = patch.material[cell.nodes[2]] - patch.material[cell.nodes[0]];
    std::array<double, 4> factors{};
    for (std::size_t i = 0; i < 4; ++i) factors[i] = drawnBy(patch, cell.nodes[i], cell.nodes[(i + 1) % 4]);
    DrawnRectangle rest{.sides = {factors[0] * size.x, factors[1] * size.y, factors[2] * size.x, factors[3] * size.y},
                        .diagonal = std::hypot(size.x, size.y),
                        .drawn = std::ranges::any_of(factors, [](double f) { return f != 1; })};
    if (rest.drawn) rest.diagonal = std::sqrt(rest.sides[0] * rest.sides[2] + rest.sides[1] * rest.sides[3]);
    return rest;
}

} // namespace toile::cloth
