// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/values/Picking.h"

#include "core/pattern/PatternFolds.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace toile::ui {
namespace {

using namespace pattern;

/// The nearest of what is offered within a tolerance [m]; of two that are equally near the later one.
template <class Thing>
class Nearest {
public:
    explicit Nearest(double tolerance) : distance_(tolerance) {}
    void offer(double distance, const Thing& thing) {
        if (!(distance <= distance_)) return;
        distance_ = distance;
        thing_ = thing;
    }
    [[nodiscard]] const std::optional<Thing>& thing() const { return thing_; }

private:
    double distance_;
    std::optional<Thing> thing_;
};

double distanceToPath(const std::vector<Vec2>& path, Vec2 point) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 1; i < path.size(); ++i)
        least = std::min(least, distance(geometry::closestOnSegment(path[i - 1], path[i], point), point));
    return least;
}

/// Parameter of the point of the curve nearest to a point: samples, then the best bracket is halved by thirds.
double closestParameter(const geometry::Curve& curve, Vec2 point) {
    constexpr int samples = 64;
    const auto off = [&](double t) { return squaredLength(geometry::pointAt(curve, t) - point); };
    int best = 0;
    for (int i = 1; i <= samples; ++i)
        if (off(double(i) / samples) < off(double(best) / samples)) best = i;
    double low = std::max(0.0, double(best - 1) / samples), high = std::min(1.0, double(best + 1) / samples);
    for (int i = 0; i < 60; ++i) {
        const double a = low + (high - low) / 3, b = high - (high - low) / 3;
        if (off(a) < off(b)) high = b;
        else low = a;
    }
    return (low + high) / 2;
}

EdgeHit hitOn(const FlatPiece& piece, EdgePlace place, Vec2 point) {
    const Contour& contour = piece.contour(place.loop);
    const geometry::Curve curve = curveOf(contour, place.edge);
    EdgeHit hit{{piece.piece.id, contour.edges[place.edge].id}, {}, 0, 0, 0};
    hit.parameter = closestParameter(curve, point);
    hit.point = geometry::pointAt(curve, hit.parameter);
    hit.distance = distance(hit.point, point);
    const double fraction = geometry::ArcLength(curve).fractionAt(hit.parameter);
    hit.fraction = piece.piece.mirror ? 1 - fraction : fraction;
    return hit;
}

} // namespace

std::optional<VertexRef> vertexAt(const FlatPattern& pattern, Vec2 point, double tolerance) {
    Nearest<VertexRef> nearest(tolerance);
    for (const FlatPiece& piece : pattern.pieces)
        for (std::size_t loop = 0; loop < piece.loops(); ++loop)
            for (const Vertex& vertex : piece.contour(loop).vertices)
                nearest.offer(distance(vertex.position, point), {piece.piece.id, vertex.id});
    return nearest.thing();
}

std::optional<HandleRef> handleAt(const FlatPattern& pattern, Vec2 point, double tolerance) {
    Nearest<HandleRef> nearest(tolerance);
    for (const FlatPiece& piece : pattern.pieces)
        for (std::size_t loop = 0; loop < piece.loops(); ++loop)
            for (const Edge& edge : piece.contour(loop).edges)
                if (const auto* cubic = std::get_if<geometry::CubicShape>(&edge.shape)) {
                    nearest.offer(distance(cubic->control1, point), {{piece.piece.id, edge.id}, 1});
                    nearest.offer(distance(cubic->control2, point), {{piece.piece.id, edge.id}, 2});
                }
    return nearest.thing();
}

std::optional<EdgeHit> edgeAt(const FlatPattern& pattern, Vec2 point, double tolerance) {
    Nearest<std::pair<const FlatPiece*, EdgePlace>> nearest(tolerance);
    for (const FlatPiece& piece : pattern.pieces)
        for (std::size_t loop = 0; loop < piece.loops(); ++loop)
            for (std::size_t edge = 0; edge < piece.flat(loop).edges.size(); ++edge)
                nearest.offer(distanceToPath(piece.flat(loop).edges[edge], point), {&piece, {loop, edge}});
    if (!nearest.thing()) return std::nullopt;
    const auto& [piece, place] = *nearest.thing();
    return hitOn(*piece, place, point);
}

