// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pattern/CheckParts.h"
#include "core/pattern/PatternMeasures.h"

#include <cmath>
#include <fmt/format.h>
#include <tuple>

namespace toile::pattern {
namespace {

/// A place on a contour. The end of an edge is the beginning of the next.
struct ContourPlace {
    PieceId piece;
    LoopIndex edge;
    double fraction = 0;

    friend bool operator==(const ContourPlace& a, const ContourPlace& b) {
        constexpr double rounding = 1e-9;
        return a.piece == b.piece && a.edge == b.edge && std::abs(a.fraction - b.fraction) < rounding;
    }
};

ContourPlace placeAt(const Pattern& pattern, const SeamPart& part, double fraction) {
    const Piece& shape = *shapeOf(pattern, *findPiece(pattern, part.piece));
    const LoopIndex edge = *findEdge(shape, part.edge);
    const ContourPlace place{part.piece, edge, fraction};
    const std::size_t edges = loopOf(shape, edge.loop).edges.size();
    const ContourPlace next{part.piece, {edge.loop, (edge.index + 1) % edges}, 0};
    return place == ContourPlace{part.piece, edge, 1} ? next : place;
}

} // namespace

void checkChain(const Pattern& pattern, const std::vector<SeamPart>& side, const std::string& at, Problems& problems) {
    const auto startOf = [&](const SeamPart& p) { return placeAt(pattern, p, p.reversed ? p.to : p.from); };
    const auto endOf = [&](const SeamPart& p) { return placeAt(pattern, p, p.reversed ? p.from : p.to); };
    for (std::size_t i = 0; i + 1 < side.size(); ++i) {
        const SeamPart &here = side[i], &there = side[i + 1];
        if (endOf(here) == startOf(there)) continue;
        const bool thereTurned = endOf(here) == endOf(there), hereTurned = startOf(here) == startOf(there);
        if (!thereTurned && !hereTurned && startOf(here) != endOf(there)) continue; // it goes on elsewhere
        const auto& [turned, other] = thereTurned ? std::tie(there, here) : std::tie(here, there);
        return problems.error(
            fmt::format("{}[{}].reversed", at, thereTurned ? i + 1 : i),
            fmt::format("The edge \"{}\" is walked in the wrong direction: it does not lead on to the edge \"{}\".",
                        turned.edge.value, other.edge.value));
    }
}

} // namespace toile::pattern
