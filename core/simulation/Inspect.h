// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/cloth/Patch.h"
#include "core/simulation/Sew.h"

namespace toile::simulation {

/// The elements of a piece as the measures of strain and curvature take them.
[[nodiscard]] cloth::Patch elementsOf(const Garment& garment, std::size_t piece);

/// Strain of the garment; zero without an element.
[[nodiscard]] StrainSummary strainOf(const Simulation& simulation);

/// Strain of its woven pieces; none if all are knits. The largest stretch is the mean over 10 mm across, or over an
/// element where that is larger.
[[nodiscard]] std::optional<StrainSummary> wovenStrainOf(const Simulation& simulation);

/// Curvature of the garment; zero without lines of rectangles.
[[nodiscard]] CurvatureSummary curvatureOf(const Simulation& simulation);

/// Pairs of triangles that meet.
struct Intersections {
    int body = 0;
    int self = 0;        ///< of cloth, that share no corner and will share none when all seams are closed
    int atOpenSeams = 0; ///< of cloth, that will share a corner then: the sides of a seam that closes pass each other
};

/// Counted by a test that shares no code with the contact stages.
[[nodiscard]] Intersections intersectionsOf(const Simulation& simulation);

/// How the cloth lies to the body and to itself; counted by a test that shares no code with the contact stages.
[[nodiscard]] ContactSummary contactOf(const Simulation& simulation);

/// The drape as the verdict "worn" needs it.
[[nodiscard]] Drape drapeOf(const Simulation& simulation);

/// SHA-256 of the positions of all nodes, little-endian doubles, in order of piece, row (v), column (u).
[[nodiscard]] std::string resultHash(const Simulation& simulation);

} // namespace toile::simulation
