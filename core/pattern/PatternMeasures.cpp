// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pattern/PatternMeasures.h"

#include "core/base/Contracts.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace toile::pattern {
namespace {

constexpr double sameNotch = 1e-6; ///< notches nearer than this along the seam are one [m]

template <class Items, class IdType>
std::optional<std::size_t> indexOf(const Items& items, const IdType& id) {
    const auto found = std::ranges::find_if(items, [&](const auto& item) { return item.id == id; });
    if (found == items.end()) return std::nullopt;
    return static_cast<std::size_t>(found - items.begin());
}

const Piece* shapeOf(const Pattern& pattern, const PieceId& id) {
    const Piece* piece = findPiece(pattern, id);
    return piece ? pattern::shapeOf(pattern, *piece) : nullptr;
}

/// One side of a seam: its length and where its notches lie, from its start [m].
struct Side {
    double length = 0;
    std::vector<double> notches;
};

std::optional<Side> measured(const Pattern& pattern, const std::vector<SeamPart>& parts) {
    Side side;
    for (const SeamPart& part : parts) {
        const auto length = partLength(pattern, part);
        if (!length) return std::nullopt;
        const double whole = part.to > part.from ? *length / (part.to - part.from) : 0;
        for (const Notch& notch : shapeOf(pattern, part.piece)->notches)
            if (notch.edge == part.edge && notch.position >= part.from && notch.position <= part.to)
                side.notches.push_back(side.length +
                                       whole * (part.reversed ? part.to - notch.position : notch.position - part.from));
        side.length += *length;
    }
    std::erase_if(side.notches, [&](double at) { return at < sameNotch || at > side.length - sameNotch; });
    std::ranges::sort(side.notches);
    const auto [first, last] = std::ranges::unique(side.notches, [](double x, double y) { return y - x < sameNotch; });
    side.notches.erase(first, last);
    return side;
}

/// Where the sections end, the end of the side last.
std::vector<double> ends(const Side& side, bool byNotches) {
    std::vector<double> at;
    if (byNotches) at = side.notches;
    at.push_back(side.length);
    return at;
}

double wantedEase(const SeamSection& section, double lengthB) {
    return section.gatherRatio ? (*section.gatherRatio - 1) * lengthB : section.ease;
}

} // namespace

std::optional<LoopIndex> findEdge(const Piece& piece, const EdgeId& edge) {
    for (int loop = 0; loop <= static_cast<int>(piece.holes.size()); ++loop)
        if (const auto index = indexOf(loopOf(piece, loop).edges, edge)) return LoopIndex{loop, *index};
    return std::nullopt;
}

std::optional<LoopIndex> findVertex(const Piece& piece, const VertexId& vertex) {
    for (int loop = 0; loop <= static_cast<int>(piece.holes.size()); ++loop)
        if (const auto index = indexOf(loopOf(piece, loop).vertices, vertex)) return LoopIndex{loop, *index};
    return std::nullopt;
}

const Contour& loopOf(const Piece& piece, int loop) {
    return loop == 0 ? piece.outline : piece.holes[static_cast<std::size_t>(loop - 1)];
}

Contour& loopOf(Piece& piece, int loop) {
    return loop == 0 ? piece.outline : piece.holes[static_cast<std::size_t>(loop - 1)];
}

geometry::Curve curveOf(const Piece& piece, const LoopIndex& edge) {
    return curveOf(loopOf(piece, edge.loop), edge.index);
}

double edgeLength(const Piece& piece, const EdgeId& edge) {
    const auto at = findEdge(piece, edge);
    expects(at.has_value(), "the piece has this edge");
    return geometry::length(curveOf(piece, *at));
}

