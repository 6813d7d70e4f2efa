// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Result.h"
#include "core/pattern/Pattern.h"

#include <functional>
#include <optional>
#include <string>

namespace toile::samples {

/// Length of the horizontal line at height y inside the piece, holes and open darts left out: the net width [m].
[[nodiscard]] double widthAt(const pattern::Piece& piece, double y);

/// Arc length of an edge of the outline or of a hole [m].
[[nodiscard]] double edgeLength(const pattern::Piece& piece, const pattern::EdgeId& edge);

/// The angle inside the piece at a corner of its outline [rad].
[[nodiscard]] double cornerAngle(const pattern::Piece& piece, const pattern::VertexId& vertex);

/// Length of one side of a seam [m]; side 0 or 1.
[[nodiscard]] double sideLength(const pattern::Pattern& pattern, const pattern::Seam& seam, int side);

[[nodiscard]] Vec2 vertexPosition(const pattern::Piece& piece, const pattern::VertexId& vertex);

/// Settles the free measures of a draft. Not every body has a solution: the first measure without one is remembered,
/// its nearer end is taken, and whoever drafts asks `error` before the draft is given away.
class Solver {
public:
    /// Where a function that changes its sign once between low and high is zero, to the last bits (bisection).
    [[nodiscard]] double rootOf(const std::string& measure, const std::function<double(double)>& function, double low,
                                double high);
    /// Names the measure that has no solution.
    [[nodiscard]] const std::optional<Error>& error() const { return error_; }

private:
    std::optional<Error> error_;
};

} // namespace toile::samples
