// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/meshing/DisplayTriangles.h"
#include "core/base/Index.h"

#include <algorithm>
#include <cmath>

namespace toile::meshing {
namespace {

double angleAt(Vec2 corner, Vec2 a, Vec2 b) {
    return std::atan2(cross(a - corner, b - corner), dot(a - corner, b - corner));
}

/// The smallest angle of the triangle [rad]; 0 if it has no area or runs clockwise.
double smallestAngle(Vec2 a, Vec2 b, Vec2 c) {
    if (cross(b - a, c - a) <= 1e-12 * std::max(squaredLength(b - a), squaredLength(c - a))) return 0;
    return std::min({angleAt(a, b, c), angleAt(b, c, a), angleAt(c, a, b)});
}

} // namespace

std::span<const std::array<int, 3>> CellTriangulator::of(const CellLayer& layer, const NodePlaces& places,
                                                         const MixedCell& cell) {
    const auto& c = cell.corners;
    polygon_.clear();
    for (std::size_t side = 0; side < 4; ++side) {
        polygon_.push_back(c[side]);
        for (const int node : layer.hangingOn(cell, side)) polygon_.push_back(node);
    }
    places_.clear();
    for (const int node : polygon_) places_.push_back(places(node));
    const int count = static_cast<int>(polygon_.size());
    best_.assign(at(count * count), 10);
    apex_.assign(at(count * count), -1);
    for (int span = 2; span < count; ++span) // by dynamic programming: stretches from shorter ones
        for (int i = 0; i + span < count; ++i) solve(i, i + span);
    triangles_.clear();
    appendStretch(0, count - 1);
    return triangles_;
}

std::size_t CellTriangulator::slot(int i, int j) const {
    return at(i) * polygon_.size() + at(j);
}

void CellTriangulator::solve(int i, int j) {
    double best = -1;
    for (int k = i + 1; k < j; ++k) {
        const double own = smallestAngle(places_[at(i)], places_[at(k)], places_[at(j)]);
        const double value = std::min({own, best_[slot(i, k)], best_[slot(k, j)]});
        if (value <= best + 1e-12) continue; // on a draw the first: mirror images differ in it, but not in angles
        best = value;
        apex_[slot(i, j)] = k;
    }
    best_[slot(i, j)] = best;
}

void CellTriangulator::appendStretch(int i, int j) {
    if (j - i < 2) return;
    const int k = apex_[slot(i, j)];
    appendStretch(i, k);
    triangles_.push_back({polygon_[at(i)], polygon_[at(k)], polygon_[at(j)]});
    appendStretch(k, j);
}

} // namespace toile::meshing
