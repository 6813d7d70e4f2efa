// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/MeshInputOf.h"

#include "core/pattern/PatternFolds.h"

#include <algorithm>
#include <fmt/format.h>
#include <map>

namespace toile::simulation {
namespace {

using namespace pattern;

struct EdgePlace {
    int loop = 0, edge = 0;
};

/// Pieces of the pattern with their edges found by id.
struct PieceIndex {
    int piece = 0;
    bool isMirror = false;
    std::map<EdgeId, EdgePlace> edges;
};

/// The user's name, or the id of what has none; the mesher puts "piece", "edge", … before it.
const std::string& labelOf(const std::string& name, const std::string& id) {
    return name.empty() ? id : name;
}

meshing::BoundaryLoop loopOf(const Piece& piece, const Contour& contour) {
    meshing::BoundaryLoop loop;
    for (std::size_t i = 0; i < contour.edges.size(); ++i) {
        meshing::BoundaryEdge edge{curveOf(contour, i), {}, contour.edges[i].id.value};
        for (const Notch& notch : piece.notches)
            if (notch.edge == contour.edges[i].id && notch.position >= 0 && notch.position <= 1)
                edge.notches.push_back(notch.position);
        std::ranges::sort(edge.notches);
        const auto [first, last] = std::ranges::unique(edge.notches);
        edge.notches.erase(first, last);
        loop.push_back(std::move(edge));
    }
    return loop;
}

/// Of an end that is unknown the mesher is told no place, which it refuses.
std::vector<meshing::FoldInput> foldInputsOf(const Piece& piece) {
    std::vector<meshing::FoldInput> inputs;
    for (const Fold& fold : piece.folds) {
        meshing::FoldInput input{labelOf(fold.name, fold.id.value), pointsOf(piece, fold), {}};
        for (std::size_t end = 0; end < 2; ++end)
            if (const auto at = findEdge(piece, fold.ends[end].edge))
                input.ends[end] = {at->loop, static_cast<int>(at->index), fold.ends[end].position};
        inputs.push_back(std::move(input));
    }
    return inputs;
}

meshing::PieceInput pieceInputOf(const Piece& piece, const MeshOverrides& overrides) {
    meshing::PieceInput input;
    input.label = labelOf(piece.name, piece.id.value);
    input.outline = loopOf(piece, piece.outline);
    for (const Contour& hole : piece.holes) input.holes.push_back(loopOf(piece, hole));
    input.grain = piece.grain;
    input.spacing = overrides.spacing.value_or(piece.spacing);
    for (const Region& region : piece.regions)
        input.regions.push_back(
            {labelOf(region.name, region.id.value), region.outline, region.holes, region.refinement});
    input.folds = foldInputsOf(piece);
    switch (overrides.rule.value_or(piece.rule)) {
    case LineRule::regular: input.rule = meshing::LineRule::regular; break;
    case LineRule::features: input.rule = meshing::LineRule::features; break;
    case LineRule::paper: input.rule = meshing::LineRule::paper; break;
    }
    input.border = overrides.border.value_or(piece.border) == RegionBorder::exact ? meshing::RegionBorder::exact
                                                                                  : meshing::RegionBorder::snap;
    input.mirrored = piece.mirror.has_value();
    return input;
}

PieceIndex indexOf(const Piece& piece, int number) {
    PieceIndex index{number, piece.mirror.has_value(), {}};
    const auto enter = [&](const Contour& contour, int loop) {
        for (std::size_t i = 0; i < contour.edges.size(); ++i)
            index.edges[contour.edges[i].id] = {loop, static_cast<int>(i)};
    };
    enter(piece.outline, 0);
    for (std::size_t hole = 0; hole < piece.holes.size(); ++hole) enter(piece.holes[hole], static_cast<int>(hole) + 1);
    return index;
}

Result<meshing::SeamPartInput> partInputOf(const SeamPart& part, const Seam& seam,
                                           const std::map<PieceId, PieceIndex>& pieces) {
    const Place place{.object = fmt::format("seam \"{}\"", labelOf(seam.name, seam.id.value))};
    const auto piece = pieces.find(part.piece);
    if (piece == pieces.end())
        return fail(ErrorCode::invalidInput, fmt::format("There is no piece \"{}\".", part.piece.value), place);
    const auto edge = piece->second.edges.find(part.edge);
    if (edge == piece->second.edges.end())
        return fail(ErrorCode::invalidInput,
                    fmt::format("Piece \"{}\" has no edge \"{}\".", part.piece.value, part.edge.value), place);
    meshing::SeamPartInput input{piece->second.piece, edge->second.loop, edge->second.edge,
                                 part.from,           part.to,           part.reversed};
    if (piece->second.isMirror) { // the reflected edge runs against its source
        input.from = 1 - part.to;
        input.to = 1 - part.from;
        input.reversed = !part.reversed;
    }
    return input;
}

} // namespace

Result<meshing::MeshInput> meshInputOf(const Pattern& pattern, const MeshOverrides& overrides) {
    meshing::MeshInput input;
    std::map<PieceId, PieceIndex> pieces;
    for (const Shared<Piece>& authored : pattern.pieces) {
        const Piece piece = resolved(pattern, *authored);
        pieces[piece.id] = indexOf(piece, static_cast<int>(input.pieces.size()));
        input.pieces.push_back(pieceInputOf(piece, overrides));
    }
    for (const Seam& seam : pattern.seams) {
        meshing::SeamInput seamInput{labelOf(seam.name, seam.id.value), {}, {}};
        for (std::size_t side = 0; side < 2; ++side)
            for (const SeamPart& part : seam.sides[side]) {
                auto partInput = partInputOf(part, seam, pieces);
                if (!partInput) return tl::unexpected(partInput.error());
                seamInput.sides[side].push_back(*partInput);
            }
        for (const SeamSection& section : seam.sections)
            seamInput.sections.push_back({section.ease, section.gatherRatio});
        input.seams.push_back(std::move(seamInput));
    }
    return input;
}

} // namespace toile::simulation
