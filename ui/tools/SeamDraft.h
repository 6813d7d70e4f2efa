// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/pattern/PatternSeams.h"
#include "ui/tools/Tool.h"
#include "ui/values/Picking.h"

namespace toile::ui {

/// The whole edge that was picked.
[[nodiscard]] pattern::EdgePick wholeEdge(const EdgeHit& picked);
/// The stretch of one edge between two places.
[[nodiscard]] pattern::EdgePick stretch(const EdgeHit& first, const EdgeHit& then);

/// Which ends meet.
enum class Meeting {
    best,   ///< the pattern decides: right side to right side, the nearer ends in space
    alike,  ///< the beginnings of both edges (of the source's, for mirror pieces)
    across, ///< the beginning of one and the end of the other
};
/// The document with a seam more: the last one.
[[nodiscard]] Result<document::Document> withSeam(const document::Document& document, const pattern::EdgePick& a,
                                                  const pattern::EdgePick& b, Meeting meeting);
/// The same as an effect: the seam is selected, the message tells the lengths.
[[nodiscard]] Effect sewn(const Desk& desk, const pattern::EdgePick& a, const pattern::EdgePick& b, Meeting meeting);

/// Draws one side: the way, a dot where it begins, arrows along it.
void addSide(Overlay& overlay, const FlatPattern& flat, const pattern::SeamPart& part, Overlay::Role role);
/// Links the points that meet.
void addLinks(Overlay& overlay, const FlatPattern& flat, const pattern::SeamPart& a, const pattern::SeamPart& b);
/// Both sides of a seam that may come to be, with links and lengths.
void addSeam(Overlay& overlay, const FlatPattern& flat, const pattern::Seam& seam, Vec2 labelAt);
/// "250.0 mm to 252.0 mm, difference −2.0 mm"
[[nodiscard]] QString lengthsText(const FlatPattern& flat, const pattern::SeamPart& a, const pattern::SeamPart& b);

} // namespace toile::ui
