// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/SeamDraft.h"

#include "core/document/DocumentEdits.h"
#include "ui/values/Units.h"
#include "ui/values/Words.h"

#include <algorithm>
#include <cmath>

namespace toile::ui {
namespace {

using namespace pattern;

constexpr double samePoint = 1e-6; // [m]

/// An end of an edge: a place on the outline of a piece.
struct End {
    PieceId piece;
    Vec2 at;
};

bool isSame(const End& a, const End& b) {
    return a.piece == b.piece && distance(a.at, b.at) < samePoint;
}

End firstEnd(const FlatPattern& flat, const SeamPart& part) {
    return {part.piece, pathOf(flat, part).front()};
}
End lastEnd(const FlatPattern& flat, const SeamPart& part) {
    return {part.piece, pathOf(flat, part).back()};
}

/// The two ends are one corner, or a seam brings them together.
bool meet(const Desk& desk, const End& a, const End& b) {
    if (isSame(a, b)) return true;
    const auto joins = [&](const End& c, const End& d) {
        return (isSame(a, c) && isSame(b, d)) || (isSame(a, d) && isSame(b, c));
    };
    return std::ranges::any_of(desk.document.pattern.seams, [&](const Seam& seam) {
        const auto one = pathsOf(desk.flat, seam.sides[0]), other = pathsOf(desk.flat, seam.sides[1]);
        if (one.empty() || other.empty()) return false;
        const PieceId &first = seam.sides[0].front().piece, &last = seam.sides[0].back().piece;
        return joins({first, one.front().front()}, {seam.sides[1].front().piece, other.front().front()}) ||
               joins({last, one.back().back()}, {seam.sides[1].back().piece, other.back().back()});
    });
}

SeamPart turned(SeamPart part) {
    part.reversed = !part.reversed;
    return part;
}

/// Walked from the end nearer to the click.
SeamPart fromClick(const EdgeHit& hit) {
    return {hit.edge.piece, hit.edge.edge, 0, 1, hit.fraction > 0.5};
}

/// A single edge, picked where no end is meant.
bool saysNothing(const std::vector<EdgeHit>& picks) {
    return picks.size() == 1 && std::abs(picks[0].fraction - 0.5) < 0.2;
}

/// As its contour runs, seen from the right side.
bool runsAlong(const Pattern& pattern, const SeamPart& part) {
    const Piece* piece = findPiece(pattern, part.piece);
    return part.reversed == (piece && piece->mirror.has_value());
}

/// The side of one edge walked so that right side goes to right side, or the nearer ends meet in space.
void turnToFit(const Pattern& pattern, SeamSides& sides, std::size_t single) {
    SeamPart& part = sides[single].front();
    if (runsAlong(pattern, part) == runsAlong(pattern, sides[1 - single].front())) part = turned(part);
    Seam seam;
    seam.sides = sides;
    if (isTwisted(pattern, seam)) part = turned(part);
}

} // namespace

EdgePick wholeEdge(const EdgeHit& picked) {
    return {picked.edge.piece, picked.edge.edge, 0, 1};
}

SeamPart stretch(const EdgeHit& first, const EdgeHit& then) {
    const auto [from, to] = std::minmax(first.fraction, then.fraction);
    return {first.edge.piece, first.edge.edge, from, to, first.fraction > then.fraction};
}

std::vector<SeamPart> chainOf(const Desk& desk, const std::vector<EdgeHit>& picks) {
    std::vector<SeamPart> chain;
    for (std::size_t i = 0; i < picks.size(); ++i) {
        SeamPart part = fromClick(picks[i]);
        if (i == 1) { // the first edge ends where it meets the second
            const SeamPart& second = part;
            const auto meetsSecond = [&](const End& end) {
                return meet(desk, end, firstEnd(desk.flat, second)) || meet(desk, end, lastEnd(desk.flat, second));
            };
            if (!meetsSecond(lastEnd(desk.flat, chain[0])) && meetsSecond(firstEnd(desk.flat, chain[0])))
                chain[0] = turned(chain[0]);
        }
        if (i > 0) {
            const End before = lastEnd(desk.flat, chain.back());
            if (!meet(desk, before, firstEnd(desk.flat, part)) && meet(desk, before, lastEnd(desk.flat, part)))
                part = turned(part);
        }
        chain.push_back(part);
    }
    return chain;
}

Result<document::Document> withSeam(const document::Document& document, const SeamSides& sides) {
    return document::edited(
        document, [&](const Pattern& pattern, IdSource& ids) { return pattern::addSeam(pattern, sides, {}, ids); });
}

Result<document::Document> withSeam(const Desk& desk, const std::vector<EdgeHit>& a, const std::vector<EdgeHit>& b) {
    if (a.size() == 1 && b.size() == 1 && (saysNothing(a) || saysNothing(b)))
        return document::edited(desk.document, [&](const Pattern& pattern, IdSource& ids) {
            return pattern::addSeam(pattern, wholeEdge(a[0]), wholeEdge(b[0]), ids);
        });
    SeamSides sides{chainOf(desk, a), chainOf(desk, b)};
    if (saysNothing(a)) turnToFit(desk.document.pattern, sides, 0);
    if (saysNothing(b)) turnToFit(desk.document.pattern, sides, 1);
    return withSeam(desk.document, sides);
}

Effect sewn(const Desk& desk, Result<document::Document> withSeam) {
    Effect effect = effectOf(tr("Sew"), std::move(withSeam));
    if (!effect.edit) return effect;
    const Seam& seam = effect.edit->after.pattern.seams.back();
    effect.selection = Selection{seam.id};
    effect.message = lengthsText(desk.flat, seam.sides);
    return effect;
}

void addSide(Overlay& overlay, const FlatPattern& flat, const std::vector<SeamPart>& side, Overlay::Role role) {
    const auto paths = pathsOf(flat, side);
    if (paths.empty()) return;
    for (const auto& path : paths) {
        overlay.lines.push_back({path, role, false, false, 4});
        for (const double fraction : {0.25, 0.5, 0.75}) {
            const PathPoint point = pointAlong(path, fraction);
            overlay.arrows.push_back({point.position, point.direction, role});
        }
    }
    overlay.marks.push_back({paths.front().front(), role});
}

void addSeam(Overlay& overlay, const FlatPattern& flat, const SeamSides& sides, Vec2 labelAt) {
    addSide(overlay, flat, sides[0], Overlay::Role::sideA);
    addSide(overlay, flat, sides[1], Overlay::Role::sideB);
    const auto a = pathsOf(flat, sides[0]), b = pathsOf(flat, sides[1]);
    if (a.empty() || b.empty()) return;
    for (const double fraction : {0.0, 0.25, 0.5, 0.75, 1.0})
        overlay.lines.push_back({{pointAlong(a, fraction).position, pointAlong(b, fraction).position},
                                 Overlay::Role::accent,
                                 true,
                                 false,
                                 1});
    overlay.labels.push_back({labelAt, lengthsText(flat, sides), Overlay::Role::sideB});
}

QString lengthsText(const FlatPattern& flat, const SeamSides& sides) {
    const double a = lengthOf(pathsOf(flat, sides[0])), b = lengthOf(pathsOf(flat, sides[1]));
    return tr("%1 to %2, difference %3")
        .arg(textOf(Quantity::length, a), textOf(Quantity::length, b), differenceTextOf(Quantity::length, a - b));
}

} // namespace toile::ui
