// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/dynamics/TriangleFinder.h"

#include "core/base/Contracts.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace toile::dynamics {
namespace {

constexpr double onBorder = 1e-9; // of a barycentric weight: such a point is inside [–]

std::array<double, 3> barycentric(const LevelTriangle& t, Vec2 point) {
    const auto& [a, b, c] = t.material;
    const double whole = cross(b - a, c - a);
    const double wb = cross(point - a, c - a) / whole, wc = cross(b - a, point - a) / whole;
    return {1 - wb - wc, wb, wc};
}

/// The point of the triangle's border that is nearest.
std::array<double, 3> nearestOnBorder(const LevelTriangle& t, Vec2 point, double& distance) {
    std::array<double, 3> weights{};
    distance = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3;
        const Vec2 side = t.material[j] - t.material[i];
        const double s = std::clamp(dot(point - t.material[i], side) / squaredLength(side), 0.0, 1.0);
        const double d = geometry::distance(point, t.material[i] + s * side);
        if (d >= distance) continue;
        distance = d;
        weights = {};
        weights[i] = 1 - s;
        weights[j] = s;
    }
    return weights;
}

int index(double x, double cell) {
    return static_cast<int>(std::floor(x / cell));
}

} // namespace

TriangleFinder::TriangleFinder(const LevelMesh& mesh) : mesh_(&mesh) {
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        patches_[mesh.triangles[t].patch].triangles.push_back(static_cast<int>(t));
    for (auto& [number, patch] : patches_) {
        double area = 0;
        for (const int t : patch.triangles) area += areaOf(mesh.triangles[t]);
        patch.cell = 2 * std::sqrt(area / static_cast<double>(patch.triangles.size()));
        for (const int t : patch.triangles) {
            const auto& m = mesh.triangles[t].material;
            const auto [left, right] = std::minmax({m[0].x, m[1].x, m[2].x});
            const auto [low, high] = std::minmax({m[0].y, m[1].y, m[2].y});
            for (int i = index(left, patch.cell); i <= index(right, patch.cell); ++i)
                for (int j = index(low, patch.cell); j <= index(high, patch.cell); ++j) patch.in[{i, j}].push_back(t);
        }
    }
}

TriangleFinder::Place TriangleFinder::find(int number, Vec2 point) const {
    const auto found = patches_.find(number);
    expects(found != patches_.end(), "every level has every patch");
    const Patch& patch = found->second;
    const auto cell = patch.in.find({index(point.x, patch.cell), index(point.y, patch.cell)});
    if (cell != patch.in.end())
        for (const int t : cell->second) {
            const auto weights = barycentric(mesh_->triangles[t], point);
            if (std::ranges::min(weights) < -onBorder) continue;
            Place place{t, weights};
            for (double& w : place.weights) w = std::max(w, 0.0);
            return place;
        }
    Place best;
    double nearest = std::numeric_limits<double>::infinity();
    for (const int t : patch.triangles) {
        double distance = 0;
        const auto weights = nearestOnBorder(mesh_->triangles[t], point, distance);
        if (distance >= nearest) continue;
        nearest = distance;
        best = {t, weights};
    }
    return best;
}

} // namespace toile::dynamics
