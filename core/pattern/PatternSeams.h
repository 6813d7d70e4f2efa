// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/pattern/Editing.h"
#include "core/pattern/Ids.h"

#include <span>

namespace toile::pattern {

// Edits of seams. All are pure.

/// A stretch of an edge that the user picked; fractions as in SeamPart.
struct EdgePick {
    PieceId piece;
    EdgeId edge;
    double from = 0, to = 1;
};

/// Sews two chains of edges. The order of the picks is the order of the chain; no direction is asked for:
/// side A is walked as its contours run (counter-clockwise), so that side B, walked against its contours, joins right
/// side to right side. Where all pieces are placed and B turned round brings the ends nearer in space, it is turned.
/// Error when a stretch is already sewn.
[[nodiscard]] Result<Pattern> addSeam(const Pattern& pattern, std::span<const EdgePick> a, std::span<const EdgePick> b,
                                      std::string name, IdSource& ids);
[[nodiscard]] Result<Pattern> addSeam(const Pattern& pattern, const EdgePick& a, const EdgePick& b, IdSource& ids);
/// Sews two chains as they are walked here: first meets first.
[[nodiscard]] Result<Pattern> addSeam(const Pattern& pattern, std::array<std::vector<SeamPart>, 2> sides,
                                      std::string name, IdSource& ids);

/// Turns side B round: its first end now meets side A's last.
[[nodiscard]] Result<Pattern> reverseSeam(const Pattern& pattern, const SeamId& seam);
[[nodiscard]] Result<Pattern> removeSeam(const Pattern& pattern, const SeamId& seam);

/// Wanted length of side A minus side B in one section [m]; a gather ratio of the section goes.
[[nodiscard]] Result<Pattern> setSeamEase(const Pattern& pattern, const SeamId& seam, std::size_t section, double ease);
/// Declares the difference of lengths that every section of the seam has now as wanted.
[[nodiscard]] Result<Pattern> easeAway(const Pattern& pattern, const SeamId& seam);
/// The same as gathers: a thread draws up the longer side of every section, also where the shorter one is of knit.
[[nodiscard]] Result<Pattern> gatherAway(const Pattern& pattern, const SeamId& seam);
/// Some section of the seam has a gather ratio.
[[nodiscard]] bool isGathered(const Seam& seam);
/// Whether lengths may be in this ratio: from 0.01 to 100, both excluded.
[[nodiscard]] bool isGatherRatio(double ratio);
/// Wanted length A / length B of one section.
[[nodiscard]] Result<Pattern> setGatherRatio(const Pattern& pattern, const SeamId& seam, std::size_t section,
                                             double ratio);
/// Rest angle [rad]; 0 = flat.
[[nodiscard]] Result<Pattern> setFoldAngle(const Pattern& pattern, const SeamId& seam, double angle);
[[nodiscard]] Result<Pattern> setSeamStiffness(const Pattern& pattern, const SeamId& seam, double factor);
/// Absent = none is sewn in.
[[nodiscard]] Result<Pattern> setElastic(const Pattern& pattern, const SeamId& seam, std::optional<Elastic> elastic);
/// The ratio lies between 0 and 1 and the stiffness is positive; the error's path names the field.
[[nodiscard]] Result<void> checked(const Elastic& elastic);
[[nodiscard]] Result<Pattern> setSeamOrder(const Pattern& pattern, const SeamId& seam, int order);
[[nodiscard]] Result<Pattern> renameSeam(const Pattern& pattern, const SeamId& seam, std::string name);

/// All pieces are placed, and turning side B round brings the ends of the two sides clearly nearer in space.
[[nodiscard]] bool isTwisted(const Pattern& pattern, const Seam& seam);
/// The seam that sews a part of this stretch, if there is one; of two, the first.
[[nodiscard]] const Seam* seamOver(const Pattern& pattern, const EdgePick& stretch);

} // namespace toile::pattern
