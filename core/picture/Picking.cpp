// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/picture/Picking.h"

namespace toile::picture {

/// Ref: Möller and Trumbore 1997.
std::optional<RayHit> intersection(const Ray& ray, const Vec3& a, const Vec3& b, const Vec3& c) {
    const Vec3 ab = b - a, ac = c - a, across = cross(ray.direction, ac);
    const double determinant = dot(ab, across);
    if (determinant == 0) return std::nullopt;
    const Vec3 fromA = ray.origin - a;
    const double u = dot(fromA, across) / determinant;
    if (!(u >= 0 && u <= 1)) return std::nullopt;
    const Vec3 turned = cross(fromA, ab);
    const double v = dot(ray.direction, turned) / determinant;
    if (!(v >= 0 && u + v <= 1)) return std::nullopt;
    const double along = dot(ac, turned) / determinant;
    if (!(along > 0)) return std::nullopt;
    return RayHit{along, {1 - u - v, u, v}};
}

std::optional<TriangleHit> nearestHit(const Ray& ray, const std::vector<Vec3>& vertices,
                                      const std::vector<geometry::TriangleIndices>& triangles) {
    std::optional<TriangleHit> nearest;
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        const auto [a, b, c] = triangles[i];
        if (const auto hit = intersection(ray, vertices[a], vertices[b], vertices[c]))
            if (!nearest || hit->distance < nearest->distance) nearest = TriangleHit{*hit, static_cast<int>(i)};
    }
    return nearest;
}

std::optional<ClothHit> pickCloth(const Ray& ray, const simulation::Frame& frame) {
    const simulation::FrameTopology& topology = *frame.topology;
    const auto hit = nearestHit(ray, frame.positions, topology.triangles);
    if (!hit) return std::nullopt;
    ClothHit cloth{*hit, {}, ray.origin + ray.direction * hit->distance};
    for (const auto& piece : topology.pieces)
        if (hit->triangle >= piece.firstTriangle && hit->triangle < piece.firstTriangle + piece.triangleCount)
            cloth.piece = piece.id;
    return cloth;
}

} // namespace toile::picture
