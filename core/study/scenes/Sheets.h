// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/scenes/Case.h"

/// Sheets of 1 m that are let go, held against a reference on the same mesh: the error is that of the steps alone.
namespace toile::study::scenes {

/// A sheet of 33 × 33 particles held along an edge, 0.4 s, at 50 N/m times a factor: error and cost, in units of
/// symplectic Euler, beside those of the prototype of the specification. Factors 1, 100, 1e4 and 1e6 have such.
[[nodiscard]] Case flapCase(double factor);

/// A sheet held at two corners, 0.5 s, of 500 N/m: 32, 64 or 128 cells have goals.
[[nodiscard]] Case hangingCase(int cells);

/// The same with 32 cells, times so much stiffer: 1e4 or 1e6.
[[nodiscard]] Case stiffHangingCase(double factor);

} // namespace toile::study::scenes
