// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/meshing/DisplayTriangles.h"

#include <algorithm>
#include <cmath>

namespace toile::meshing {
namespace {

std::size_t at(int i) {
    return static_cast<std::size_t>(i);
}

double angleAt(Vec2 corner, Vec2 a, Vec2 b) {
    return std::atan2(cross(a - corner, b - corner), dot(a - corner, b - corner));
}

/// Best triangulations of all stretches i … j of a convex polygon, by dynamic programming.
class PolygonTriangulation {
public:
    PolygonTriangulation(const std::vector<Vec2>& position, const std::vector<int>& polygon)
        : position_(position), polygon_(polygon), count_(static_cast<int>(polygon.size())),
          best_(at(count_ * count_), 10), apex_(at(count_ * count_), -1) {
        for (int span = 2; span < count_; ++span)
            for (int i = 0; i + span < count_; ++i) solve(i, i + span);
    }

    void append(int i, int j, std::vector<std::array<int, 3>>& triangles) const {
        if (j - i < 2) return;
        const int k = apex_[at(i * count_ + j)];
        append(i, k, triangles);
        triangles.push_back({polygon_[at(i)], polygon_[at(k)], polygon_[at(j)]});
        append(k, j, triangles);
    }

private:
    void solve(int i, int j) {
        double best = -1;
        for (int k = i + 1; k < j; ++k) {
            const double own = smallestAngle(pointAt(i), pointAt(k), pointAt(j));
            const double value = std::min({own, best_[at(i * count_ + k)], best_[at(k * count_ + j)]});
            if (value <= best + 1e-12) continue; // on a draw the first: mirror images differ in it, but not in angles
            best = value;
            apex_[at(i * count_ + j)] = k;
        }
        best_[at(i * count_ + j)] = best;
    }

    [[nodiscard]] Vec2 pointAt(int i) const { return position_[at(polygon_[at(i)])]; }

    const std::vector<Vec2>& position_;
    const std::vector<int>& polygon_;
    int count_;
    std::vector<double> best_;
    std::vector<int> apex_;
};

} // namespace

double smallestAngle(Vec2 a, Vec2 b, Vec2 c) {
    if (cross(b - a, c - a) <= 1e-12 * std::max(squaredLength(b - a), squaredLength(c - a))) return 0;
    return std::min({angleAt(a, b, c), angleAt(b, c, a), angleAt(c, a, b)});
}

void appendCellTriangles(const CellMesh& mesh, const Cell& cell, std::vector<std::array<int, 3>>& triangles) {
    const auto& c = cell.corners;
    if (cell.hanging < 0) {
        triangles.push_back({c[0], c[1], c[2]});
        triangles.push_back({c[0], c[2], c[3]});
        return;
    }
    std::vector<int> polygon;
    for (std::size_t side = 0; side < 4; ++side) {
        polygon.push_back(c[side]);
        const auto hanging = hangingOn(mesh.layer, cell, side);
        polygon.insert(polygon.end(), hanging.begin(), hanging.end());
    }
    PolygonTriangulation(mesh.position, polygon).append(0, static_cast<int>(polygon.size()) - 1, triangles);
}

} // namespace toile::meshing
