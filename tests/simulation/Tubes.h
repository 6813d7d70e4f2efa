// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/TriangleMesh.h"

#include <cmath>
#include <numbers>
#include <vector>

/// Cloth in the shape of tubes, made of rings one above the other.
namespace toile::tubes {

/// A round ring of points from +x to −z: counter-clockwise seen from above. No corner lies in a plane of symmetry.
inline std::vector<Vec3> ring(const Vec3& centre, double radius, int around) {
    std::vector<Vec3> points;
    for (int i = 0; i < around; ++i) {
        const double angle = 2 * std::numbers::pi * i / around + 0.01;
        points.push_back(centre + Vec3{radius * std::cos(angle), 0, -radius * std::sin(angle)});
    }
    return points;
}

/// Triangles between two rings whose points begin at these indices, seen from outside counter-clockwise when the second
/// lies above the first.
inline void appendBand(std::vector<geometry::TriangleIndices>& triangles, int lower, int upper, int around) {
    for (int i = 0; i < around; ++i) {
        const int next = (i + 1) % around;
        triangles.push_back({lower + i, lower + next, upper + i});
        triangles.push_back({lower + next, upper + next, upper + i});
    }
}

/// A tube through rings of equally many points, from below upwards when its right side is to be outside.
inline geometry::TriangleMesh throughRings(const std::vector<std::vector<Vec3>>& rings) {
    geometry::TriangleMesh mesh;
    const int around = static_cast<int>(rings.front().size());
    for (const auto& points : rings) mesh.vertices.insert(mesh.vertices.end(), points.begin(), points.end());
    for (int r = 0; r + 1 < static_cast<int>(rings.size()); ++r)
        appendBand(mesh.triangles, r * around, (r + 1) * around, around);
    return mesh;
}

} // namespace toile::tubes
