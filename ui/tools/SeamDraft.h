// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/pattern/PatternSeams.h"
#include "ui/tools/Tool.h"
#include "ui/values/Picking.h"

#include <array>

namespace toile::ui {

using SeamSides = std::array<std::vector<pattern::SeamPart>, 2>;

/// The whole edge that was picked.
[[nodiscard]] pattern::EdgePick wholeEdge(const EdgeHit& picked);
/// The stretch of one edge between two places, walked from the first.
[[nodiscard]] pattern::SeamPart stretch(const EdgeHit& first, const EdgeHit& then);

/// Whole edges in a row, as they were picked. Each is walked from where it meets the one before it – in a
/// corner of the piece, or over a seam that joins their ends – and where it meets none, from the end nearer
/// to its click.
[[nodiscard]] std::vector<pattern::SeamPart> chainOf(const Desk& desk, const std::vector<EdgeHit>& picks);

/// The document with one seam more, the last one: whole edges in two rows. The ends picked meet. A single
/// edge that was picked near its middle says nothing about its ends: then right side goes to right side, the
/// nearer ends in space.
[[nodiscard]] Result<document::Document> withSeam(const Desk& desk, const std::vector<EdgeHit>& a,
                                                  const std::vector<EdgeHit>& b);
/// The same of sides as they are walked.
[[nodiscard]] Result<document::Document> withSeam(const document::Document& document, const SeamSides& sides);
/// The document with its new seam as an effect: the seam is selected, the message tells the lengths.
[[nodiscard]] Effect sewn(const Desk& desk, Result<document::Document> withSeam);

/// Draws one side: the way, a dot where it begins, arrows along it.
void addSide(Overlay& overlay, const FlatPattern& flat, const std::vector<pattern::SeamPart>& side, Overlay::Role role);
/// Both sides of a seam that may come to be, with links between the points that meet, and lengths.
void addSeam(Overlay& overlay, const FlatPattern& flat, const SeamSides& sides, Vec2 labelAt);
/// "250.0 mm to 252.0 mm, difference −2.0 mm"
[[nodiscard]] QString lengthsText(const FlatPattern& flat, const SeamSides& sides);

} // namespace toile::ui
