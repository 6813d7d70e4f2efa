// SPDX-License-Identifier: GPL-3.0-or-later
#include "samples/Sewing.h"

#include "samples/Placing.h"
#include "samples/Strokes.h"

#include <algorithm>

namespace toile::samples {

using namespace pattern;

Piece pieceNamed(const std::string& id, const std::string& name, const Fabric& fabric, double spacing) {
    Piece piece;
    piece.id = PieceId{id};
    piece.name = name;
    piece.fabric = fabric.id;
    piece.spacing = spacing;
    return piece;
}

Piece mirrorPiece(const std::string& id, const std::string& name, const Piece& source) {
    Piece image;
    image.id = PieceId{id};
    image.name = name;
    image.fabric = source.fabric;
    image.spacing = source.spacing;
    image.seamAllowance = source.seamAllowance;
    image.mirror = MirrorOf{source.id, {0, 0}, {0, 1}};
    if (source.placement) image.placement = mirrored(*source.placement);
    return image;
}

namespace {

const std::string& sourceName(const Piece& piece) {
    return piece.mirror ? piece.mirror->source.value : piece.id.value;
}

std::vector<SeamPart> partsOf(const std::vector<Side>& sides) {
    std::vector<SeamPart> parts;
    for (const Side& side : sides) parts.push_back({side.piece, side.edge, 0, 1, side.reversed});
    return parts;
}

} // namespace

Side along(const Piece& piece, const std::string& edge) {
    return {piece.id, edgeId(sourceName(piece), edge), false};
}
Side against(const Piece& piece, const std::string& edge) {
    return {piece.id, edgeId(sourceName(piece), edge), true};
}

Seam seam(const std::string& name, const std::vector<Side>& a, const std::vector<Side>& b,
          std::vector<SeamSection> sections) {
    std::string id = "seam-" + name;
    std::ranges::replace(id, ' ', '-');
    Seam seam;
    seam.id = SeamId{id};
    seam.name = name;
    seam.sides = {partsOf(a), partsOf(b)};
    seam.sections = std::move(sections);
    return seam;
}

} // namespace toile::samples
