// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/collision/Intersections.h"
#include "core/dynamics/SelfContact.h"
#include "core/dynamics/Xpbd.h"
#include "tests/cloth/Fixtures.h"

#include <QtTest>

/// Sheets of cloth above and beside each other, for the tests of self-contact.
namespace toile::layers {

constexpr double thickness = 0.5e-3; // [m]

struct Cloth {
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
int append(Cloth& cloth, double width, int columns, double height, int rows, double friction, const Place& place) {
    const int first = cloth.model.particleCount();
    auto patch = fixtures::gridPatch(fixtures::evenLines(width, columns), fixtures::evenLines(height, rows));
    for (int& particle : patch.particles) particle += first;
    const auto report = cloth::appendPatch(cloth.model, patch, material::Fabric{});
    if (!report) qFatal("%s", toString(report.error()).c_str());
    for (const Vec2& m : patch.material) cloth.state.positions.push_back(place(m));
    cloth.state.velocities.resize(cloth.state.positions.size());
    for (const auto& cell : patch.rectangles) {
        std::array<int, 4> n = cell.nodes;
        for (int& node : n) node += first;
        cloth.surface.triangles.push_back({n[0], n[1], n[2]});
        cloth.surface.triangles.push_back({n[0], n[2], n[3]});
    }
    const std::size_t count = cloth.model.mass.size();
    cloth.surface.halfThickness.resize(count, thickness / 2);
    cloth.surface.friction.resize(count, friction);
    cloth.surface.room.resize(count, std::min(width / columns, height / rows) / std::sqrt(2.0));
    return first;
}

inline void pin(Cloth& cloth, int first, int last) {
    for (int p = first; p < last; ++p) cloth.model.pinned.push_back(p);
}

/// A bent sheet of 0.1 m, turned a little, `gap` above a pinned flat one of 0.2 m; both of square cells.
inline Cloth sheetOverPinnedSheet(int cellsBelow, int cellsAbove, double gap) {
    Cloth cloth;
    append(cloth, 0.2, cellsBelow, 0.2, cellsBelow, 0.3, [](const Vec2& m) { return Vec3{m.x - 0.1, 0, 0.1 - m.y}; });
    pin(cloth, 0, cloth.model.particleCount());
    append(cloth, 0.1, cellsAbove, 0.1, cellsAbove, 0.3, [=](const Vec2& m) {
        const Vec2 p = geometry::rotated(m - Vec2{0.05, 0.05}, 0.3);
        return Vec3{p.x, gap + 0.02 * p.x * p.x, -p.y};
    });
    return cloth;
}

} // namespace toile::layers
