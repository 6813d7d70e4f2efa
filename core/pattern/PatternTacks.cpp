// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pattern/PatternTacks.h"

#include "core/pattern/PatternMeasures.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace toile::pattern {
namespace {

constexpr double outlineError = 1e-4; ///< of outlines that points are judged by [m]

Result<Pattern> changed(const Pattern& pattern, const TackId& id, const std::function<Result<void>(Tack&)>& change) {
    Pattern next = pattern;
    const auto found = std::ranges::find(next.tacks, id, &Tack::id);
    if (found == next.tacks.end()) return fail(ErrorCode::notFound, fmt::format("There is no tack \"{}\".", id.value));
    if (auto done = change(*found); !done) return tl::unexpected<Error>(std::move(done).error());
    return next;
}

Result<void> checkedEnd(const Pattern& pattern, const ClothPoint& end) {
    const Piece* piece = findPiece(pattern, end.piece);
    if (!piece) return fail(ErrorCode::notFound, fmt::format("There is no piece \"{}\".", end.piece.value));
    if (!isOnCloth(pattern, *piece, end.point))
        return fail(ErrorCode::invalidInput, "A tack holds cloth: this point lies outside the piece.", placeOf(*piece));
    return {};
}

} // namespace

const Tack* findTack(const Pattern& pattern, const TackId& id) {
    const auto found = std::ranges::find(pattern.tacks, id, &Tack::id);
    return found == pattern.tacks.end() ? nullptr : &*found;
}

Place placeOf(const Tack& tack) {
    return {.object = fmt::format("tack \"{}\"", tack.name)};
}

bool isOnCloth(const Pattern& pattern, const Piece& piece, Vec2 point) {
    if (!geometry::isFinite(point)) return false;
    const Piece shape = resolved(pattern, piece);
    const auto inside = [&](const Contour& contour) {
        return geometry::windingNumber(flattened(contour, outlineError), point) != 0;
    };
    const auto atBorder = [&](const Contour& contour) {
        return geometry::distanceToBorder(flattened(contour, outlineError), point) <= outlineError;
    };
    if (!inside(shape.outline)) return atBorder(shape.outline);
    return std::ranges::none_of(shape.holes, [&](const Contour& hole) { return inside(hole) && !atBorder(hole); });
}

Result<Pattern> addTack(const Pattern& pattern, const std::array<ClothPoint, 2>& ends, std::string name,
                        IdSource& ids) {
    for (const ClothPoint& end : ends)
        if (auto ok = checkedEnd(pattern, end); !ok) return tl::unexpected<Error>(std::move(ok).error());
    if (ends[0] == ends[1]) return fail(ErrorCode::invalidInput, "A tack needs two different places.");
    Pattern next = pattern;
    Tack tack;
    tack.id = ids.take<TackId>();
    tack.name = std::move(name);
    tack.ends = ends;
    next.tacks.push_back(std::move(tack));
    return next;
}

Result<Pattern> removeTack(const Pattern& pattern, const TackId& tack) {
    Pattern next = pattern;
    if (std::erase_if(next.tacks, [&](const Tack& t) { return t.id == tack; }) == 0)
        return fail(ErrorCode::notFound, fmt::format("There is no tack \"{}\".", tack.value));
    return next;
}

Result<Pattern> moveTackEnd(const Pattern& pattern, const TackId& tack, std::size_t end, Vec2 point) {
    return changed(pattern, tack, [&](Tack& t) -> Result<void> {
        t.ends[end].point = point;
        if (t.ends[0] == t.ends[1])
            return fail(ErrorCode::invalidInput, "A tack needs two different places.", placeOf(t));
        return checkedEnd(pattern, t.ends[end]);
    });
}

Result<Pattern> renameTack(const Pattern& pattern, const TackId& tack, std::string name) {
    return changed(pattern, tack, [&](Tack& t) -> Result<void> {
        t.name = std::move(name);
        return {};
    });
}

Result<Pattern> setButtonDiameter(const Pattern& pattern, const TackId& tack, std::optional<double> diameter) {
    return changed(pattern, tack, [&](Tack& t) -> Result<void> {
        if (diameter && !(*diameter > 0 && std::isfinite(*diameter)))
            return fail(ErrorCode::invalidInput, "The diameter of a button must be a positive length.", placeOf(t));
        t.buttonDiameter = diameter;
        return {};
    });
}

Result<Pattern> setTackOrder(const Pattern& pattern, const TackId& tack, int order) {
    return changed(pattern, tack, [&](Tack& t) -> Result<void> {
        t.order = order;
        return {};
    });
}

} // namespace toile::pattern
