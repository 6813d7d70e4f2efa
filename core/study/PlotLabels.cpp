// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/PlotLabels.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace toile::study {
namespace {

struct Rectangle {
    Vec2 middle, half;
};

bool overlap(const Rectangle& a, const Rectangle& b) {
    return std::abs(a.middle.x - b.middle.x) < a.half.x + b.half.x &&
           std::abs(a.middle.y - b.middle.y) < a.half.y + b.half.y;
}

/// The nearest first, of those as near the ones that are read as the point's own.
std::array<Vec2, 12> placesBeside(Vec2 half, double marker) {
    const double x = half.x + marker, y = half.y + marker, far = y + 2 * half.y;
    return {{{0, y},
             {0, -y},
             {x, 0},
             {-x, 0},
             {x, y},
             {-x, y},
             {x, -y},
             {-x, -y},
             {0, far},
             {0, -far},
             {x, far},
             {-x, far}}};
}

} // namespace

std::vector<std::optional<Vec2>> placedLabels(std::span<const PointLabel> labels, const LabelRoom& room) {
    std::vector<Rectangle> markers, written;
    for (const PointLabel& label : labels) markers.push_back({label.point, {room.marker, room.marker}});
    std::vector<std::size_t> owners; // of what is written
    std::vector<std::optional<Vec2>> places(labels.size());
    for (std::size_t i = 0; i < labels.size(); ++i) {
        const auto& [point, text] = labels[i];
        const Vec2 half{room.character.x * static_cast<double>(text.size()) / 2, room.character.y / 2};
        const bool standsForIt = std::ranges::any_of(owners, [&](std::size_t owner) {
            return labels[owner].text == text && distance(labels[owner].point, point) < 2 * half.y + room.marker;
        });
        if (standsForIt) continue;
        for (const Vec2& place : placesBeside(half, room.marker)) {
            const Rectangle here{point + place, half};
            const auto covers = [&](const Rectangle& other) { return overlap(here, other); };
            if (std::ranges::any_of(markers, covers) || std::ranges::any_of(written, covers)) continue;
            written.push_back(here);
            owners.push_back(i);
            places[i] = place;
            break;
        }
    }
    return places;
}

} // namespace toile::study
