// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pattern/CheckParts.h"
#include "core/pattern/PatternMeasures.h"
#include "core/pattern/PatternTacks.h"

#include <cmath>
#include <fmt/format.h>

namespace toile::pattern {
namespace {

void checkEnd(const Pattern& pattern, const ClothPoint& end, const char* member, const std::set<PieceId>& unsound,
              Problems& problems) {
    const Piece* piece = findPiece(pattern, end.piece);
    if (!piece) {
        problems.error(std::string(member) + ".piece", fmt::format("There is no piece \"{}\".", end.piece.value));
        return;
    }
    const Piece* shape = shapeOf(pattern, *piece);
    if (!shape || unsound.contains(shape->id)) return; // their own problem
    if (!isOnCloth(pattern, *piece, end.point))
        problems.error(std::string(member) + ".point",
                       fmt::format("A tack holds cloth: this point lies outside the piece \"{}\".", piece->name));
}

} // namespace

void checkTacks(const Pattern& pattern, const std::set<PieceId>& unsound, std::vector<Problem>& all) {
    std::set<TackId> ids;
    for (std::size_t i = 0; i < pattern.tacks.size(); ++i) {
        const Tack& tack = pattern.tacks[i];
        Problems problems(all, fmt::format("tacks[{}]", i), placeOf(tack).object);
        if (!ids.insert(tack.id).second)
            problems.error("id", fmt::format("The id \"{}\" is given twice.", tack.id.value));
        checkEnd(pattern, tack.ends[0], "a", unsound, problems);
        checkEnd(pattern, tack.ends[1], "b", unsound, problems);
        if (tack.ends[0] == tack.ends[1]) problems.error("b", "A tack needs two different places.");
        if (tack.buttonDiameter && !(*tack.buttonDiameter > 0 && std::isfinite(*tack.buttonDiameter)))
            problems.error("buttonDiameter", "The diameter of a button must be a positive length.");
    }
}

} // namespace toile::pattern
