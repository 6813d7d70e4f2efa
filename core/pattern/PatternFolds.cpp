// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pattern/PatternFolds.h"

#include "core/pattern/CheckParts.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace toile::pattern {
namespace {

/// The first thing that is wrong with a fold of a piece, as an edit says it.
Result<void> checked(const Piece& piece, const Fold& fold) {
    Piece alone = piece;
    alone.folds = {fold};
    std::vector<Problem> problems;
    Problems collected(problems, "", placeOf(piece, fold).object);
    checkFolds(alone, collected);
    const auto wrong = std::ranges::find(problems, true, &Problem::isError);
    if (wrong == problems.end()) return {};
    return fail(ErrorCode::invalidInput, wrong->text, placeOf(piece, fold));
}

Result<Pattern> changedFold(const Pattern& pattern, const PieceId& piece, const FoldId& id,
                            const std::function<void(Fold&)>& change) {
    return changedShape(pattern, piece, [&](Piece& p) -> Result<void> {
        const auto found = std::ranges::find(p.folds, id, &Fold::id);
        if (found == p.folds.end())
            return fail(ErrorCode::notFound, fmt::format("There is no fold \"{}\".", id.value), placeOf(p));
        change(*found);
        return checked(p, *found);
    });
}

} // namespace

const Fold* findFold(const Piece& piece, const FoldId& id) {
    const auto found = std::ranges::find(piece.folds, id, &Fold::id);
    return found == piece.folds.end() ? nullptr : &*found;
}

std::optional<Vec2> pointOf(const Piece& piece, const BorderPoint& end) {
    const auto edge = findEdge(piece, end.edge);
    if (!edge) return std::nullopt;
    return geometry::ArcLength(curveOf(piece, *edge)).pointAt(end.position);
}

std::vector<Vec2> pointsOf(const Piece& piece, const Fold& fold) {
    const auto first = pointOf(piece, fold.ends[0]), last = pointOf(piece, fold.ends[1]);
    if (!first || !last) return {};
    std::vector<Vec2> points{*first};
    points.insert(points.end(), fold.between.begin(), fold.between.end());
    points.push_back(*last);
    return points;
}

Result<Pattern> addFold(const Pattern& pattern, const PieceId& piece, const std::array<BorderPoint, 2>& ends,
                        std::vector<Vec2> between, double angle, std::string name, IdSource& ids) {
    return changedShape(pattern, piece, [&](Piece& p) -> Result<void> {
        Fold fold;
        fold.id = ids.take<FoldId>();
        fold.name = std::move(name);
        fold.ends = ends;
        fold.between = std::move(between);
        fold.angle = angle;
        if (auto ok = checked(p, fold); !ok) return ok;
        p.folds.push_back(std::move(fold));
        return {};
    });
}

Result<Pattern> removeFold(const Pattern& pattern, const PieceId& piece, const FoldId& fold) {
    return changedShape(pattern, piece, [&](Piece& p) -> Result<void> {
        if (std::erase_if(p.folds, [&](const Fold& f) { return f.id == fold; }) == 0)
            return fail(ErrorCode::notFound, fmt::format("There is no fold \"{}\".", fold.value), placeOf(p));
        return {};
    });
}

Result<Pattern> renameFold(const Pattern& pattern, const PieceId& piece, const FoldId& fold, std::string name) {
    return changedFold(pattern, piece, fold, [&](Fold& f) { f.name = std::move(name); });
}

Result<Pattern> pressFold(const Pattern& pattern, const PieceId& piece, const FoldId& fold, double angle) {
    return changedFold(pattern, piece, fold, [&](Fold& f) { f.angle = angle; });
}

Result<Pattern> setFoldStiffness(const Pattern& pattern, const PieceId& piece, const FoldId& fold, double factor) {
    return changedFold(pattern, piece, fold, [&](Fold& f) { f.stiffnessFactor = factor; });
}

Result<Pattern> moveFoldEnd(const Pattern& pattern, const PieceId& piece, const FoldId& fold, std::size_t end,
                            const BorderPoint& to) {
    return changedFold(pattern, piece, fold, [&](Fold& f) { f.ends[end] = to; });
}

} // namespace toile::pattern
