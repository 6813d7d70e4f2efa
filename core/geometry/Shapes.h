// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/TriangleMesh.h"

#include <cmath>
#include <numbers>

/// Simple bodies, for studies and tests of contact.
namespace toile::geometry {

/// Sides parallel to the axes, 12 triangles facing outward.
inline TriangleMesh box(const Vec3& low, const Vec3& high) {
    TriangleMesh mesh;
    for (int k = 0; k < 8; ++k)
        mesh.vertices.push_back({k & 1 ? high.x : low.x, k & 2 ? high.y : low.y, k & 4 ? high.z : low.z});
    const std::array<std::array<int, 4>, 6> sides{
        {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};
    for (const auto& [a, b, c, d] : sides) {
        mesh.triangles.push_back({a, b, c});
        mesh.triangles.push_back({a, c, d});
    }
    return mesh;
}

/// A closed surface round the origin whose radius in each direction (unit vector) is given [m].
template <class Radius>
TriangleMesh starBody(int rings, int sectors, const Radius& radius) {
    TriangleMesh mesh;
    const auto add = [&](double polar, double turn) {
        const Vec3 d{std::sin(polar) * std::cos(turn), std::cos(polar), std::sin(polar) * std::sin(turn)};
        mesh.vertices.push_back(d * radius(d));
    };
    add(0, 0);
    for (int r = 1; r < rings; ++r)
        for (int s = 0; s < sectors; ++s) add(std::numbers::pi * r / rings, 2 * std::numbers::pi * s / sectors);
    add(std::numbers::pi, 0);
    const int south = static_cast<int>(mesh.vertices.size()) - 1;
    const auto at = [&](int r, int s) { return 1 + (r - 1) * sectors + s % sectors; };
    for (int s = 0; s < sectors; ++s) {
        mesh.triangles.push_back({0, at(1, s + 1), at(1, s)});
        mesh.triangles.push_back({south, at(rings - 1, s), at(rings - 1, s + 1)});
        for (int r = 1; r + 1 < rings; ++r) {
            mesh.triangles.push_back({at(r, s), at(r, s + 1), at(r + 1, s)});
            mesh.triangles.push_back({at(r, s + 1), at(r + 1, s + 1), at(r + 1, s)});
        }
    }
    return mesh;
}

/// A closed cylinder round the y axis.
inline TriangleMesh cylinder(double radius, double halfHeight, int sectors, int rings) {
    TriangleMesh mesh;
    for (int r = 0; r <= rings; ++r)
        for (int s = 0; s < sectors; ++s) {
            const double turn = 2 * std::numbers::pi * s / sectors, y = halfHeight * (2.0 * r / rings - 1);
            mesh.vertices.push_back({radius * std::cos(turn), y, radius * std::sin(turn)});
        }
    const int bottom = static_cast<int>(mesh.vertices.size()), top = bottom + 1;
    mesh.vertices.push_back({0, -halfHeight, 0});
    mesh.vertices.push_back({0, halfHeight, 0});
    const auto at = [&](int r, int s) { return r * sectors + s % sectors; };
    for (int s = 0; s < sectors; ++s) {
        mesh.triangles.push_back({bottom, at(0, s), at(0, s + 1)});
        mesh.triangles.push_back({top, at(rings, s + 1), at(rings, s)});
        for (int r = 0; r < rings; ++r) {
            mesh.triangles.push_back({at(r, s), at(r + 1, s), at(r + 1, s + 1)});
            mesh.triangles.push_back({at(r, s), at(r + 1, s + 1), at(r, s + 1)});
        }
    }
    return mesh;
}

/// A flat grid in y = height, facing up: a plane for everything that stays within it.
inline TriangleMesh plane(double halfSize, int cells, double height = 0) {
    TriangleMesh mesh;
    for (int i = 0; i <= cells; ++i)
        for (int j = 0; j <= cells; ++j)
            mesh.vertices.push_back({halfSize * (2.0 * i / cells - 1), height, halfSize * (2.0 * j / cells - 1)});
    const auto at = [&](int i, int j) { return i * (cells + 1) + j; };
    for (int i = 0; i < cells; ++i)
        for (int j = 0; j < cells; ++j) {
            mesh.triangles.push_back({at(i, j), at(i, j + 1), at(i + 1, j)});
            mesh.triangles.push_back({at(i + 1, j), at(i, j + 1), at(i + 1, j + 1)});
        }
    return mesh;
}

} // namespace toile::geometry
