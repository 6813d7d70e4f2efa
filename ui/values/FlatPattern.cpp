// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/values/FlatPattern.h"

#include "core/pattern/CutLine.h"
#include "core/pattern/PatternMeasures.h"

#include <algorithm>

namespace toile::ui {
namespace {

using namespace pattern;

constexpr double chordError = 0.05e-3; // [m] a fifth of a pixel at 4 pixels per mm

FlatContour flattened(const Contour& contour) {
    FlatContour flat;
    for (std::size_t edge = 0; edge < contour.edges.size(); ++edge) {
        flat.edges.push_back(geometry::flattened(curveOf(contour, edge), chordError));
        const auto& points = flat.edges.back();
        flat.polygon.insert(flat.polygon.end(), points.begin(), points.end() - 1);
    }
    return flat;
}

/// The part of a polyline between two fractions of its length.
std::vector<Vec2> cut(const std::vector<Vec2>& path, double from, double to) {
    if (from <= 0 && to >= 1) return path;
    const double total = lengthOf(path);
    std::vector<Vec2> part{pointAlong(path, from).position};
    double walked = 0;
    for (std::size_t i = 1; i + 1 < path.size(); ++i) {
        walked += distance(path[i - 1], path[i]);
        if (walked > from * total && walked < to * total) part.push_back(path[i]);
    }
    part.push_back(pointAlong(path, to).position);
    return part;
}

void move(Contour& contour, Vec2 by) {
    for (Vertex& vertex : contour.vertices) vertex.position += by;
    for (Edge& edge : contour.edges)
        if (auto* cubic = std::get_if<geometry::CubicShape>(&edge.shape)) {
            cubic->control1 += by;
            cubic->control2 += by;
        }
}

void move(Polygon& polygon, Vec2 by) {
    for (Vec2& point : polygon) point += by;
}

} // namespace

Piece moved(Piece piece, Vec2 by) {
    move(piece.outline, by);
    for (Contour& hole : piece.holes) move(hole, by);
    for (Region& region : piece.regions) {
        move(region.outline, by);
        for (Polygon& hole : region.holes) move(hole, by);
    }
    for (Fold& fold : piece.folds) move(fold.between, by);
    for (InternalLine& line : piece.internalLines) move(line.points, by);
    return piece;
}

const Contour& FlatPiece::contour(std::size_t loop) const {
    return loop == 0 ? piece.outline : piece.holes[loop - 1];
}

const FlatContour& FlatPiece::flat(std::size_t loop) const {
    return loop == 0 ? outline : holes[loop - 1];
}

FlatPattern flattened(const Pattern& pattern) {
    FlatPattern flat;
    for (const Shared<Piece>& piece : pattern.pieces) {
        FlatPiece item{moved(resolved(pattern, *piece), piece->tablePosition), {}, {}, {}};
        item.outline = flattened(item.piece.outline);
        for (const Contour& hole : item.piece.holes) item.holes.push_back(flattened(hole));
        item.cut = cutShape(item.piece);
        flat.pieces.push_back(std::move(item));
    }
    return flat;
}

const FlatPiece* findPiece(const FlatPattern& pattern, const PieceId& id) {
    const auto found = std::ranges::find_if(pattern.pieces, [&](const FlatPiece& p) { return p.piece.id == id; });
    return found == pattern.pieces.end() ? nullptr : &*found;
}

geometry::Box2 boundsOf(const FlatPiece& piece) {
    return geometry::boundsOf(piece.outline.polygon);
}

geometry::Box2 boundsOf(const FlatPattern& pattern) {
    std::vector<Vec2> corners;
    for (const FlatPiece& piece : pattern.pieces) {
        if (piece.outline.polygon.empty()) continue;
        const geometry::Box2 box = boundsOf(piece);
        corners.insert(corners.end(), {box.low, box.high});
    }
    return geometry::boundsOf(corners);
}

bool covers(const FlatPiece& piece, Vec2 point) {
    if (geometry::windingNumber(piece.outline.polygon, point) == 0) return false;
    return std::ranges::none_of(
        piece.holes, [&](const FlatContour& hole) { return geometry::windingNumber(hole.polygon, point) != 0; });
}

std::optional<EdgePlace> placeOf(const Piece& piece, const EdgeId& edge) {
    const auto found = findEdge(piece, edge);
    if (!found) return std::nullopt;
    return EdgePlace{static_cast<std::size_t>(found->loop), found->index};
}

std::optional<VertexPlace> placeOf(const Piece& piece, const VertexId& vertex) {
    const auto found = findVertex(piece, vertex);
    if (!found) return std::nullopt;
    return VertexPlace{static_cast<std::size_t>(found->loop), found->index};
}

std::vector<Vec2> pathOf(const FlatPattern& pattern, const SeamPart& part) {
    const FlatPiece* piece = findPiece(pattern, part.piece);
    const auto place = piece ? placeOf(piece->piece, part.edge) : std::nullopt;
    if (!place) return {};
    std::vector<Vec2> path = piece->flat(place->loop).edges[place->edge];
    if (piece->piece.mirror) std::ranges::reverse(path); // fractions count along the source's edge
    path = cut(path, part.from, part.to);
    if (part.reversed) std::ranges::reverse(path);
    return path;
}

std::vector<std::vector<Vec2>> pathsOf(const FlatPattern& pattern, const std::vector<SeamPart>& side) {
    std::vector<std::vector<Vec2>> paths;
    for (const SeamPart& part : side) {
        std::vector<Vec2> path = pathOf(pattern, part);
        if (path.size() >= 2) paths.push_back(std::move(path));
    }
    return paths;
}

double lengthOf(const std::vector<Vec2>& path) {
    double sum = 0;
    for (std::size_t i = 1; i < path.size(); ++i) sum += distance(path[i - 1], path[i]);
    return sum;
}

double lengthOf(const std::vector<std::vector<Vec2>>& paths) {
    double sum = 0;
    for (const std::vector<Vec2>& path : paths) sum += lengthOf(path);
    return sum;
}

PathPoint pointAlong(const std::vector<Vec2>& path, double fraction) {
    double rest = std::clamp(fraction, 0.0, 1.0) * lengthOf(path);
    for (std::size_t i = 1; i < path.size(); ++i) {
        const double step = distance(path[i - 1], path[i]);
        if (rest <= step && step > 0) return {lerp(path[i - 1], path[i], rest / step), path[i] - path[i - 1]};
        rest -= step;
    }
    return {path.back(), path.size() > 1 ? path.back() - path[path.size() - 2] : Vec2{1, 0}};
}

PathPoint pointAlong(const std::vector<std::vector<Vec2>>& paths, double fraction) {
    double rest = fraction * lengthOf(paths);
    for (const auto& path : paths) {
        const double part = lengthOf(path);
        if (rest <= part && part > 0) return pointAlong(path, rest / part);
        rest -= part;
    }
    return pointAlong(paths.back(), 1);
}

} // namespace toile::ui
