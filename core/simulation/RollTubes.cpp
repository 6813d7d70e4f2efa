// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/RollTubes.h"

#include "core/pattern/Pattern.h"
#include "core/simulation/Clearing.h"
#include "core/simulation/SeamPoints.h"

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <numbers>
#include <ranges>

namespace toile::simulation {
namespace {

using pattern::Pattern;
using pattern::Piece;
using pattern::PieceId;

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
        const auto a = pointsAlong(pattern, seam.sides[0]), b = pointsAlong(pattern, seam.sides[1]);
        if (a.empty() || b.empty()) continue;
        for (int k = 0; k < seamSamples; ++k) {
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
