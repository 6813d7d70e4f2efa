// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/CarryOver.h"

#include "core/base/Contracts.h"
#include "core/geometry/Polygon.h"
#include "core/simulation/ParticleMap.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace toile::simulation {
namespace {

struct Barycentric {
    double a = 0, b = 0, c = 0;
    [[nodiscard]] double least() const { return std::min({a, b, c}); }
};

Barycentric barycentric(Vec2 a, Vec2 b, Vec2 c, Vec2 p) {
    const double whole = geometry::cross(b - a, c - a);
    if (whole == 0) return {1, 0, -1};
    const double wb = geometry::cross(p - a, c - a) / whole, wc = geometry::cross(b - a, p - a) / whole;
    return {1 - wb - wc, wb, wc};
}

} // namespace

DrapedPiece::DrapedPiece(const meshing::PieceMesh& mesh, std::span<const Vec3> positions)
    : mesh_(mesh), positions_(positions) {
    expects(positions.size() == mesh.nodes.size(), "a position per node");
    const geometry::Box2 box = geometry::boundsOf(mesh.nodes);
    low_ = box.low;
    const Vec2 size = box.high - box.low;
    const double count = std::max<double>(1, static_cast<double>(mesh.display.size()));
    cell_ = std::max(std::sqrt(std::max(size.x * size.y, 1e-12) / count) * 2, 1e-6);
    columns_ = static_cast<int>(size.x / cell_) + 1;
    rows_ = static_cast<int>(size.y / cell_) + 1;
    trianglesIn_.resize(static_cast<std::size_t>(columns_) * rows_);
    for (std::size_t t = 0; t < mesh.display.size(); ++t) {
        const auto& [a, b, c] = mesh.display[t];
        const std::array<Vec2, 3> corners{mesh.nodes[a], mesh.nodes[b], mesh.nodes[c]};
        const geometry::Box2 bounds = geometry::boundsOf(corners);
        for (int row = static_cast<int>((bounds.low.y - low_.y) / cell_);
             row <= static_cast<int>((bounds.high.y - low_.y) / cell_); ++row)
            for (int column = static_cast<int>((bounds.low.x - low_.x) / cell_);
                 column <= static_cast<int>((bounds.high.x - low_.x) / cell_); ++column)
                trianglesIn_[static_cast<std::size_t>(row) * columns_ + column].push_back(static_cast<int>(t));
    }
}

MaterialPlace DrapedPiece::inTriangle(std::size_t triangle, Vec2 point) const {
    const auto& [a, b, c] = mesh_.display[triangle];
    const Barycentric w = barycentric(mesh_.nodes[a], mesh_.nodes[b], mesh_.nodes[c], point);
    return {{a, b, c}, {w.a, w.b, w.c}};
}

std::optional<Vec3> DrapedPiece::inside(Vec2 point) const {
    const auto place = placeInside(point);
    return place ? std::optional(place->in(positions_)) : std::nullopt;
}

std::optional<MaterialPlace> DrapedPiece::placeInside(Vec2 point) const {
    const auto least = [&](int triangle) {
        const auto& [a, b, c] = mesh_.display[triangle];
        return barycentric(mesh_.nodes[a], mesh_.nodes[b], mesh_.nodes[c], point).least();
    };
    const int column = static_cast<int>((point.x - low_.x) / cell_), row = static_cast<int>((point.y - low_.y) / cell_);
    if (point.x >= low_.x && point.y >= low_.y && column < columns_ && row < rows_)
        for (const int triangle : trianglesIn_[static_cast<std::size_t>(row) * columns_ + column])
            if (least(triangle) >= -1e-9) return inTriangle(triangle, point);
    return std::nullopt;
}

MaterialPlace DrapedPiece::placeOf(Vec2 point) const {
    if (const auto found = placeInside(point)) return *found;
    // Outside the old outline: the triangle that is nearest is continued beyond its edge.
    std::size_t best = 0;
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t t = 0; t < mesh_.display.size(); ++t)
        for (int k = 0; k < 3; ++k) {
            const Vec2 from = mesh_.nodes[mesh_.display[t][k]], to = mesh_.nodes[mesh_.display[t][(k + 1) % 3]];
            const double d = geometry::squaredLength(geometry::closestOnSegment(from, to, point) - point);
            if (d < nearest) {
                nearest = d;
                best = t;
            }
        }
    return inTriangle(best, point);
}

void joinSewn(const meshing::GarmentMesh& mesh, const std::vector<bool>& seams, double gap, std::span<Vec3> nodes) {
    const ParticleMap map = particleMap(mesh, seams);
    std::vector<std::vector<std::size_t>> joined(map.particleCount);
    for (std::size_t node = 0; node < nodes.size(); ++node) joined[map.particleOf[node]].push_back(node);
    for (const std::vector<std::size_t>& group : joined) {
        Vec3 middle;
        for (const std::size_t node : group) middle += nodes[node] / static_cast<double>(group.size());
        const bool isNear = std::ranges::all_of(
            group, [&](std::size_t node) { return geometry::distance(nodes[node], middle) <= gap / 2; });
        if (group.size() > 1 && isNear)
            for (const std::size_t node : group) nodes[node] = middle;
    }
}

} // namespace toile::simulation
