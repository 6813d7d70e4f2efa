// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/meshing/CellMesh.h"

namespace toile::meshing {

struct ImprovementSettings {
    double wantedAngle = 28; ///< [degrees]; the smallest angle of strip triangles away from the input's own corners
    int passes = 8;          ///< of moving nodes, freeing nodes and triangulating again
};

/// Triangulates the strip; then moves free nodes and frees bad staircase nodes by giving up their rectangles
/// until the wanted angle is reached. Keeps the best of all passes. Works on grid points alone, so that
/// mirror images stay mirror images.
void improveStrip(const PieceFrame& frame, const BoundaryNodes& boundary, const Lattice& lattice, GridFill& fill,
                  CellMesh& mesh, const ImprovementSettings& settings = {});

} // namespace toile::meshing
