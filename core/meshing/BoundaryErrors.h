// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/meshing/FlatContour.h"

#include <optional>

namespace toile::meshing {

// What is no piece of cloth, each with its sentence: nothing where there is nothing to refuse.

/// Spacing, grain and regions.
[[nodiscard]] std::optional<Error> settingError(const PieceInput& piece);
/// Coordinates, gaps between the edges of a loop, and notches.
[[nodiscard]] std::optional<Error> edgeError(const PieceInput& piece, int loop);
/// Borders that cross or touch themselves or each other.
[[nodiscard]] std::optional<Error> crossingError(const PieceInput& piece, const PieceFrame& frame,
                                                 std::span<const FlatContour> contours, Arena& arena);
/// Holes outside the piece or in each other; the first contour is the outline.
[[nodiscard]] std::optional<Error> nestingError(const PieceInput& piece, std::span<const FlatContour> contours);
/// More cells than a machine holds.
[[nodiscard]] std::optional<Error> sizeError(const PieceInput& piece, const PieceBoundary& boundary);

} // namespace toile::meshing
