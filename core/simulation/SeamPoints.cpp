// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/SeamPoints.h"

#include "core/pattern/PatternMeasures.h"

#include <algorithm>

namespace toile::simulation {

std::vector<SeamPoint> pointsAlong(const pattern::Pattern& pattern, const std::vector<pattern::SeamPart>& chain,
                                   int count) {
    std::vector<SeamPoint> corners;
    std::vector<double> gone;
    for (const pattern::SeamPart& part : chain)
        for (const Vec2 p : pattern::partPoints(pattern, part, 1e-3)) {
            const bool same = !corners.empty() && corners.back().piece == part.piece;
            gone.push_back(gone.empty() ? 0 : gone.back() + (same ? geometry::distance(corners.back().at, p) : 0));
            corners.push_back({part.piece, p});
        }
    std::vector<SeamPoint> points;
    if (corners.size() < 2) return points;
    std::size_t i = 0;
    for (int k = 0; k < count; ++k) {
        const double at = gone.back() * k / (count - 1);
        while (i + 2 < corners.size() && gone[i + 1] < at) ++i;
        const double stretch = gone[i + 1] - gone[i],
                     t = stretch > 0 ? std::clamp((at - gone[i]) / stretch, 0.0, 1.0) : 0;
        const bool joint = corners[i].piece != corners[i + 1].piece;
        points.push_back(joint ? corners[i] : SeamPoint{corners[i].piece, lerp(corners[i].at, corners[i + 1].at, t)});
    }
    return points;
}

bool isWithin(const pattern::Seam& seam, const pattern::PieceId& piece) {
    const auto within = [&](const pattern::SeamPart& part) { return part.piece == piece; };
    return std::ranges::all_of(seam.sides[0], within) && std::ranges::all_of(seam.sides[1], within);
}

} // namespace toile::simulation
