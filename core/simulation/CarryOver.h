// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/Garment.h"

#include <array>
#include <optional>

namespace toile::simulation {

/// A point of the material among the nodes of its piece: in a triangle, or beyond it in its plane.
struct MaterialPlace {
    std::array<int, 3> nodes{};
    std::array<double, 3> weights{}; ///< sum to 1
    [[nodiscard]] Vec3 in(std::span<const Vec3> positions) const {
        return positions[nodes[0]] * weights[0] + positions[nodes[1]] * weights[1] + positions[nodes[2]] * weights[2];
    }
};

/// Where a point of one piece of a mesh is in a drape: found in the display triangle that holds it, or the nearest.
class DrapedPiece {
public:
    /// nodes: flat positions in the piece; positions: draped, of the same nodes.
    DrapedPiece(const meshing::PieceMesh& mesh, std::span<const Vec3> positions);

    [[nodiscard]] MaterialPlace placeOf(Vec2 point) const;
    [[nodiscard]] Vec3 at(Vec2 point) const { return placeOf(point).in(positions_); }
    /// Nothing for a point that no triangle holds.
    [[nodiscard]] std::optional<Vec3> inside(Vec2 point) const;

private:
    [[nodiscard]] std::optional<MaterialPlace> placeInside(Vec2 point) const;
    [[nodiscard]] MaterialPlace inTriangle(std::size_t triangle, Vec2 point) const;

    const meshing::PieceMesh& mesh_;
    std::span<const Vec3> positions_;
    Vec2 low_;
    double cell_ = 1;
    int columns_ = 1, rows_ = 1;
    std::vector<std::vector<int>> trianglesIn_; ///< by grid cell
};

/// Brings nodes that these seams join to their middle, if none lies farther from it than half the gap [m]: sides that
/// are carried over, each on its own mesh, part a little. nodes: of all pieces, one after the other.
void joinSewn(const meshing::GarmentMesh& mesh, const std::vector<bool>& seams, double gap, std::span<Vec3> nodes);

} // namespace toile::simulation
