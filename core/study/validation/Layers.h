// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Contracts.h"
#include "core/cloth/RegularPatches.h"
#include "core/collision/ElementPair.h"
#include "core/collision/Intersections.h"
#include "core/dynamics/SelfContact.h"

#include <limits>
#include <span>

/// Sheets of cloth above and beside each other.
namespace toile::study::validation {

constexpr double layerThickness = 0.5e-3; // [m]

struct LayeredCloth {
    cloth::ClothModel model;
    dynamics::ParticleState state;
    dynamics::ClothSurface surface;

    [[nodiscard]] int intersections() const {
        return static_cast<int>(collision::selfIntersectingTriangles({state.positions, surface.triangles}).size());
    }
};

/// Appends a sheet of columns × rows cells; `place` says where a point of its plane lies. Returns its first
/// particle.
template <class Place>
int append(LayeredCloth& layers, double width, int columns, double height, int rows, double friction,
           const Place& place) {
    const int first = layers.model.particleCount();
    auto patch = cloth::gridPatch(cloth::evenLines(width, columns), cloth::evenLines(height, rows));
    for (int& particle : patch.particles) particle += first;
    const auto report = cloth::appendPatch(layers.model, patch, material::Fabric{});
    expects(report.has_value(), "a sheet is a cloth");
    for (const Vec2& m : patch.material) layers.state.positions.push_back(place(m));
    layers.state.velocities.resize(layers.state.positions.size());
    for (const auto& cell : patch.rectangles) {
        std::array<int, 4> n = cell.nodes;
        for (int& node : n) node += first;
        layers.surface.triangles.push_back({n[0], n[1], n[2]});
        layers.surface.triangles.push_back({n[0], n[2], n[3]});
    }
    const std::size_t count = layers.model.mass.size();
    layers.surface.halfThickness.resize(count, layerThickness / 2);
    layers.surface.friction.resize(count, friction);
    layers.surface.room.resize(count, std::min(width / columns, height / rows) / std::sqrt(2.0));
    return first;
}

/// Least distance between the triangles of two layers that do not cross [m]: every corner with every triangle, every
/// edge with every edge.
inline double leastDistance(std::span<const Vec3> x, std::span<const std::array<int, 3>> upper,
                            std::span<const std::array<int, 3>> lower) {
    double least = std::numeric_limits<double>::infinity();
    const auto edges = [](const std::array<int, 3>& t) {
        return std::array<std::array<int, 2>, 3>{{{t[0], t[1]}, {t[1], t[2]}, {t[2], t[0]}}};
    };
    const auto look = [&](const collision::ElementPair& pair) {
        least = std::min(least, collision::separationOf(pair, x).distance);
    };
    for (const auto& a : upper)
        for (const auto& b : lower) {
            for (int k = 0; k < 3; ++k) {
                look({{a[k], b[0], b[1], b[2]}, 1});
                look({{b[k], a[0], a[1], a[2]}, 1});
            }
            for (const auto& e : edges(a))
                for (const auto& f : edges(b)) look({{e[0], e[1], f[0], f[1]}, 2});
        }
    return least;
}

} // namespace toile::study::validation
