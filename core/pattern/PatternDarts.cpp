// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pattern/PatternDarts.h"

#include "core/pattern/EdgeFractions.h"
#include "core/pattern/PatternContours.h"
#include "core/pattern/PatternMeasures.h"
#include "core/pattern/PatternSeams.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace toile::pattern {
namespace {

/// The mouth as fractions of its edge.
struct Mouth {
    double from = 0, to = 1;
};

/// A seam that would lose a whole side.
const Seam* seamWithin(const Pattern& pattern, const Piece& piece, const EdgeId& edge, const Mouth& mouth) {
    constexpr double rounding = 1e-9; // of fractions
    const auto isWithin = [&](const SeamPart& part) {
        return liesOn(pattern, part, piece.id, edge) && part.from >= mouth.from - rounding &&
               part.to <= mouth.to + rounding;
    };
    const auto found = std::ranges::find_if(pattern.seams, [&](const Seam& seam) {
        return std::ranges::any_of(seam.sides, [&](const auto& side) { return std::ranges::all_of(side, isWithin); });
    });
    return found == pattern.seams.end() ? nullptr : &*found;
}

Result<Mouth> mouthOf(const Pattern& pattern, const Piece& piece, const Dart& dart) {
    if (!findEdge(piece, dart.edge)) return fail(ErrorCode::notFound, "There is no such edge.", placeOf(piece));
    if (!(dart.width > 0 && std::isfinite(dart.width)))
        return fail(ErrorCode::invalidInput, "A dart needs a width.", placeOf(piece));
    const double half = dart.width / 2 / edgeLength(piece, dart.edge);
    const Mouth mouth{dart.middle - half, dart.middle + half};
    constexpr double nearEnd = 1e-6;
    if (!(mouth.from > nearEnd && mouth.to < 1 - nearEnd))
        return fail(ErrorCode::invalidInput, "The mouth of the dart reaches beyond the edge.", placeOf(piece));
    if (std::ranges::any_of(piece.notches, [&](const Notch& notch) {
            return notch.edge == dart.edge && notch.position > mouth.from && notch.position < mouth.to;
        }))
        return fail(ErrorCode::invalidInput, "There is a notch in the mouth of the dart: take it out first.",
                    placeOf(piece));
    if (std::ranges::any_of(piece.folds, [&](const Fold& fold) {
            return std::ranges::any_of(fold.ends, [&](const BorderPoint& end) {
                return end.edge == dart.edge && end.position > mouth.from && end.position < mouth.to;
            });
        }))
        return fail(ErrorCode::invalidInput, "A fold ends in the mouth of the dart: move it first.", placeOf(piece));
    if (const Seam* seam = seamWithin(pattern, piece, dart.edge, mouth))
        return fail(ErrorCode::invalidInput,
                    fmt::format("The seam \"{}\" lies in the mouth of the dart: delete it first.", seam->name),
                    placeOf(piece));
    if (geometry::windingNumber(flattened(piece.outline, 1e-4), dart.tip) == 0)
        return fail(ErrorCode::invalidInput, "The tip of the dart lies outside the piece.", placeOf(piece));
    return mouth;
}

/// The edge that follows another one round its contour.
EdgeId edgeAfter(const Pattern& pattern, const PieceId& id, const EdgeId& edge) {
    const Piece& piece = *findPiece(pattern, id);
    const LoopIndex at = *findEdge(piece, edge);
    const auto& edges = loopOf(piece, at.loop).edges;
    return edges[(at.index + 1) % edges.size()].id;
}

VertexId startOf(const Pattern& pattern, const PieceId& id, const EdgeId& edge) {
    const Piece& piece = *findPiece(pattern, id);
    const LoopIndex at = *findEdge(piece, edge);
    return loopOf(piece, at.loop).vertices[at.index].id;
}

struct Legs {
    EdgeId in, out; ///< to the tip, and back
};

/// What was sewn along the mouth is sewn no more.
void letGo(Pattern& pattern, const PieceId& piece, const Legs& legs) {
    const auto onLeg = [&](const SeamPart& part) {
        return liesOn(pattern, part, piece, legs.in) || liesOn(pattern, part, piece, legs.out);
    };
    for (Seam& seam : pattern.seams)
        for (auto& side : seam.sides) std::erase_if(side, onLeg);
}

/// The legs of the piece and of its mirror images.
Result<Pattern> sewn(Pattern pattern, const PieceId& piece, const Legs& legs, const std::string& name, IdSource& ids) {
    std::vector<PieceId> pieces{piece};
    for (const auto& other : pattern.pieces)
        if (other->mirror && other->mirror->source == piece) pieces.push_back(other->id);
    Result<Pattern> result = std::move(pattern);
    for (const PieceId& each : pieces) {
        const SeamPart in{each, legs.in, 0, 1, false}, out{each, legs.out, 0, 1, true};
        if (result) result = addSeam(*result, std::array<std::vector<SeamPart>, 2>{{{in}, {out}}}, name, ids);
    }
    return result;
}

} // namespace

Result<Pattern> addDart(const Pattern& pattern, const PieceId& piece, const Dart& dart, std::string name,
                        IdSource& ids) {
    const Piece* found = findPiece(pattern, piece);
    if (!found) return fail(ErrorCode::notFound, "There is no such piece.");
    if (found->mirror)
        return fail(ErrorCode::invalidInput, "This piece is a mirror image: edit the piece it is made from.",
                    placeOf(*found));
    const auto mouth = mouthOf(pattern, *found, dart);
    if (!mouth) return tl::unexpected<Error>(mouth.error());
    Result<Pattern> next = insertVertex(pattern, piece, dart.edge, mouth->to, ids);
    if (next) next = insertVertex(*next, piece, dart.edge, mouth->from / mouth->to, ids);
    if (!next) return next;
    Legs legs{edgeAfter(*next, piece, dart.edge), {}};
    next = insertVertex(*next, piece, legs.in, 0.5, ids);
    if (!next) return next;
    legs.out = edgeAfter(*next, piece, legs.in);
    next = setEdgeShape(*next, piece, legs.in, geometry::LineShape{});
    if (next) next = setEdgeShape(*next, piece, legs.out, geometry::LineShape{});
    if (next) next = moveVertex(*next, piece, startOf(*next, piece, legs.out), dart.tip);
    if (!next) return next;
    letGo(*next, piece, legs);
    return sewn(*std::move(next), piece, legs, name, ids);
}

} // namespace toile::pattern
