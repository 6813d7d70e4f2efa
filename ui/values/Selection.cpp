// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/values/Selection.h"

#include "core/pattern/PatternFolds.h"
#include "core/pattern/PatternTacks.h"

#include <algorithm>

namespace toile::ui {
namespace {

using namespace pattern;

/// The piece that owns the contour: a mirror piece shows its source's.
const Piece* ownerOfContour(const Pattern& pattern, const PieceId& id) {
    const Piece* piece = findPiece(pattern, id);
    return piece && piece->mirror ? findPiece(pattern, piece->mirror->source) : piece;
}

template <class Part>
bool anyContour(const Piece& piece, Part&& has) {
    return has(piece.outline) || std::ranges::any_of(piece.holes, has);
}

struct Exists {
    const Pattern& pattern;

    bool operator()(const PieceId& id) const { return findPiece(pattern, id); }
    bool operator()(const SeamId& id) const { return findSeam(pattern, id); }
    bool operator()(const TackId& id) const { return findTack(pattern, id); }
    bool operator()(const FabricId& id) const { return findFabric(pattern, id); }
    bool operator()(const VertexRef& ref) const {
        const Piece* piece = ownerOfContour(pattern, ref.piece);
        return piece && anyContour(*piece, [&](const Contour& contour) {
                   return std::ranges::find(contour.vertices, ref.vertex, &Vertex::id) != contour.vertices.end();
               });
    }
    bool operator()(const EdgeRef& ref) const {
        const Piece* piece = ownerOfContour(pattern, ref.piece);
        return piece && anyContour(*piece, [&](const Contour& contour) {
                   return std::ranges::find(contour.edges, ref.edge, &Edge::id) != contour.edges.end();
               });
    }
    bool operator()(const RegionRef& ref) const {
        const Piece* piece = ownerOfContour(pattern, ref.piece);
        return piece && std::ranges::find(piece->regions, ref.region, &Region::id) != piece->regions.end();
    }
    bool operator()(const FoldRef& ref) const {
        const Piece* piece = ownerOfContour(pattern, ref.piece);
        return piece && findFold(*piece, ref.fold);
    }
    bool operator()(AvatarItem) const { return true; }
    bool operator()(SceneItem) const { return true; }
};

struct OwnerPiece {
    PieceId operator()(const PieceId& id) const { return id; }
    PieceId operator()(const VertexRef& ref) const { return ref.piece; }
    PieceId operator()(const EdgeRef& ref) const { return ref.piece; }
    PieceId operator()(const RegionRef& ref) const { return ref.piece; }
    PieceId operator()(const FoldRef& ref) const { return ref.piece; }
    template <class Other>
    PieceId operator()(const Other&) const {
        return {};
    }
};

} // namespace

bool contains(const Selection& selection, const Item& item) {
    return std::ranges::find(selection, item) != selection.end();
}

Selection toggled(Selection selection, const Item& item) {
    const auto found = std::ranges::find(selection, item);
    if (found == selection.end()) selection.push_back(item);
    else selection.erase(found);
    return selection;
}

Selection existing(const Selection& selection, const Pattern& pattern) {
    Selection kept;
    std::ranges::copy_if(selection, std::back_inserter(kept),
                         [&](const Item& item) { return std::visit(Exists{pattern}, item); });
    return kept;
}

PieceId pieceOf(const Item& item) {
    return std::visit(OwnerPiece{}, item);
}

} // namespace toile::ui