std::optional<PieceId> pieceAt(const FlatPattern& pattern, Vec2 point) {
    for (auto piece = pattern.pieces.rbegin(); piece != pattern.pieces.rend(); ++piece)
        if (covers(*piece, point)) return piece->piece.id;
    return std::nullopt;
}

std::optional<RegionRef> regionAt(const FlatPattern& pattern, Vec2 point) {
    std::optional<RegionRef> best;
    double smallest = std::numeric_limits<double>::infinity();
    for (const FlatPiece& piece : pattern.pieces)
        for (const Region& region : piece.piece.regions) {
            if (geometry::windingNumber(region.outline, point) == 0) continue;
            if (std::ranges::any_of(region.holes,
                                    [&](const auto& hole) { return geometry::windingNumber(hole, point) != 0; }))
                continue;
            const double area = std::abs(geometry::signedArea(region.outline));
            if (area >= smallest) continue;
            smallest = area;
            best = RegionRef{piece.piece.id, region.id};
        }
    return best;
}

std::optional<SeamId> seamAt(const Pattern& document, const FlatPattern& flat, Vec2 point, double tolerance) {
    Nearest<SeamId> nearest(tolerance);
    for (const Seam& seam : document.seams)
        for (const auto& side : seam.sides)
            for (const SeamPart& part : side) nearest.offer(distanceToPath(pathOf(flat, part), point), seam.id);
    return nearest.thing();
}

std::optional<TackEnd> tackEndAt(const Pattern& document, const FlatPattern& flat, Vec2 point, double tolerance) {
    Nearest<TackEnd> nearest(tolerance);
    for (const Tack& tack : document.tacks)
        for (std::size_t end = 0; end < 2; ++end)
            if (const auto at = positionOf(flat, tack.ends[end])) nearest.offer(distance(*at, point), {tack.id, end});
    return nearest.thing();
}

std::optional<FoldRef> foldAt(const FlatPattern& pattern, Vec2 point, double tolerance) {
    Nearest<FoldRef> nearest(tolerance);
    for (const FlatPiece& piece : pattern.pieces)
        for (const Fold& fold : piece.piece.folds)
            nearest.offer(distanceToPath(pointsOf(piece.piece, fold), point), {piece.piece.id, fold.id});
    return nearest.thing();
}

std::optional<FoldEnd> foldEndAt(const FlatPattern& pattern, Vec2 point, double tolerance) {
    Nearest<FoldEnd> nearest(tolerance);
    for (const FlatPiece& piece : pattern.pieces)
        for (const Fold& fold : piece.piece.folds)
            for (std::size_t end = 0; end < 2; ++end)
                if (const auto at = pointOf(piece.piece, fold.ends[end]))
                    nearest.offer(distance(*at, point), {{piece.piece.id, fold.id}, end});
    return nearest.thing();
}

std::optional<Vec2> positionOf(const FlatPattern& pattern, const ClothPoint& place) {
    const FlatPiece* piece = findPiece(pattern, place.piece);
    if (!piece) return std::nullopt;
    return place.point + piece->piece.tablePosition;
}

std::optional<Vec2> positionOf(const FlatPattern& pattern, const VertexRef& vertex) {
    const FlatPiece* piece = findPiece(pattern, vertex.piece);
    const auto place = piece ? placeOf(piece->piece, vertex.vertex) : std::nullopt;
    if (!place) return std::nullopt;
    return piece->contour(place->loop).vertices[place->vertex].position;
}

std::optional<Vec2> positionOf(const FlatPattern& pattern, const HandleRef& handle) {
    const FlatPiece* piece = findPiece(pattern, handle.edge.piece);
    const auto place = piece ? placeOf(piece->piece, handle.edge.edge) : std::nullopt;
    if (!place) return std::nullopt;
    const auto* cubic = std::get_if<geometry::CubicShape>(&piece->contour(place->loop).edges[place->edge].shape);
    if (!cubic) return std::nullopt;
    return handle.control == 1 ? cubic->control1 : cubic->control2;
}

std::vector<Vec2> pathOf(const FlatPattern& pattern, const EdgeRef& edge) {
    const FlatPiece* piece = findPiece(pattern, edge.piece);
    const auto place = piece ? placeOf(piece->piece, edge.edge) : std::nullopt;
    return place ? piece->flat(place->loop).edges[place->edge] : std::vector<Vec2>{};
}

} // namespace toile::ui
