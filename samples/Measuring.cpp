// SPDX-License-Identifier: GPL-3.0-or-later
#include "samples/Measuring.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace toile::samples {
namespace {

using namespace pattern;

constexpr double chordError = 1e-7; // [m]; a width is then right to about a micrometre

void addCrossings(const Contour& contour, double y, std::vector<double>& crossings) {
    for (std::size_t e = 0; e < contour.edges.size(); ++e) {
        const std::vector<Vec2> points = geometry::flattened(curveOf(contour, e), chordError);
        for (std::size_t i = 0; i + 1 < points.size(); ++i) {
            const Vec2 a = points[i], b = points[i + 1];
            if ((a.y <= y) != (b.y <= y)) crossings.push_back(a.x + (b.x - a.x) * (y - a.y) / (b.y - a.y));
        }
    }
}

const Contour& contourWith(const Piece& piece, const EdgeId& edge, std::size_t& index) {
    const auto has = [&](const Contour& contour) {
        const auto found = std::ranges::find(contour.edges, edge, &Edge::id);
        index = static_cast<std::size_t>(found - contour.edges.begin());
        return found != contour.edges.end();
    };
    if (has(piece.outline)) return piece.outline;
    const auto hole = std::ranges::find_if(piece.holes, has);
    expects(hole != piece.holes.end(), "the piece has this edge");
    return *hole;
}

} // namespace

double widthAt(const Piece& piece, double y) {
    std::vector<double> crossings;
    addCrossings(piece.outline, y, crossings);
    for (const Contour& hole : piece.holes) addCrossings(hole, y, crossings);
    std::ranges::sort(crossings);
    double width = 0;
    for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) width += crossings[i + 1] - crossings[i];
    return width;
}

double edgeLength(const Piece& piece, const EdgeId& edge) {
    std::size_t index = 0;
    const Contour& contour = contourWith(piece, edge, index);
    return geometry::length(curveOf(contour, index));
}

double cornerAngle(const Piece& piece, const VertexId& vertex) {
    const auto& vertices = piece.outline.vertices;
    const auto found = std::ranges::find(vertices, vertex, &Vertex::id);
    expects(found != vertices.end(), "the piece has this vertex");
    const std::size_t leaving = static_cast<std::size_t>(found - vertices.begin());
    const std::size_t arriving = (leaving + vertices.size() - 1) % vertices.size();
    const Vec2 in = geometry::tangentAt(curveOf(piece.outline, arriving), 1);
    const Vec2 out = geometry::tangentAt(curveOf(piece.outline, leaving), 0);
    return std::numbers::pi - std::atan2(cross(in, out), dot(in, out));
}

double sideLength(const Pattern& pattern, const Seam& seam, int side) {
    double sum = 0;
    for (const SeamPart& part : seam.sides[static_cast<std::size_t>(side)]) {
        const Piece* piece = findPiece(pattern, part.piece);
        expects(piece, "the seam's piece exists");
        sum += (part.to - part.from) * edgeLength(resolved(pattern, *piece), part.edge);
    }
    return sum;
}

Vec2 vertexPosition(const Piece& piece, const VertexId& vertex) {
    const auto found = std::ranges::find(piece.outline.vertices, vertex, &Vertex::id);
    expects(found != piece.outline.vertices.end(), "the piece has this vertex");
    return found->position;
}

double Solver::rootOf(const std::string& measure, const std::function<double(double)>& function, double low,
                      double high) {
    const double atLow = function(low), atHigh = function(high);
    const bool rising = atLow < 0;
    if (!std::isfinite(atLow) || !std::isfinite(atHigh) || rising == (atHigh < 0)) {
        if (!error_)
            error_ = Error{ErrorCode::invalidInput,
                           "The draft finds no " + measure +
                               " that fits these measures: they do not go together, or the eases are too large.",
                           {}};
        return std::abs(atLow) < std::abs(atHigh) ? low : high;
    }
    for (int i = 0; i < 60; ++i) {
        const double middle = (low + high) / 2;
        ((function(middle) < 0) == rising ? low : high) = middle;
    }
    return (low + high) / 2;
}

} // namespace toile::samples