double cornerAngle(const Piece& piece, const VertexId& vertex) {
    const auto at = findVertex(piece, vertex);
    expects(at.has_value(), "the piece has this vertex");
    const Contour& contour = loopOf(piece, at->loop);
    const std::size_t n = contour.vertices.size();
    const Vec2 in = geometry::tangentAt(curveOf(contour, (at->index + n - 1) % n), 1);
    const Vec2 out = geometry::tangentAt(curveOf(contour, at->index), 0);
    return std::numbers::pi - std::atan2(cross(in, out), dot(in, out)); // the cloth lies to the left
}

Polygon flattened(const Contour& contour, double chordError) {
    Polygon polygon;
    for (std::size_t edge = 0; edge < contour.edges.size(); ++edge) {
        const auto points = geometry::flattened(curveOf(contour, edge), chordError);
        polygon.insert(polygon.end(), points.begin(), points.end() - 1);
    }
    return polygon;
}

double areaOf(const Piece& piece) {
    constexpr double chordError = 1e-5; // [m]
    double area = geometry::signedArea(flattened(piece.outline, chordError));
    for (const Contour& hole : piece.holes) area -= std::abs(geometry::signedArea(flattened(hole, chordError)));
    return area;
}

const Piece* shapeOf(const Pattern& pattern, const Piece& piece) {
    if (!piece.mirror) return &piece;
    const Piece* source = findPiece(pattern, piece.mirror->source);
    return source && !source->mirror ? source : nullptr;
}

std::optional<double> partLength(const Pattern& pattern, const SeamPart& part) {
    const Piece* shape = shapeOf(pattern, part.piece);
    const auto at = shape ? findEdge(*shape, part.edge) : std::nullopt;
    if (!at) return std::nullopt;
    return (part.to - part.from) * geometry::length(curveOf(*shape, *at));
}

std::vector<Vec2> partPoints(const Pattern& pattern, const SeamPart& part, double chordError) {
    const Piece* piece = findPiece(pattern, part.piece);
    const Piece* shape = piece ? shapeOf(pattern, *piece) : nullptr;
    const auto at = shape ? findEdge(*shape, part.edge) : std::nullopt;
    if (!at || !(part.from >= 0 && part.from < part.to && part.to <= 1)) return {};
    geometry::Curve curve = curveOf(*shape, *at);
    const geometry::ArcLength arc(curve);
    const double from = arc.parameterAt(part.from), to = arc.parameterAt(part.to);
    curve = geometry::splitAt(curve, to).first;
    curve = geometry::splitAt(curve, from / to).second;
    std::vector<Vec2> points = geometry::flattened(curve, chordError);
    if (piece->mirror)
        for (Vec2& p : points) p = geometry::mirrored(p, piece->mirror->lineStart, piece->mirror->lineEnd);
    if (part.reversed) std::ranges::reverse(points);
    return points;
}

std::size_t sectionCount(const Pattern& pattern, const Seam& seam) {
    const auto a = measured(pattern, seam.sides[0]), b = measured(pattern, seam.sides[1]);
    return a && b && a->notches.size() == b->notches.size() ? a->notches.size() + 1 : 1;
}

std::optional<std::vector<SectionLengths>> sectionsOf(const Pattern& pattern, const Seam& seam) {
    const auto a = measured(pattern, seam.sides[0]), b = measured(pattern, seam.sides[1]);
    if (!a || !b) return std::nullopt;
    const bool byNotches = a->notches.size() == b->notches.size() && seam.sections.size() != 1;
    const std::vector<double> endsA = ends(*a, byNotches), endsB = ends(*b, byNotches);
    if (!seam.sections.empty() && seam.sections.size() != endsA.size()) return std::nullopt;
    std::vector<SectionLengths> sections;
    for (std::size_t i = 0; i < endsA.size(); ++i) {
        SectionLengths section{endsA[i] - (i ? endsA[i - 1] : 0), endsB[i] - (i ? endsB[i - 1] : 0), 0};
        if (!seam.sections.empty()) section.wantedEase = wantedEase(seam.sections[i], section.b);
        sections.push_back(section);
    }
    return sections;
}

} // namespace toile::pattern
