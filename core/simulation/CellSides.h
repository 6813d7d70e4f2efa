// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/cloth/ClothModel.h"
#include "core/material/Fabric.h"
#include "core/pattern/Pattern.h"
#include "core/simulation/ParticleMap.h"

namespace toile::simulation {

/// A side of an element, run through counter-clockwise, with the element's other corners.
struct CellSide {
    int piece = 0;
    int from = 0, to = 0;      ///< nodes of the piece
    std::vector<int> opposite; ///< one for a triangle; for a rectangle the neighbour of from, then that of to
};

/// Calls use(side) for the sides of all rectangles, then of all triangles.
template <class Use>
void forEachSide(const meshing::PieceMesh& mesh, int piece, Use use) {
    for (const meshing::Rectangle& cell : mesh.rectangles)
        for (std::size_t i = 0; i < 4; ++i)
            use(CellSide{
                piece, cell.nodes[i], cell.nodes[(i + 1) % 4], {cell.nodes[(i + 3) % 4], cell.nodes[(i + 2) % 4]}});
    for (const meshing::Triangle& t : mesh.triangles)
        for (std::size_t i = 0; i < 3; ++i)
            use(CellSide{piece, t.nodes[i], t.nodes[(i + 1) % 3], {t.nodes[(i + 2) % 3]}});
}

/// The fabrics of all pieces, fused as they are.
[[nodiscard]] std::vector<material::Fabric> clothsOf(const pattern::Pattern& pattern);

/// Bending stiffness for a fold along the side [N·m].
[[nodiscard]] double bendingAcross(const meshing::PieceMesh& mesh, const CellSide& side, const material::Fabric& cloth);

/// How the elements on both sides of an edge are held to each other.
struct Joint {
    double bending = 0;   ///< B across the edge [N·m]
    double restAngle = 0; ///< [rad]
};

/// Appends the hinges between two sides that lie on one edge of the garment and run against each other. A rectangle
/// has two opposite corners: two hinges share its stiffness, each with the corner at its own end. None where corners
/// of both are one particle.
void appendHinges(cloth::ClothModel& model, const meshing::GarmentMesh& mesh, const ParticleMap& particles,
                  const CellSide& left, const CellSide& right, const Joint& joint);

} // namespace toile::simulation
