// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/pattern/Editing.h"
#include "core/pattern/Ids.h"

namespace toile::pattern {

/// A wedge that is cut out of a piece and sewn shut.
struct Dart {
    EdgeId edge;         ///< the mouth lies on it
    double middle = 0.5; ///< of the mouth, a fraction of the edge's arc length
    double width = 0.03; ///< of the mouth, along the edge [m]
    Vec2 tip;            ///< inside the piece [m]
};

/// Cuts a dart and sews its legs, mouth to mouth, tip to tip; in mirror images too. Seams along the edge pass
/// over the mouth. Error when the mouth reaches beyond the edge, when a notch lies in it, or when the tip is
/// not inside.
[[nodiscard]] Result<Pattern> addDart(const Pattern& pattern, const PieceId& piece, const Dart& dart, std::string name,
                                      IdSource& ids);

} // namespace toile::pattern
