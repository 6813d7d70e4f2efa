// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/meshing/GarmentMesh.h"

#include <QLineF>
#include <QList>

#include <vector>

namespace toile::ui {

/// The lines of a piece's mesh in the piece's own coordinates [m], each drawn once.
struct PieceLines {
    QList<QLineF> lines;
    double spacing = 0; ///< mean length of the lines [m]: too dense a mesh is not drawn line by line
};

/// By piece, in the order of the pattern.
using MeshLines = std::vector<PieceLines>;

/// Sides of rectangles and triangles; where two triangles make one quad, their common side is left out.
[[nodiscard]] MeshLines meshLinesOf(const meshing::GarmentMesh& mesh);

} // namespace toile::ui
