// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/HangingQuantities.h"

#include "core/base/Contracts.h"
#include "core/simulation/Inspect.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace toile::study {
namespace {

using Triangles = std::vector<std::array<int, 3>>;

Triangles wholeTriangles(const simulation::Drape& drape) {
    Triangles whole;
    for (const auto& t : drape.triangles)
        if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) whole.push_back(t);
    return whole;
}

/// Squares of a level grid, each covered or not.
class Shadow {
public:
    explicit Shadow(const std::vector<Vec3>& points) {
        for (const Vec3& p : points) {
            low_ = {std::min(low_.x, p.x), std::min(low_.y, p.z)};
            high_ = {std::max(high_.x, p.x), std::max(high_.y, p.z)};
        }
        columns_ = static_cast<int>(std::ceil((high_.x - low_.x) / side)) + 1;
        const int rows = static_cast<int>(std::ceil((high_.y - low_.y) / side)) + 1;
        covered_.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows));
    }

    /// Covers the squares whose middle lies in the triangle.
    void add(const Vec3& a, const Vec3& b, const Vec3& c) {
        const Vec2 corners[] = {inGrid(a), inGrid(b), inGrid(c)};
        const double turn = cross(corners[1] - corners[0], corners[2] - corners[0]) < 0 ? -1 : 1;
        const auto [left, right] = std::minmax({corners[0].x, corners[1].x, corners[2].x});
        const auto [top, bottom] = std::minmax({corners[0].y, corners[1].y, corners[2].y});
        for (int row = static_cast<int>(top); row <= static_cast<int>(bottom); ++row)
            for (int column = static_cast<int>(left); column <= static_cast<int>(right); ++column) {
                const Vec2 middle{column + 0.5, row + 0.5};
                bool isInside = true;
                for (int k = 0; k < 3; ++k)
                    isInside &= turn * cross(corners[(k + 1) % 3] - corners[k], middle - corners[k]) >= 0;
                if (isInside) covered_[static_cast<std::size_t>(row) * columns_ + column] = true;
            }
    }

    [[nodiscard]] double area() const { return side * side * std::ranges::count(covered_, true); }

private:
    static constexpr double side = 2e-3; // [m]
    [[nodiscard]] Vec2 inGrid(const Vec3& p) const { return {(p.x - low_.x) / side, (p.z - low_.y) / side}; }

    static constexpr double far = std::numeric_limits<double>::infinity();
    Vec2 low_{far, far}, high_{-far, -far};
    int columns_ = 0;
    std::vector<bool> covered_;
};

/// Folds of the border whose points lie lowest in the mean.
std::optional<int> foldsOfLowestBorder(const Triangles& triangles, const std::vector<Vec3>& positions) {
    double lowest = std::numeric_limits<double>::infinity();
    std::optional<int> folds;
    for (const simulation::Opening& border : simulation::openingsOf(triangles)) {
        std::vector<Vec3> line;
        double height = 0;
        for (const int particle : border) {
            line.push_back(positions[particle]);
            height += positions[particle].y / static_cast<double>(border.size());
        }
        if (height >= lowest) continue;
        lowest = height;
        folds = foldsOf(line);
    }
    return folds;
}

} // namespace

Hanging hangingOf(const WornDrape& worn) {
    const std::vector<Vec3>& x = worn.drape.positions;
    const Triangles triangles = wholeTriangles(worn.drape);
    expects(!triangles.empty(), "a cloth has an area");
    Hanging hanging;
    hanging.lowest = std::ranges::min(x, {}, &Vec3::y).y;
    Shadow shadow(x);
    double area = 0;
    for (const auto& [a, b, c] : triangles) {
        const double own = length(cross(x[b] - x[a], x[c] - x[a])) / 2;
        hanging.meanHeight += own * (x[a].y + x[b].y + x[c].y) / 3;
        area += own;
        shadow.add(x[a], x[b], x[c]);
    }
    hanging.meanHeight /= area;
    hanging.shadow = shadow.area();
    hanging.folds = foldsOfLowestBorder(triangles, x);
    if (worn.surface) hanging.contact = contactAreaOf(worn);
    return hanging;
}

double contactAreaOf(const WornDrape& worn) {
    constexpr double margin = 0.5e-3; // beyond the distance that contact keeps [m]
    const std::vector<Vec3>& x = worn.drape.positions;
    std::vector<bool> touches;
    for (std::size_t i = 0; i < x.size(); ++i) {
        const double reach = worn.touching[i] + margin;
        const auto nearest = worn.surface->nearest(x[i], reach);
        touches.push_back(nearest && nearest->signedDistance <= reach);
    }
    double area = 0;
    for (const auto& [a, b, c] : wholeTriangles(worn.drape))
        area += length(cross(x[b] - x[a], x[c] - x[a])) / 2 * (int(touches[a]) + int(touches[b]) + int(touches[c])) / 3;
    return area;
}

} // namespace toile::study
