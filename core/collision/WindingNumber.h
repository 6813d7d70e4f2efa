// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/collision/BoxTree.h"

namespace toile::collision {

/// How often a surface winds round a point: 1 inside a closed surface that faces outward, 0 outside of it, −1 inside
/// one that faces inward, 2 where two such insides overlap. The sum of the solid angles of all triangles over 4π.
///
/// Triangles lie under a hierarchy of boxes; a box that is far away for its size counts as one small plate.
/// Ref: Barill et al. 2018, Fast winding numbers for soups and clouds
class WindingNumber {
public:
    /// The mesh has at least one triangle; those without area count for nothing.
    explicit WindingNumber(geometry::TriangleMesh mesh);

    /// Of a point that is not on the surface; within 0.02 of the exact value.
    [[nodiscard]] double at(const Vec3& point) const;

    /// At the centre of a triangle, the mean of the values just before and just behind it: on a closed surface the
    /// integer before it and ½.
    [[nodiscard]] double onTriangle(int triangle) const;

private:
    /// What the triangles in a box are from afar.
    struct Plate {
        Vec3 centre, area; ///< area: sum of the triangles' area vectors [m²]
        double reach = 0;  ///< of the farthest corner from the centre [m]
    };

    [[nodiscard]] std::vector<int> trianglesBelow(int node) const;
    [[nodiscard]] Plate plateOf(const std::vector<int>& triangles) const;
    [[nodiscard]] double solidAngle(const Vec3& point, int leftOut) const; ///< of all triangles but one [sr]

    geometry::TriangleMesh mesh_;
    std::vector<BoxNode> boxes_;
    std::vector<Plate> plates_;
};

} // namespace toile::collision
