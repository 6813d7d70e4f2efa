// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pattern/CutLine.h"

#include <algorithm>
#include <cmath>

namespace toile::pattern {
namespace {

constexpr double scissorsError = 0.1e-3; // [m] scissors follow no better
constexpr double farthest = 1000;        // [m] of what is cut from cloth; well within Clipper's integers
constexpr double overlap = 1e-6;         // [m] of neighbours: Clipper may leave apart what only shares an edge
constexpr double smallest = 1e-7;        // [m²]; less is what rounding has left between two strips
constexpr double longestMitre = 2.5;     // of the wider allowance: where a right angle's is 1.4

/// A stretch of the stitching line with the way outward to the cut line.
struct Strip {
    Vec2 start, end, outward; // outward: length = allowance [m]
};

std::vector<Strip> stripsOf(const Contour& contour, double allowanceOfPiece) {
    std::vector<Strip> strips;
    for (std::size_t e = 0; e < contour.edges.size(); ++e) {
        const double allowance = contour.edges[e].seamAllowance.value_or(allowanceOfPiece);
        const std::vector<Vec2> points = geometry::flattened(curveOf(contour, e), scissorsError);
        for (std::size_t i = 1; i < points.size(); ++i) {
            const Vec2 way = points[i] - points[i - 1];
            if (const double size = length(way); size > 0)
                strips.push_back({points[i - 1], points[i], Vec2{way.y, -way.x} * (allowance / size)});
        }
    }
    return strips;
}

Area areaOf(const Strip& strip) {
    const Vec2 along = normalized(strip.end - strip.start) * overlap, inward = Vec2{-along.y, along.x};
    const Vec2 start = strip.start - along, end = strip.end + along;
    return {{end + inward, start + inward, start + strip.outward, end + strip.outward}, {}};
}

/// What two strips leave open between them, outside a corner that points outward.
std::optional<Area> cornerBetween(const Strip& a, const Strip& b) {
    const Vec2 along = normalized(a.end - a.start), next = normalized(b.end - b.start);
    const double turn = cross(along, next);
    if (turn < 1e-9) return std::nullopt;
    const Vec2 corner = a.end;
    const Vec2 mitre = a.outward + along * (cross(b.outward - a.outward, next) / turn); // where the cut lines meet
    Area area{{corner, corner + a.outward, corner + b.outward}, {}};
    if (length(mitre) <= longestMitre * std::max(length(a.outward), length(b.outward)))
        area.outline.insert(area.outline.begin() + 2, corner + mitre);
    return area;
}

} // namespace

std::vector<Area> cutShape(const Piece& piece) {
    Area stitched;
    std::vector<Area> allowances;
    const auto add = [&](const Contour& contour) {
        const std::vector<Strip> strips = stripsOf(contour, piece.seamAllowance);
        geometry::Polygon polygon;
        for (std::size_t i = 0; i < strips.size(); ++i) {
            const Strip& strip = strips[i];
            polygon.push_back(strip.start);
            allowances.push_back(areaOf(strip));
            if (auto corner = cornerBetween(strip, strips[(i + 1) % strips.size()]))
                allowances.push_back(std::move(*corner));
        }
        return polygon;
    };
    stitched.outline = add(piece.outline);
    for (const Contour& hole : piece.holes) stitched.holes.push_back(add(hole));
    const auto isFar = [](Vec2 p) { return !(std::abs(p.x) < farthest && std::abs(p.y) < farthest); };
    for (const Area& area : allowances)
        if (std::ranges::any_of(area.outline, isFar)) return {stitched};
    std::vector<Area> cut = unionOf({stitched}, allowances);
    const auto isNothing = [](const geometry::Polygon& p) { return std::abs(geometry::signedArea(p)) < smallest; };
    std::erase_if(cut, [&](const Area& area) { return isNothing(area.outline); });
    for (Area& area : cut) std::erase_if(area.holes, isNothing);
    return cut;
}

} // namespace toile::pattern
