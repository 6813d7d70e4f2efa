// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Contracts.h"
#include "core/cloth/RegularPatches.h"
#include "core/collision/Intersections.h"
#include "core/dynamics/SelfContact.h"

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
int append(LayeredCloth& layers, double width, int columns, double height, int rows, double friction, const Place& place) {
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

} // namespace toile::study::validation
