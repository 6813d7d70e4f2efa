// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/meshing/GarmentMesh.h"

namespace toile::meshing {

/// Counts, angles, shapes and topology of a mesh; what depends on its input is added by whoever knows it.
[[nodiscard]] PieceReport qualityOf(const PieceMesh& mesh);

[[nodiscard]] double meshedArea(const PieceMesh& mesh); ///< [m²]

/// Sums of counts, worst of shapes.
[[nodiscard]] PieceReport totalOf(const std::vector<PieceReport>& pieces);

} // namespace toile::meshing
