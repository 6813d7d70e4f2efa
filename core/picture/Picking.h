// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/TriangleMesh.h"
#include "core/picture/Camera.h"
#include "core/simulation/Frame.h"

#include <array>
#include <optional>
#include <string>

namespace toile::picture {

/// Where a ray meets a triangle.
struct RayHit {
    double distance = 0;                        ///< from the ray's origin [m]
    std::array<double, 3> barycentric{1, 0, 0}; ///< weights of the corners; their sum is 1
};

/// Both sides count; a ray in the triangle's plane misses.
[[nodiscard]] std::optional<RayHit> intersection(const Ray& ray, const Vec3& a, const Vec3& b, const Vec3& c);

/// The nearest triangle of a mesh that a ray meets.
struct TriangleHit : RayHit {
    int triangle = 0;
};
[[nodiscard]] std::optional<TriangleHit> nearestHit(const Ray& ray, const std::vector<Vec3>& vertices,
                                                    const std::vector<geometry::TriangleIndices>& triangles);

/// The point of the cloth that a ray meets first.
struct ClothHit : TriangleHit {
    std::string piece; ///< id
    Vec3 point;        ///< [m]
};
[[nodiscard]] std::optional<ClothHit> pickCloth(const Ray& ray, const simulation::Frame& frame);

} // namespace toile::picture
