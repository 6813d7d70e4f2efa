// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cloth/Strain.h"

#include "core/base/Contracts.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace toile::cloth {
namespace {

Strain strainOf(const Vec3& weft, const Vec3& warp, double area) {
    const double u = length(weft), v = length(warp);
    const double cosine = u > 0 && v > 0 ? dot(weft, warp) / (u * v) : 0;
    return {.warp = v - 1, .weft = u - 1, .shear = std::asin(std::clamp(cosine, -1.0, 1.0)), .area = area};
}

} // namespace

std::vector<Strain> strains(const Patch& patch, std::span<const Vec3> positions) {
    const auto at = [&](int node) { return positions[patch.particles[node]]; };
    std::vector<Strain> out;
    out.reserve(patch.rectangles.size() + patch.triangles.size());
    for (const PatchRectangle& cell : patch.rectangles) {
        const auto& n = cell.nodes;
        const Vec2 sides = patch.material[n[2]] - patch.material[n[0]];
        const Vec3 weft = (at(n[1]) - at(n[0]) + at(n[2]) - at(n[3])) / (2 * sides.x);
        const Vec3 warp = (at(n[3]) - at(n[0]) + at(n[2]) - at(n[1])) / (2 * sides.y);
        out.push_back(strainOf(weft, warp, sides.x * sides.y));
    }
    for (const PatchTriangle& cell : patch.triangles) {
        const auto& [a, b, c] = cell.nodes;
        const Vec2 u = patch.material[b] - patch.material[a], v = patch.material[c] - patch.material[a];
        const Vec3 p = at(b) - at(a), q = at(c) - at(a);
        const double twice = cross(u, v);
        out.push_back(strainOf((p * v.y - q * u.y) / twice, (q * u.x - p * v.x) / twice, 0.5 * twice));
    }
    return out;
}

std::vector<Strain> meanStrains(const Patch& patch, std::span<const Strain> strains, double radius) {
    expects(strains.size() == patch.rectangles.size() + patch.triangles.size(), "one strain per element");
    std::vector<Vec2> middles;
    for (const PatchRectangle& cell : patch.rectangles)
        middles.push_back(0.5 * (patch.material[cell.nodes[0]] + patch.material[cell.nodes[2]]));
    for (const PatchTriangle& cell : patch.triangles)
        middles.push_back(
            (patch.material[cell.nodes[0]] + patch.material[cell.nodes[1]] + patch.material[cell.nodes[2]]) / 3);

    const auto squareOf = [radius](Vec2 p) {
        return std::pair(static_cast<int>(std::floor(p.x / radius)), static_cast<int>(std::floor(p.y / radius)));
    };
    std::map<std::pair<int, int>, std::vector<std::size_t>> squares;
    for (std::size_t i = 0; i < middles.size(); ++i) squares[squareOf(middles[i])].push_back(i);

    std::vector<Strain> means;
    means.reserve(strains.size());
    for (std::size_t i = 0; i < middles.size(); ++i) {
        Strain sum;
        const auto [column, row] = squareOf(middles[i]);
        for (int c = column - 1; c <= column + 1; ++c)
            for (int r = row - 1; r <= row + 1; ++r) {
                const auto found = squares.find({c, r});
                if (found == squares.end()) continue;
                for (const std::size_t k : found->second) {
                    if (distance(middles[i], middles[k]) > radius) continue;
                    sum.warp += strains[k].area * strains[k].warp;
                    sum.weft += strains[k].area * strains[k].weft;
                    sum.shear += strains[k].area * strains[k].shear;
                    sum.area += strains[k].area;
                }
            }
        means.push_back({sum.warp / sum.area, sum.weft / sum.area, sum.shear / sum.area, strains[i].area});
    }
    return means;
}

double areaPercentile(std::vector<std::pair<double, double>> valuesAndAreas, double fraction) {
    expects(!valuesAndAreas.empty(), "a percentile of something");
    std::ranges::sort(valuesAndAreas);
    double total = 0, sum = 0;
    for (const auto& [value, area] : valuesAndAreas) total += area;
    for (const auto& [value, area] : valuesAndAreas) {
        sum += area;
        if (sum >= fraction * total) return value;
    }
    return valuesAndAreas.back().first;
}

} // namespace toile::cloth
