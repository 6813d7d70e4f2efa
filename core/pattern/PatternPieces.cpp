// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pattern/PatternPieces.h"

#include "core/pattern/PatternMeasures.h"
#include "core/pattern/PatternTacks.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <utility>

namespace toile::pattern {
namespace {

constexpr double tableGap = 0.05;  ///< between pieces laid out on the table [m]
constexpr double tableWidth = 2.5; ///< of a row of pieces [m]

geometry::Box2 tableBox(const Pattern& pattern, const Piece& piece) {
    const Polygon outline = flattened(resolved(pattern, piece).outline, 1e-3);
    geometry::Box2 box = geometry::boundsOf(outline);
    box.low += piece.tablePosition;
    box.high += piece.tablePosition;
    return box;
}

bool overlap(const geometry::Box2& a, const geometry::Box2& b) {
    return a.low.x < b.high.x && b.low.x < a.high.x && a.low.y < b.high.y && b.low.y < a.high.y;
}

/// The piece itself and all mirror images of it.
std::vector<PieceId> withImages(const Pattern& pattern, const PieceId& piece) {
    std::vector<PieceId> ids{piece};
    for (const auto& other : pattern.pieces)
        if (other->mirror && other->mirror->source == piece) ids.push_back(other->id);
    return ids;
}

} // namespace

Result<Pattern> addPiece(const Pattern& pattern, Piece piece) {
    if (piece.id.empty()) return fail(ErrorCode::invalidInput, "A piece needs an id.", placeOf(piece));
    if (findPiece(pattern, piece.id))
        return fail(ErrorCode::invalidInput, fmt::format("There is a piece \"{}\" already.", piece.id.value),
                    placeOf(piece));
    if (!piece.mirror && piece.outline.vertices.empty())
        return fail(ErrorCode::invalidInput, "A piece needs an outline.", placeOf(piece));
    Pattern next = pattern;
    next.pieces.emplace_back(std::move(piece));
    return next;
}

Result<Pattern> addMirrorPiece(const Pattern& pattern, const PieceId& source, Vec2 lineStart, Vec2 lineEnd,
                               std::string name, IdSource& ids) {
    const Piece* original = findPiece(pattern, source);
    if (!original) return fail(ErrorCode::notFound, fmt::format("There is no piece \"{}\".", source.value));
    if (original->mirror)
        return fail(ErrorCode::invalidInput, "This piece is a mirror image: mirror the piece it is made from.",
                    placeOf(*original));
    if (!(geometry::distance(lineStart, lineEnd) > 1e-9))
        return fail(ErrorCode::invalidInput, "A mirror line needs two different points.", placeOf(*original));
    Piece image;
    image.id = ids.take<PieceId>();
    image.name = std::move(name);
    image.fabric = original->fabric;
    image.interfacing = original->interfacing;
    image.plies = original->plies;
    image.layer = original->layer;
    image.pressure = original->pressure;
    image.frozen = original->frozen;
    image.strengthened = original->strengthened;
    image.spacing = original->spacing;
    image.seamAllowance = original->seamAllowance;
    image.rule = original->rule;
    image.border = original->border;
    image.tablePosition = original->tablePosition;
    image.mirror = MirrorOf{source, lineStart, lineEnd};
    return addPiece(pattern, std::move(image));
}

Result<Pattern> duplicatePiece(const Pattern& pattern, const PieceId& piece, std::string name, IdSource& ids) {
    const Piece* original = findPiece(pattern, piece);
    if (!original) return fail(ErrorCode::notFound, fmt::format("There is no piece \"{}\".", piece.value));
    Piece copy = *original;
    copy.id = ids.take<PieceId>();
    copy.name = std::move(name);
    const auto renew = [&](Contour& contour) {
        for (Vertex& vertex : contour.vertices) vertex.id = ids.take<VertexId>();
        for (Edge& edge : contour.edges) {
            const EdgeId old = std::exchange(edge.id, ids.take<EdgeId>());
            for (std::size_t n = 0; n < copy.notches.size(); ++n)
                if (original->notches[n].edge == old) copy.notches[n].edge = edge.id;
            for (std::size_t f = 0; f < copy.folds.size(); ++f)
                for (std::size_t end = 0; end < 2; ++end)
                    if (original->folds[f].ends[end].edge == old) copy.folds[f].ends[end].edge = edge.id;
        }
    };
    renew(copy.outline);
    std::ranges::for_each(copy.holes, renew);
    for (Region& region : copy.regions) region.id = ids.take<RegionId>();
    for (Fold& fold : copy.folds) fold.id = ids.take<FoldId>();
    return addPiece(pattern, std::move(copy));
}

Result<Edited> deletePiece(const Pattern& pattern, const PieceId& piece) {
    const Piece* found = findPiece(pattern, piece);
    if (!found) return fail(ErrorCode::notFound, fmt::format("There is no piece \"{}\".", piece.value));
    const std::string why = fmt::format("it is gone with the piece \"{}\".", found->name);
    const auto gone = withImages(pattern, piece);
    const auto isGone = [&](const PieceId& id) { return std::ranges::find(gone, id) != gone.end(); };
    const auto touches = [&](const Seam& seam) {
        return std::ranges::any_of(seam.sides, [&](const auto& side) {
            return std::ranges::any_of(side, [&](const SeamPart& part) { return isGone(part.piece); });
        });
    };
    const auto isHeld = [&](const Tack& tack) {
        return std::ranges::any_of(tack.ends, [&](const ClothPoint& end) { return isGone(end.piece); });
    };
    Edited edited{pattern, {}};
    for (const auto& other : pattern.pieces)
        if (isGone(other->id) && other->id != piece) edited.warnings.push_back({toString(placeOf(*other)), why});
    for (const Seam& seam : pattern.seams)
        if (touches(seam)) edited.warnings.push_back({toString(placeOf(seam)), why});
    for (const Tack& tack : pattern.tacks)
        if (isHeld(tack)) edited.warnings.push_back({toString(placeOf(tack)), why});
    for (const Pin& pin : pattern.pins)
        if (isGone(pin.piece))
            edited.warnings.push_back(
                {fmt::format("{}, pin \"{}\"", toString(placeOf(*findPiece(pattern, pin.piece))), pin.vertex.value),
                 why});
    std::erase_if(edited.pattern.pieces, [&](const auto& other) { return isGone(other->id); });
    std::erase_if(edited.pattern.seams, touches);
    std::erase_if(edited.pattern.pins, [&](const Pin& pin) { return isGone(pin.piece); });
    std::erase_if(edited.pattern.tacks, isHeld);
    return edited;
}

Result<Pattern> renamePiece(const Pattern& pattern, const PieceId& piece, std::string name) {
    return changed(pattern, piece, [&](Piece& p) -> Result<void> {
        if (name.empty()) return fail(ErrorCode::invalidInput, "A piece needs a name.", placeOf(p));
        p.name = std::move(name);
        return {};
    });
}

Result<Pattern> movePiece(const Pattern& pattern, const PieceId& piece, Vec2 tablePosition) {
    return changed(pattern, piece, [&](Piece& p) -> Result<void> {
        if (!geometry::isFinite(tablePosition))
            return fail(ErrorCode::invalidInput, "A position must have finite coordinates.", placeOf(p));
        p.tablePosition = tablePosition;
        return {};
    });
}

Result<Pattern> setGrain(const Pattern& pattern, const PieceId& piece, double grain) {
    return changedShape(pattern, piece, [&](Piece& p) -> Result<void> {
        if (!std::isfinite(grain)) return fail(ErrorCode::invalidInput, "The grain needs a finite angle.", placeOf(p));
        p.grain = grain;
        return {};
    });
}

Result<Pattern> setSpacing(const Pattern& pattern, const PieceId& piece, double spacing) {
    return changed(pattern, piece, [&](Piece& p) -> Result<void> {
        if (!(spacing > 0 && std::isfinite(spacing)))
            return fail(ErrorCode::invalidInput, "The spacing must be a positive length.", placeOf(p));
        p.spacing = spacing;
        return {};
    });
}

Result<Pattern> setSeamAllowance(const Pattern& pattern, const PieceId& piece, double allowance) {
    return changed(pattern, piece, [&](Piece& p) -> Result<void> {
        if (!(allowance >= 0 && std::isfinite(allowance)))
            return fail(ErrorCode::invalidInput, "A seam allowance cannot be negative.", placeOf(p));
        p.seamAllowance = allowance;
        return {};
    });
}

Result<Pattern> setLayer(const Pattern& pattern, const PieceId& piece, int layer) {
    return changed(pattern, piece, [&](Piece& p) -> Result<void> {
        if (layer < 0 || layer > outermostLayer)
            return fail(ErrorCode::invalidInput, fmt::format("A layer is a number from 0 to {}.", outermostLayer),
                        placeOf(p));
        p.layer = layer;
        return {};
    });
}

Result<Pattern> setPressure(const Pattern& pattern, const PieceId& piece, double pressure) {
    return changed(pattern, piece, [&](Piece& p) -> Result<void> {
        if (!(std::abs(pressure) <= mostPressure))
            return fail(ErrorCode::invalidInput,
                        fmt::format("A pressure is a number from {} to {} Pa.", -mostPressure, mostPressure),
                        placeOf(p));
        p.pressure = pressure;
        return {};
    });
}

Result<Pattern> setFrozen(const Pattern& pattern, const PieceId& piece, bool frozen) {
    return changed(pattern, piece, [&](Piece& p) -> Result<void> {
        p.frozen = frozen;
        return {};
    });
}

Result<Pattern> setStrengthened(const Pattern& pattern, const PieceId& piece, bool strengthened) {
    return changed(pattern, piece, [&](Piece& p) -> Result<void> {
        p.strengthened = strengthened;
        return {};
    });
}

Result<Pattern> setLineRule(const Pattern& pattern, const PieceId& piece, LineRule rule) {
    return changed(pattern, piece, [&](Piece& p) -> Result<void> {
        p.rule = rule;
        return {};
    });
}

Result<Pattern> setRegionBorder(const Pattern& pattern, const PieceId& piece, RegionBorder border) {
    return changed(pattern, piece, [&](Piece& p) -> Result<void> {
        p.border = border;
        return {};
    });
}

Pattern laidOut(const Pattern& pattern) {
    Pattern next = pattern;
    Vec2 at;
    double rowHeight = 0;
    for (auto& shared : next.pieces) {
        Piece piece = *shared;
        const geometry::Box2 box = tableBox(pattern, piece);
        const Vec2 size = box.high - box.low;
        if (at.x > 0 && at.x + size.x > tableWidth) { // rows go downwards: y is up
            at = {0, at.y - rowHeight - tableGap};
            rowHeight = 0;
        }
        const Vec2 topLeft{box.low.x, box.high.y};
        piece.tablePosition += at - topLeft;
        at.x += size.x + tableGap;
        rowHeight = std::max(rowHeight, size.y);
        shared = std::move(piece);
    }
    return next;
}

bool piecesCoverEachOther(const Pattern& pattern) {
    std::vector<geometry::Box2> boxes;
    for (const auto& piece : pattern.pieces) boxes.push_back(tableBox(pattern, *piece));
    for (std::size_t i = 0; i < boxes.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            if (overlap(boxes[i], boxes[j])) return true;
    return false;
}

Result<Pattern> addPin(const Pattern& pattern, const PieceId& piece, const VertexId& vertex, IdSource& ids) {
    const Piece* holder = findPiece(pattern, piece);
    const Piece* shape = holder ? shapeOf(pattern, *holder) : nullptr;
    if (!shape) return fail(ErrorCode::notFound, fmt::format("There is no piece \"{}\".", piece.value));
    if (!findVertex(*shape, vertex))
        return fail(ErrorCode::notFound, fmt::format("There is no point \"{}\".", vertex.value), placeOf(*holder));
    if (std::ranges::any_of(pattern.pins, [&](const Pin& pin) { return pin.piece == piece && pin.vertex == vertex; }))
        return fail(ErrorCode::invalidInput, "This point is pinned already.", placeOf(*holder));
    Pattern next = pattern;
    next.pins.push_back({ids.take<PinId>(), piece, vertex});
    return next;
}

Result<Pattern> removePin(const Pattern& pattern, const PinId& pin) {
    Pattern next = pattern;
    if (std::erase_if(next.pins, [&](const Pin& p) { return p.id == pin; }) == 0)
        return fail(ErrorCode::notFound, fmt::format("There is no pin \"{}\".", pin.value));
    return next;
}

Result<Pattern> setPinToBody(const Pattern& pattern, const PinId& pin, bool toBody) {
    Pattern next = pattern;
    const auto found = std::ranges::find(next.pins, pin, &Pin::id);
    if (found == next.pins.end()) return fail(ErrorCode::notFound, fmt::format("There is no pin \"{}\".", pin.value));
    found->toBody = toBody;
    return next;
}

} // namespace toile::pattern
