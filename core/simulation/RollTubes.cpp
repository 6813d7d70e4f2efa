// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/RollTubes.h"

#include "core/body/Arrangement.h"
#include "core/pattern/PatternMeasures.h"
#include "core/simulation/Clearing.h"

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <numbers>
#include <ranges>

namespace toile::simulation {
namespace {

using body::LimbAxis;
using pattern::Pattern;
using pattern::Piece;
using pattern::PieceId;

double distanceTo(const LimbAxis& axis, const Vec3& p) {
    double best = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i + 1 < axis.points.size(); ++i) {
        const Vec3 a = axis.points[i], along = axis.points[i + 1] - a;
        const double t = std::clamp(dot(p - a, along) / std::max(squaredLength(along), 1e-12), 0.0, 1.0);
        best = std::min(best, geometry::distance(p, a + along * t));
    }
    return best;
}

/// A point of a seam's side.
struct SeamPoint {
    PieceId piece;
    Vec2 at;
};

/// Equally far apart along a chain of parts, from its first end to its last.
std::vector<SeamPoint> pointsAlong(const Pattern& pattern, const std::vector<pattern::SeamPart>& chain, int count) {
    std::vector<SeamPoint> corners;
    std::vector<double> gone;
    for (const pattern::SeamPart& part : chain)
        for (const Vec2 p : pattern::partPoints(pattern, part, 1e-3)) {
            const bool same = !corners.empty() && corners.back().piece == part.piece;
            gone.push_back(gone.empty() ? 0 : gone.back() + (same ? geometry::distance(corners.back().at, p) : 0));
            corners.push_back({part.piece, p});
        }
    std::vector<SeamPoint> points;
    if (corners.size() < 2) return points;
    std::size_t i = 0;
    for (int k = 0; k < count; ++k) {
        const double at = gone.back() * k / (count - 1);
        while (i + 2 < corners.size() && gone[i + 1] < at) ++i;
        const double stretch = gone[i + 1] - gone[i],
                     t = stretch > 0 ? std::clamp((at - gone[i]) / stretch, 0.0, 1.0) : 0;
        const bool joint = corners[i].piece != corners[i + 1].piece;
        points.push_back(joint ? corners[i] : SeamPoint{corners[i].piece, lerp(corners[i].at, corners[i + 1].at, t)});
    }
    return points;
}

constexpr int samples = 9; // of a seam

/// The two edges of a piece that a seam joins into a tube.
struct TubeSeam {
    Vec2 axis;         ///< along the edges
    double width = 0;  ///< between them, in the mean [m]
    double middle = 0; ///< across the axis, half-way between them [m]
};

/// It joins edges of this one piece.
bool isWithin(const pattern::Seam& seam, const PieceId& piece) {
    const auto within = [&](const pattern::SeamPart& part) { return part.piece == piece; };
    return std::ranges::all_of(seam.sides[0], within) && std::ranges::all_of(seam.sides[1], within);
}

/// None where no seam of the piece makes it a tube: a dart joins edges that meet in a point.
std::optional<TubeSeam> tubeSeamOf(const Pattern& pattern, const Piece& piece) {
    constexpr double apart = 0.02; // [m]
    for (const pattern::Seam& seam : pattern.seams) {
        if (!isWithin(seam, piece.id)) continue;
        const auto a = pointsAlong(pattern, seam.sides[0], samples), b = pointsAlong(pattern, seam.sides[1], samples);
        if (a.empty() || b.empty()) continue;
        if (geometry::distance(a.front().at, b.front().at) < apart ||
            geometry::distance(a.back().at, b.back().at) < apart)
            continue;
        const Vec2 along = a.back().at - a.front().at + b.back().at - b.front().at;
        if (length(along) < 0.01) continue;
        TubeSeam tube{normalized(along)};
        const Vec2 across = acrossOf(tube.axis);
        for (int k = 0; k < samples; ++k) {
            tube.width += std::abs(dot(b[k].at - a[k].at, across)) / samples;
            tube.middle += dot(a[k].at + b[k].at, across) / (2 * samples);
        }
        return tube;
    }
    return std::nullopt;
}

/// A point of a piece and the point of space it is to be sewn to.
struct Meeting {
    Vec2 own;
    Vec3 other;
};

/// Where pieces will be when the garment is sewn, as far as is known.
using Places = std::map<PieceId, pattern::Placement>;

/// Where the piece meets others whose place is known.
std::vector<Meeting> meetingsOf(const Pattern& pattern, const PieceId& piece, const Places& places) {
    std::vector<Meeting> meetings;
    for (const pattern::Seam& seam : pattern.seams) {
        const auto a = pointsAlong(pattern, seam.sides[0], samples), b = pointsAlong(pattern, seam.sides[1], samples);
        if (a.empty() || b.empty()) continue;
        for (int k = 0; k < samples; ++k) {
            if ((a[k].piece == piece) == (b[k].piece == piece)) continue;
            const SeamPoint &own = a[k].piece == piece ? a[k] : b[k], &other = a[k].piece == piece ? b[k] : a[k];
            if (const auto place = places.find(other.piece); place != places.end())
                meetings.push_back({own.at, pattern::placed(place->second, other.at)});
        }
    }
    return meetings;
}

double sumOfSquares(const std::vector<Meeting>& meetings, const pattern::Placement& placement) {
    double sum = 0;
    for (const Meeting& m : meetings) sum += squaredLength(pattern::placed(placement, m.own) - m.other);
    return sum;
}

/// How far down the limb the origin lies when the seams are, in the mean, a finger's breadth long along it.
double placeAlong(const geometry::Polyline& limb, const TubePlace& place, const std::vector<Meeting>& meetings) {
    constexpr double gap = 0.01; // [m]
    double sum = 0;
    for (const Meeting& m : meetings)
        sum += geometry::nearestArcLength(limb, m.other) - (place.towardsEnd ? 1 : -1) * dot(m.own, place.axis);
    return sum / static_cast<double>(meetings.size()) + gap;
}

/// The one of both directions and of all turns about the limb that leaves the shortest seams.
TubePlace placeBySeams(const geometry::Polyline& limb, TubePlace place, const Extent& along,
                       const std::vector<Meeting>& meetings) {
    TubePlace best = place;
    double least = std::numeric_limits<double>::infinity(), bestAngle = 0;
    const auto tryAngle = [&](double angle) {
        const Transform frame = geometry::frameAlong(limb, place.at, {0, 0, 1});
        place.upper = frame.axisX * std::sin(angle) + frame.axisZ * std::cos(angle);
        const double sum = sumOfSquares(meetings, placedRound(limb, place, along.low, along.high));
        if (sum >= least) return;
        least = sum;
        bestAngle = angle;
        best = place;
    };
    constexpr double coarse = std::numbers::pi / 12, fine = coarse / 15; // a degree
    for (const bool towardsEnd : {false, true}) {
        place.towardsEnd = towardsEnd;
        place.at = placeAlong(limb, place, meetings);
        for (int turn = 0; turn < 24; ++turn) tryAngle(turn * coarse);
    }
    place = best;
    for (const double middle = bestAngle; const int turn : std::views::iota(-14, 15)) tryAngle(middle + turn * fine);
    return best;
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

/// How a piece is to be rolled by what it is sewn to.
TubePlace bestPlace(const Pattern& pattern, const Roll& roll, const Extent& along, const Places& places) {
    const auto meetings = meetingsOf(pattern, pattern.pieces[roll.piece]->id, places);
    return meetings.empty() ? roll.place : placeBySeams(roll.limb, roll.place, along, meetings);
}

/// The lower end of a placed tube lies over the hand or the foot.
bool reachesBeyond(const Roll& roll, const pattern::Placement& placement, const Extent& along) {
    constexpr double wrist = 0.03; // what ends so near is still round the wrist [m]
    const Vec2 axis = roll.place.axis;
    const double radius = placement.curl->radius;
    return std::ranges::any_of(std::array{along.low, along.high}, [&](double t) {
        const Vec3 above = pattern::placed(placement, axis * t),
                   below = pattern::placed(placement, axis * t + acrossOf(axis) * (std::numbers::pi * radius));
        return geometry::nearestArcLength(roll.limb, lerp(above, below, 0.5)) > roll.end + wrist;
    });
}

/// The seams that close a tube become the last. Through the slit of a sleeve that lies over a hand the thumb
/// comes out while the sleeve is drawn up; closed at once, it would hold the seam open.
void closeLast(Pattern& pattern, const PieceId& piece, int last) {
    for (pattern::Seam& seam : pattern.seams)
        if (isWithin(seam, piece)) seam.order = last;
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

Pattern rolledRound(const Pattern& pattern, std::vector<Roll> rolls, const collision::BodySurface& surface) {
    std::ranges::stable_sort(rolls, {}, [](const Roll& roll) { return roll.place.at; }); // a sleeve before its cuff
    Places places;
    for (const auto& piece : pattern.pieces)
        if (piece->placement) places.emplace(piece->id, *piece->placement);
    for (const Roll& roll : rolls) places.erase(pattern.pieces[roll.piece]->id);
    int last = 0;
    for (const pattern::Seam& seam : pattern.seams) last = std::max(last, seam.order);
    Pattern arranged = pattern;
    for (const Roll& roll : rolls) {
        Piece piece = *pattern.pieces[roll.piece];
        const std::vector<Vec2> points = pointsOn(pattern::resolved(pattern, piece));
        const Extent along = extentAlong(points, roll.place.axis);
        const TubePlace place = bestPlace(pattern, roll, along, places);
        places[piece.id] = placedRound(roll.limb, place, along.low, along.high);
        const auto placement = clearRound(roll.limb, roll.end, place, points, surface);
        if (!placement) continue;
        piece.placement = *placement;
        if (reachesBeyond(roll, *placement, along)) closeLast(arranged, piece.id, last + 1);
        arranged.pieces[roll.piece] = std::move(piece);
    }
    return arranged;
}

} // namespace toile::simulation
