// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/dynamics/Xpbd.h"
#include "core/study/validation/Layers.h"
#include "tests/cloth/Fixtures.h"

#include <QTest>

/// Sheets of cloth above and beside each other, for the tests of self-contact.
namespace toile::layers {

using study::validation::append;
using Cloth = study::validation::LayeredCloth;
constexpr double thickness = study::validation::layerThickness; // [m]

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

/// A square of 0.1 m in the plane y = height, turned by an angle so that no edges lie on each other.
inline auto level(double height, double angle = 0.3) {
    return [=](const Vec2& m) {
        const Vec2 p = geometry::rotated(m - Vec2{0.05, 0.05}, angle);
        return Vec3{p.x, height, -p.y};
    };
}

/// A sheet that flies down [m/s] at a resting one of two regions, whose joint has slaves.
inline Cloth sheetThrownAtTwoRegions(double speed) {
    Cloth cloth;
    append(cloth, 0.1, 10, 0.1, 10, 0.3, level(0.004));
    const int first = cloth.model.particleCount();
    auto patch = fixtures::twoRegionPatch(0.3, 8, 0.15, 4, 0.3, 8);
    for (int& particle : patch.particles) particle += first;
    if (!cloth::appendPatch(cloth.model, patch, material::Fabric{})) qFatal("two regions are a cloth");
    for (const Vec2& m : patch.material) cloth.state.positions.push_back({m.x - 0.15, 0, 0.15 - m.y});
    for (const auto& cell : patch.rectangles) {
        const auto& n = cell.nodes;
        const auto hanging = std::ranges::find_if(patch.slaves, [&](const cloth::PatchSlave& slave) {
            return slave.masters[0].first == n[3] && slave.masters[1].first == n[2];
        });
        if (hanging == patch.slaves.end()) {
            cloth.surface.triangles.push_back({first + n[0], first + n[1], first + n[2]});
            cloth.surface.triangles.push_back({first + n[0], first + n[2], first + n[3]});
        } else { // without a crack
            const int middle = first + hanging->node;
            cloth.surface.triangles.push_back({first + n[0], first + n[1], middle});
            cloth.surface.triangles.push_back({first + n[1], first + n[2], middle});
            cloth.surface.triangles.push_back({first + n[0], middle, first + n[3]});
        }
    }
    cloth.state.velocities.resize(cloth.state.positions.size());
    for (int p = 0; p < first; ++p) cloth.state.velocities[p] = {0, -speed, 0};
    const std::size_t count = cloth.model.mass.size();
    cloth.surface.halfThickness.resize(count, thickness / 2);
    cloth.surface.friction.resize(count, 0.3);
    cloth.surface.room.resize(count, 0.01);
    return cloth;
}

/// Of the particles that are not pinned.
inline double lowest(const Cloth& cloth) {
    double least = 1e300;
    for (std::size_t p = cloth.model.pinned.size(); p < cloth.state.positions.size(); ++p)
        least = std::min(least, cloth.state.positions[p].y);
    return least;
}

/// How far a slave is from where its masters have it [m].
inline double farthestSlave(const Cloth& cloth) {
    double farthest = 0;
    for (const cloth::Slave& slave : cloth.model.slaves) {
        Vec3 place;
        for (const auto& [master, weight] : slave.masters) place += weight * cloth.state.positions[master];
        farthest = std::max(farthest, geometry::distance(place, cloth.state.positions[slave.particle]));
    }
    return farthest;
}

} // namespace toile::layers
