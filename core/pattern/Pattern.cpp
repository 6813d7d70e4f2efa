// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pattern/Pattern.h"

#include "core/geometry/FrameAlong.h"

#include <algorithm>
#include <cmath>

namespace toile::pattern {
namespace {

template <class Range, class IdType>
auto* findById(Range& range, const IdType& id) {
    const auto found = std::ranges::find_if(range, [&](const auto& item) {
        if constexpr (requires { item->id; }) return item->id == id;
        else return item.id == id;
    });
    using Item = std::remove_reference_t<decltype(*found)>;
    if constexpr (requires(Item & item) { item->id; }) return found == range.end() ? nullptr : &**found;
    else return found == range.end() ? nullptr : &*found;
}

/// Reflected and turned round, so that it runs counter-clockwise again (holes clockwise). Vertex 0 stays first.
Contour mirrored(const Contour& contour, Vec2 a, Vec2 b) {
    const std::size_t n = contour.vertices.size();
    Contour image;
    for (std::size_t i = 0; i < n; ++i) {
        const Vertex& vertex = contour.vertices[(n - i) % n];
        image.vertices.push_back({vertex.id, geometry::mirrored(vertex.position, a, b)});
        const std::size_t edge = n - 1 - i; // the edge that ends at this vertex now leaves it
        const geometry::Curve curve = geometry::reversed(geometry::mirrored(curveOf(contour, edge), a, b));
        image.edges.push_back({contour.edges[edge].id, curve.shape, contour.edges[edge].seamAllowance});
    }
    return image;
}

Polygon mirrored(const Polygon& polygon, Vec2 a, Vec2 b) {
    Polygon image;
    for (const Vec2 p : polygon) image.push_back(geometry::mirrored(p, a, b));
    std::ranges::reverse(image);
    return image;
}

double mirroredGrain(double grain, Vec2 a, Vec2 b) {
    const Vec2 warp{-std::sin(grain), std::cos(grain)};
    const Vec2 image = geometry::mirrored(warp, {}, b - a);
    return std::atan2(-image.x, image.y);
}

/// A point of the circle that stands square to the line, from the middle of the roll at the piece's origin.
Vec3 laidAlong(const BentLine& line, double along, const Vec3& onCircle) {
    const Vec3 outward{0, 0, 1};
    return geometry::frameAlong(line.points, along - line.from, outward, -line.from).point(onCircle);
}

} // namespace

geometry::Curve curveOf(const Contour& contour, std::size_t edge) {
    return {contour.vertices[edge].position, contour.vertices[(edge + 1) % contour.vertices.size()].position,
            contour.edges[edge].shape};
}

Vec3 placed(const Placement& placement, Vec2 point) {
    Vec3 p{point.x, point.y, 0};
    if (placement.curl) {
        const Vec2 along = placement.curl->axis;
        const Vec2 across{along.y, -along.x}; // with along = +y: +x
        const double radius = placement.curl->radius, s = dot(point, across);
        const double aside = radius * std::sin(s / radius), inward = radius * (std::cos(s / radius) - 1);
        const Vec2 flat = along * dot(point, along) + across * aside;
        p = {flat.x, flat.y, inward};
        if (placement.curl->bent)
            p = laidAlong(*placement.curl->bent, dot(point, along), {aside, 0, inward + radius}) - Vec3{0, 0, radius};
    }
    return placement.transform.point(p);
}

const Piece* findPiece(const Pattern& pattern, const PieceId& id) {
    return findById(pattern.pieces, id);
}
const Seam* findSeam(const Pattern& pattern, const SeamId& id) {
    return findById(pattern.seams, id);
}
const Fabric* findFabric(const Pattern& pattern, const FabricId& id) {
    return findById(pattern.fabrics, id);
}

Piece resolved(const Pattern& pattern, const Piece& piece) {
    if (!piece.mirror) return piece;
    const Piece* source = findPiece(pattern, piece.mirror->source);
    if (!source || source->mirror) return piece; // checkPattern reports it
    const Vec2 a = piece.mirror->lineStart, b = piece.mirror->lineEnd;
    Piece image = piece;
    image.outline = mirrored(source->outline, a, b);
    image.holes.clear();
    for (const Contour& hole : source->holes) image.holes.push_back(mirrored(hole, a, b));
    image.grain = mirroredGrain(source->grain, a, b);
    image.regions = source->regions;
    for (Region& region : image.regions) {
        region.outline = mirrored(region.outline, a, b);
        for (Polygon& hole : region.holes) hole = mirrored(hole, a, b);
    }
    image.notches = source->notches;
    for (Notch& notch : image.notches) notch.position = 1 - notch.position;
    image.folds = source->folds;
    for (Fold& fold : image.folds) {
        for (BorderPoint& end : fold.ends) end.position = 1 - end.position;
        for (Vec2& p : fold.between) p = geometry::mirrored(p, a, b);
    }
    image.internalLines = source->internalLines;
    for (InternalLine& line : image.internalLines)
        for (Vec2& p : line.points) p = geometry::mirrored(p, a, b);
    return image;
}

} // namespace toile::pattern
