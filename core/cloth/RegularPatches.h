// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/cloth/Patch.h"

namespace toile::cloth {

/// A weave with all that springs can have, each in another measure, for cases with known answers.
[[nodiscard]] material::Fabric unequalWeave();

/// Lines at 0, spacing, …, extent.
[[nodiscard]] std::vector<double> evenLines(double extent, int cells);

/// Rectangles between all neighbouring lines; node (i, j) = j·|weft| + i, particles as nodes.
[[nodiscard]] Patch gridPatch(const std::vector<double>& weft, const std::vector<double>& warp);

/// The same with every rectangle cut along its rising diagonal.
[[nodiscard]] Patch trianglePatch(const std::vector<double>& weft, const std::vector<double>& warp);

/// Columns of width × height: coarse cells up to warp = split, beyond it cells whose spacing is `ratio` times finer,
/// slaves on the joint.
[[nodiscard]] Patch twoRegionPatch(double width, int coarseColumns, double split, int coarseRows, double height,
                                   int fineRows, int ratio = 2);

/// Every node in the plane z = 0 at its material coordinates.
[[nodiscard]] std::vector<Vec3> flatPositions(const Patch& patch);

} // namespace toile::cloth
