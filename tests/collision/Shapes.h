// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/Shapes.h"

#include <cmath>
#include <numbers>
#include <random>

/// Small bodies for the tests of collision and contact.
namespace toile::shapes {

using geometry::box;
using geometry::plane;
using geometry::starBody;

inline geometry::TriangleMesh bumpySphere(int rings = 24, int sectors = 40) {
    return starBody(rings, sectors, [](const Vec3& d) {
        return 1 + 0.08 * std::sin(7 * d.x) * std::sin(6 * d.y + 1) * std::cos(8 * d.z);
    });
}

/// Solid angle of the surface seen from p, over 4π: 1 inside a closed surface, 0 outside. Knows nothing of nearest
/// points or normals.
inline double windingNumber(const geometry::TriangleMesh& mesh, const Vec3& p) {
    double sum = 0;
    for (const auto& t : mesh.triangles) {
        const Vec3 a = mesh.vertices[t[0]] - p, b = mesh.vertices[t[1]] - p, c = mesh.vertices[t[2]] - p;
        const double la = length(a), lb = length(b), lc = length(c);
        sum += 2 * std::atan2(dot(a, cross(b, c)), la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb);
    }
    return sum / (4 * std::numbers::pi);
}

inline Vec3 randomPoint(std::mt19937& random, double halfSize) {
    std::uniform_real_distribution<double> along(-halfSize, halfSize);
    const double x = along(random), y = along(random), z = along(random);
    return {x, y, z};
}

} // namespace toile::shapes
