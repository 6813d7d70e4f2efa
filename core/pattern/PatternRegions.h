// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/pattern/Editing.h"
#include "core/pattern/Ids.h"

#include <span>

namespace toile::pattern {

// Edits of painted regions. All are pure. Coordinates are the piece's [m].

/// A region with straight borders; turned to run counter-clockwise. A border that crosses itself becomes that of what
/// it encloses. Error when that is nothing, or of several parts.
[[nodiscard]] Result<Pattern> addRegion(const Pattern& pattern, const PieceId& piece, Polygon outline, std::string name,
                                        int refinement, IdSource& ids);
[[nodiscard]] Result<Pattern> removeRegion(const Pattern& pattern, const PieceId& piece, const RegionId& region);
[[nodiscard]] Result<Pattern> renameRegion(const Pattern& pattern, const PieceId& piece, const RegionId& region,
                                           std::string name);
/// m of the spacing ε_m / 2^m, 0 … 16.
[[nodiscard]] Result<Pattern> setRefinement(const Pattern& pattern, const PieceId& piece, const RegionId& region,
                                            int refinement);
[[nodiscard]] Result<Pattern> setStiffness(const Pattern& pattern, const PieceId& piece, const RegionId& region,
                                           const StiffnessFactors& stiffness);

/// A brush: a disc of this radius [m] drawn along points.
struct Stroke {
    std::vector<Vec2> points;
    double radius = 0.01;
};

/// Begins a region with a stroke.
[[nodiscard]] Result<Pattern> paintNewRegion(const Pattern& pattern, const PieceId& piece, const Stroke& stroke,
                                             std::string name, int refinement, IdSource& ids);
/// Adds a stroke to a region. Error when it does not touch the region: a region is of one part.
[[nodiscard]] Result<Pattern> paintRegion(const Pattern& pattern, const PieceId& piece, const RegionId& region,
                                          const Stroke& stroke);
/// Takes a stroke away. A part that is cut off becomes a region of its own; nothing left = the region is removed.
[[nodiscard]] Result<Pattern> eraseRegion(const Pattern& pattern, const PieceId& piece, const RegionId& region,
                                          const Stroke& stroke, IdSource& ids);

} // namespace toile::pattern
