// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pattern/EdgeFractions.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace toile::pattern {
namespace {

/// The parts, in the order of walking, that a part of the whole edge becomes when the edge is split.
std::vector<SeamPart> split(const SeamPart& part, const EdgeId& after, double f) {
    std::vector<SeamPart> parts;
    if (part.from < f) {
        SeamPart before = part;
        before.from = part.from / f;
        before.to = std::min(1.0, part.to / f);
        parts.push_back(before);
    }
    if (part.to > f) {
        SeamPart behind = part;
        behind.edge = after;
        behind.from = std::max(0.0, (part.from - f) / (1 - f));
        behind.to = (part.to - f) / (1 - f);
        parts.push_back(behind);
    }
    if (part.reversed) std::ranges::reverse(parts);
    return parts;
}

/// Joins neighbours of a chain that now continue each other on one edge.
void mergeNeighbours(std::vector<SeamPart>& parts, const EdgeId& edge) {
    constexpr double same = 1e-12; // rounding of fractions that were the same place
    for (std::size_t i = 1; i < parts.size();) {
        SeamPart& a = parts[i - 1];
        const SeamPart& b = parts[i];
        const bool sameEdge = a.edge == edge && b.edge == edge && a.piece == b.piece && a.reversed == b.reversed;
        const bool continues = a.reversed ? std::abs(b.to - a.from) < same : std::abs(a.to - b.from) < same;
        if (sameEdge && continues) {
            (a.reversed ? a.from : a.to) = a.reversed ? b.from : b.to;
            parts.erase(parts.begin() + static_cast<std::ptrdiff_t>(i));
        } else ++i;
    }
}

/// Calls change(edge, position) for the places that notches and folds of a piece name.
template <class Change>
void changePlaces(Pattern& pattern, const PieceId& id, Change change) {
    for (auto& piece : pattern.pieces) {
        if (piece->id != id) continue;
        Piece next = *piece;
        for (Notch& notch : next.notches) change(notch.edge, notch.position);
        for (Fold& fold : next.folds)
            for (BorderPoint& end : fold.ends) change(end.edge, end.position);
        piece = std::move(next);
    }
}

} // namespace

bool liesOn(const Pattern& pattern, const SeamPart& part, const PieceId& piece, const EdgeId& edge) {
    if (part.edge != edge) return false;
    if (part.piece == piece) return true;
    const Piece* image = findPiece(pattern, part.piece);
    return image && image->mirror && image->mirror->source == piece;
}

void rewriteAfterSplit(Pattern& pattern, const PieceId& piece, const EdgeId& edge, const EdgeId& after,
                       double fraction) {
    for (Seam& seam : pattern.seams)
        for (auto& side : seam.sides) {
            std::vector<SeamPart> parts;
            for (const SeamPart& part : side) {
                const auto pieces =
                    liesOn(pattern, part, piece, edge) ? split(part, after, fraction) : std::vector{part};
                parts.insert(parts.end(), pieces.begin(), pieces.end());
            }
            side = std::move(parts);
        }
    changePlaces(pattern, piece, [&](EdgeId& at, double& position) {
        if (at != edge) return;
        if (position <= fraction) position /= fraction;
        else {
            at = after;
            position = (position - fraction) / (1 - fraction);
        }
    });
}

void rewriteAfterJoin(Pattern& pattern, const PieceId& piece, const EdgeId& edge, const EdgeId& after,
                      double fraction) {
    for (Seam& seam : pattern.seams)
        for (auto& side : seam.sides) {
            for (SeamPart& part : side) {
                const bool isBefore = liesOn(pattern, part, piece, edge), isAfter = liesOn(pattern, part, piece, after);
                if (!isBefore && !isAfter) continue;
                const double start = isAfter ? fraction : 0, share = isAfter ? 1 - fraction : fraction;
                part.edge = edge;
                part.from = part.from == 0 ? start : start + part.from * share;
                part.to = part.to == 1 ? (isAfter ? 1 : fraction) : start + part.to * share;
            }
            std::erase_if(side, [&](const SeamPart& part) { // of an edge between two points on one another
                return part.from >= part.to && liesOn(pattern, part, piece, edge);
            });
            mergeNeighbours(side, edge);
        }
    changePlaces(pattern, piece, [&](EdgeId& at, double& position) {
        if (at == edge) position *= fraction;
        else if (at == after) {
            at = edge;
            position = fraction + position * (1 - fraction);
        }
    });
}

} // namespace toile::pattern
