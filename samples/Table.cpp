// SPDX-License-Identifier: GPL-3.0-or-later
#include "samples/Table.h"

#include <algorithm>
#include <cmath>

namespace toile::samples {
namespace {

geometry::Box2 extent(const pattern::Piece& piece) {
    std::vector<Vec2> points;
    for (std::size_t e = 0; e < piece.outline.edges.size(); ++e)
        for (const Vec2 p : geometry::flattened(curveOf(piece.outline, e), 1e-3)) points.push_back(p);
    return geometry::boundsOf(points);
}

} // namespace

pattern::Pattern laidOut(pattern::Pattern pattern, double rowWidth) {
    constexpr double gap = 0.05, rowGap = 0.10; // [m]; a piece's name stands below it
    double left = 0, top = 0, lowest = 0;
    for (Shared<pattern::Piece>& shared : pattern.pieces) {
        const auto [low, high] = extent(resolved(pattern, *shared));
        if (left > 0 && left + high.x - low.x > rowWidth) {
            left = 0;
            top = lowest - rowGap;
        }
        pattern::Piece piece = *shared;
        // Whole millimetres: nobody aligns pieces on a table more finely.
        piece.tablePosition = {std::round(1000 * (left - low.x)) / 1000, std::round(1000 * (top - high.y)) / 1000};
        left += high.x - low.x + gap;
        lowest = std::min(lowest, top - (high.y - low.y));
        shared = piece;
    }
    return pattern;
}

} // namespace toile::samples
