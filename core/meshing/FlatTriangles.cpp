// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/meshing/FlatTriangles.h"

#include <algorithm>
#include <map>
#include <utility>

namespace toile::meshing {
namespace {

std::size_t at(int i) {
    return static_cast<std::size_t>(i);
}

/// Border nodes of a straight edge lie beside it by the rounding of the grid; what is flatter than this has
/// no area but for that rounding [units].
constexpr double flatHeight = 2;

/// The corner opposite the longest side of a flat triangle, or −1.
int flatCorner(const std::vector<GridPoint>& points, const std::array<int, 3>& t) {
    const auto square = [&](std::size_t i) {
        const GridPoint a = points[at(t[(i + 1) % 3])], b = points[at(t[(i + 2) % 3])];
        const double x = static_cast<double>(a.x) - b.x, y = static_cast<double>(a.y) - b.y;
        return x * x + y * y;
    };
    const auto area = static_cast<double>(orientation(points[at(t[0])], points[at(t[1])], points[at(t[2])]));
    std::size_t longest = 0;
    for (const std::size_t i : {std::size_t{1}, std::size_t{2}})
        if (square(i) > square(longest)) longest = i;
    return area * area <= flatHeight * flatHeight * square(longest) ? static_cast<int>(longest) : -1;
}

} // namespace

void turnFlatTriangles(const std::vector<GridPoint>& points, std::vector<std::array<int, 3>>& triangles) {
    std::vector<std::size_t> flat;
    for (std::size_t t = 0; t < triangles.size(); ++t)
        if (flatCorner(points, triangles[t]) >= 0) flat.push_back(t);
    if (flat.empty()) return;
    std::map<std::pair<int, int>, std::size_t> owner; // of each directed side
    const auto enter = [&](std::size_t t) {
        for (std::size_t i = 0; i < 3; ++i) owner[{triangles[t][i], triangles[t][(i + 1) % 3]}] = t;
    };
    for (std::size_t t = 0; t < triangles.size(); ++t) enter(t);
    const auto area = [&](int a, int b, int c) { return orientation(points[at(a)], points[at(b)], points[at(c)]); };
    for (const std::size_t t : flat) {
        const int corner = flatCorner(points, triangles[t]);
        if (corner < 0) continue; // a neighbour's turn has mended it
        const int apex = triangles[t][at(corner)], a = triangles[t][at((corner + 1) % 3)],
                  b = triangles[t][at((corner + 2) % 3)];
        const auto beyond = owner.find({b, a});
        if (beyond == owner.end()) continue;
        const std::size_t other = beyond->second;
        const int far =
            *std::find_if(triangles[other].begin(), triangles[other].end(), [&](int n) { return n != a && n != b; });
        if (area(apex, a, far) <= 0 || area(apex, far, b) <= 0) continue;
        owner.erase({a, b});
        owner.erase({b, a});
        triangles[t] = {apex, a, far};
        triangles[other] = {apex, far, b};
        enter(t);
        enter(other);
    }
}

} // namespace toile::meshing
