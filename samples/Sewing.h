// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/pattern/Pattern.h"

#include <string>
#include <vector>

namespace toile::samples {

/// A piece whose id is its name in lower case with dashes; nothing else set but fabric and spacing [m].
[[nodiscard]] pattern::Piece pieceNamed(const std::string& id, const std::string& name, const pattern::Fabric& fabric,
                                        double spacing);

/// The mirror image, at the source's y axis, of a piece that is placed; it starts as the mirror image in the world.
[[nodiscard]] pattern::Piece mirrorPiece(const std::string& id, const std::string& name, const pattern::Piece& source);

/// A whole edge of a piece, or of the source of a mirror piece.
struct Side {
    pattern::PieceId piece;
    pattern::EdgeId edge;
    bool reversed = false;
};
[[nodiscard]] Side along(const pattern::Piece& piece, const std::string& edge);
[[nodiscard]] Side against(const pattern::Piece& piece, const std::string& edge);

[[nodiscard]] pattern::Seam seam(const std::string& name, const std::vector<Side>& a, const std::vector<Side>& b,
                                 std::vector<pattern::SeamSection> sections = {});

} // namespace toile::samples
