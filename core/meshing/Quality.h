// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/meshing/GarmentMesh.h"

namespace toile::meshing {

/// Counts of a mesh.
[[nodiscard]] PieceReport countsOf(const PieceMesh& mesh);

/// Adds angles, shapes and topology; what depends on the mesh's input is added by whoever knows it.
void judge(const PieceMesh& mesh, PieceReport& report);

[[nodiscard]] double meshedArea(const PieceMesh& mesh); ///< [m²]

/// Sums of counts, worst of shapes.
[[nodiscard]] PieceReport totalOf(const std::vector<PieceReport>& pieces);

} // namespace toile::meshing
