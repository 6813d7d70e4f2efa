// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/FindTubes.h"

#include "core/body/Arrangement.h"
#include "core/simulation/SeamPoints.h"

#include <algorithm>
#include <limits>
#include <numbers>
#include <optional>

namespace toile::simulation {
namespace {

using body::LimbAxis;
using pattern::Pattern;
using pattern::Piece;

double distanceTo(const LimbAxis& axis, const Vec3& p) {
    double best = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i + 1 < axis.points.size(); ++i) {
        const Vec3 a = axis.points[i], along = axis.points[i + 1] - a;
        const double t = std::clamp(dot(p - a, along) / std::max(squaredLength(along), 1e-12), 0.0, 1.0);
        best = std::min(best, geometry::distance(p, a + along * t));
    }
    return best;
}

/// The two edges of a piece that a seam joins into a tube.
struct TubeSeam {
    Vec2 axis;         ///< along the edges
    double width = 0;  ///< between them, in the mean [m]
    double middle = 0; ///< across the axis, half-way between them [m]
};

/// None where no seam of the piece makes it a tube: a dart joins edges that meet in a point.
std::optional<TubeSeam> tubeSeamOf(const Pattern& pattern, const Piece& piece) {
    constexpr double apart = 0.02; // [m]
    for (const pattern::Seam& seam : pattern.seams) {
        if (!isWithin(seam, piece.id)) continue;
        const auto a = pointsAlong(pattern, seam.sides[0]), b = pointsAlong(pattern, seam.sides[1]);
        if (a.empty() || b.empty()) continue;
        if (geometry::distance(a.front().at, b.front().at) < apart ||
            geometry::distance(a.back().at, b.back().at) < apart)
            continue;
        const Vec2 along = a.back().at - a.front().at + b.back().at - b.front().at;
        if (length(along) < 0.01) continue;
        TubeSeam tube{normalized(along)};
        const Vec2 across = acrossOf(tube.axis);
        for (int k = 0; k < seamSamples; ++k) {
            tube.width += std::abs(dot(b[k].at - a[k].at, across)) / seamSamples;
            tube.middle += dot(a[k].at + b[k].at, across) / (2 * seamSamples);
        }
        return tube;
    }
    return std::nullopt;
}

/// As the piece lies now.
TubePlace placeAsItLies(const geometry::Polyline& limb, TubePlace place, const pattern::Placement& now) {
    const Vec3 middle = pattern::placed(now, acrossOf(place.axis) * place.middle);
    place.at = geometry::nearestArcLength(limb, middle);
    place.upper = now.transform.axisZ;
    const Vec3 axis = now.transform.direction({place.axis.x, place.axis.y, 0});
    place.towardsEnd = dot(axis, geometry::frameAlong(limb, place.at, place.upper).axisY) > 0;
    return place;
}

/// An arm or a leg.
struct LimbBeside {
    geometry::Polyline line;
    double end = 0; ///< where the wrist or the ankle lies [m]
};

/// The arm or leg beside which a piece lies.
std::optional<LimbBeside> limbBeside(const Piece& piece, const body::Body& body) {
    const body::Limb limb = nearestLimb(body, middleOf(piece));
    auto line = body::limbLine(body, limb);
    if (!line) return std::nullopt;
    const double end = body::limbLineLength(body, limb, *line);
    return LimbBeside{std::move(*line), end};
}

/// From its root to its end it keeps within a centimetre of the straight.
bool isStraight(const LimbBeside& limb) {
    constexpr double bent = 0.01; // [m]
    const Vec3 root = limb.line.front(),
               along = normalized(geometry::frameAlong(limb.line, limb.end, {0, 0, 1}).origin - root);
    double gone = 0, off = 0;
    for (std::size_t i = 1; i < limb.line.size() && gone < limb.end; ++i) {
        gone += geometry::distance(limb.line[i - 1], limb.line[i]);
        off = std::max(off, geometry::length(cross(limb.line[i] - root, along)));
    }
    return off < bent;
}

/// Of a roll whose edges nearly meet: 94 % of the way round.
double closingRadius(double width) {
    return width / (2 * std::numbers::pi * 0.94);
}

} // namespace

body::Limb nearestLimb(const body::Body& body, const Vec3& point) {
    return std::ranges::min_element(body.axes, {}, [&](const LimbAxis& axis) { return distanceTo(axis, point); })->limb;
}

Vec3 middleOf(const Piece& piece) {
    Vec3 sum;
    for (const pattern::Vertex& vertex : piece.outline.vertices)
        sum += pattern::placed(*piece.placement, vertex.position);
    return sum / static_cast<double>(std::max<std::size_t>(1, piece.outline.vertices.size()));
}

std::vector<Roll> flatTubesOf(const Pattern& pattern, const body::Body& body) {
    std::vector<Roll> rolls;
    for (std::size_t i = 0; i < pattern.pieces.size(); ++i) {
        const Piece& piece = *pattern.pieces[i];
        if (!piece.placement || piece.placement->curl) continue;
        const auto seam = tubeSeamOf(pattern, piece);
        const auto limb = seam ? limbBeside(pattern::resolved(pattern, piece), body) : std::nullopt;
        if (!limb) continue;
        const TubePlace place{.axis = seam->axis, .middle = seam->middle, .radius = closingRadius(seam->width)};
        rolls.push_back({i, placeAsItLies(limb->line, place, *piece.placement), limb->line, limb->end});
    }
    return rolls;
}

std::vector<Roll> tubesOnBentLimbs(const Pattern& pattern, const body::Body& body) {
    std::vector<Roll> rolls;
    for (std::size_t i = 0; i < pattern.pieces.size(); ++i) {
        const Piece piece = pattern::resolved(pattern, *pattern.pieces[i]);
        if (!piece.placement || !piece.placement->curl) continue;
        const std::vector<Vec2> points = pointsOn(piece);
        const auto limb = isTube(points, *piece.placement) ? limbBeside(piece, body) : std::nullopt;
        if (!limb || isStraight(*limb)) continue;
        const Vec2 axis = piece.placement->curl->axis;
        const Extent across = extentAlong(points, acrossOf(axis));
        const TubePlace place{.axis = axis,
                              .middle = 0.5 * (across.low + across.high),
                              .radius = closingRadius(across.high - across.low)};
        rolls.push_back({i, placeAsItLies(limb->line, place, *piece.placement), limb->line, limb->end});
    }
    return rolls;
}

} // namespace toile::simulation
