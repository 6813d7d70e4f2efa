// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/collision/MovingSurface.h"

#include "core/base/Contracts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace toile::collision {
namespace {

using Corners = std::array<Vec3, 3>;

/// Shares of a triangle's corners in a point on it, by the areas opposite; of a sliver, its nearest corner.
std::array<double, 3> sharesOf(const Vec3& p, const Corners& corner) {
    const Vec3 normal = cross(corner[1] - corner[0], corner[2] - corner[0]);
    const double doubled = squaredLength(normal);
    std::array<double, 3> shares{};
    if (doubled > 0) {
        for (std::size_t k = 0; k < 3; ++k)
            shares[k] = dot(normal, cross(corner[(k + 1) % 3] - p, corner[(k + 2) % 3] - p)) / doubled;
        if (std::ranges::all_of(shares, [](double share) { return share >= -1e-6 && share <= 1 + 1e-6; }))
            return shares;
    }
    const auto nearest = std::ranges::min_element(corner, {}, [&](const Vec3& c) { return squaredLength(c - p); });
    shares.fill(0);
    shares[static_cast<std::size_t>(nearest - corner.begin())] = 1;
    return shares;
}

Vec3 blend(const Corners& corner, const std::array<double, 3>& shares) {
    return corner[0] * shares[0] + corner[1] * shares[1] + corner[2] * shares[2];
}

/// The triangle's frame, with this origin.
Transform frameOf(const Corners& corner, const Vec3& origin) {
    const Vec3 side = corner[1] - corner[0], normal = cross(side, corner[2] - corner[0]);
    if (!(squaredLength(normal) > 0)) return {.origin = origin};
    const Vec3 x = normalized(side), z = normalized(normal);
    return {x, cross(z, x), z, origin};
}

BodySurface soundSurface(geometry::TriangleMesh mesh) {
    auto surface = BodySurface::create(std::move(mesh));
    expects(surface.has_value(), "a body that moves was sound where it stood");
    return std::move(*surface);
}

} // namespace

MovingSurface::MovingSurface(geometry::TriangleMesh mesh, std::shared_ptr<const geometry::VertexMotion> motion,
                             double begins)
    : motion_(std::move(motion)), begins_(begins), surface_(soundSurface(std::move(mesh))),
      ways_(surface_.mesh().vertices.size()) {}

void MovingSurface::moveTo(double time) {
    motion_->at(time - begins_, next_);
    const std::vector<Vec3>& now = surface_.mesh().vertices;
    double farthest = 0; // squared
    for (std::size_t v = 0; v < next_.size(); ++v) {
        ways_[v] = next_[v] - now[v];
        farthest = std::max(farthest, squaredLength(ways_[v]));
    }
    farthest_ = std::sqrt(farthest);
    if (farthest_ > 0) surface_.moveTo(next_);
}

Vec3 MovingSurface::wayOf(const SurfacePoint& place) const {
    const auto& [a, b, c] = surface_.mesh().triangles[place.triangle];
    const std::vector<Vec3>& vertices = surface_.mesh().vertices;
    return blend({ways_[a], ways_[b], ways_[c]}, sharesOf(place.point, {vertices[a], vertices[b], vertices[c]}));
}

CarriedPlace MovingSurface::carried(const Vec3& point) const {
    const SurfacePoint near = *surface_.nearest(point, std::numeric_limits<double>::infinity());
    const auto& [a, b, c] = surface_.mesh().triangles[near.triangle];
    const std::vector<Vec3>& vertices = surface_.mesh().vertices;
    const Corners corner{vertices[a], vertices[b], vertices[c]};
    const auto shares = sharesOf(near.point, corner);
    const Vec3 below = blend(corner, shares), off = point - below;
    const Transform frame = frameOf(corner, below);
    return {near.triangle, shares, {dot(off, frame.axisX), dot(off, frame.axisY), dot(off, frame.axisZ)}};
}

Vec3 MovingSurface::at(const CarriedPlace& place, double time) const {
    Corners corner;
    for (std::size_t k = 0; k < corner.size(); ++k)
        corner[k] = motion_->vertexAt(surface_.mesh().triangles[place.triangle][k], time - begins_);
    return frameOf(corner, blend(corner, place.shares)).point(place.offset);
}

} // namespace toile::collision
