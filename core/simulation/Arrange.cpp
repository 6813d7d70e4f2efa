// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/Arrange.h"

#include "core/body/Arrangement.h"
#include "core/collision/BodySurface.h"
#include "core/simulation/Clearing.h"
#include "core/simulation/LegSides.h"
#include "core/simulation/RollTubes.h"

#include <algorithm>

namespace toile::simulation {
namespace {

using body::Limb;

/// As placementCarriedOver; where the limb's section cannot be measured, as where it bends, without a change
/// of size.
std::optional<Transform> carried(const Transform& placement, const body::Body& from, const body::Body& to, Limb limb) {
    if (const auto whole = body::placementCarriedOver(placement, from, to, limb)) return whole;
    const auto start = body::limbFrame(from, limb), end = body::limbFrame(to, limb);
    if (!start || !end) return std::nullopt;
    const Transform turned{{start->axisX.x, start->axisY.x, start->axisZ.x},
                           {start->axisX.y, start->axisY.y, start->axisZ.y},
                           {start->axisX.z, start->axisY.z, start->axisZ.z},
                           {}};
    const Transform back{turned.axisX, turned.axisY, turned.axisZ, -turned.direction(start->origin)};
    return composed(*end, composed(back, placement));
}

/// The placement beside the same limb of another body; none if one of them lacks it.
std::optional<pattern::Placement> carriedOver(const pattern::Piece& piece, const body::Body& from,
                                              const body::Body& to) {
    const Limb limb = nearestLimb(from, middleOf(piece));
    const auto transform = carried(piece.placement->transform, from, to, limb);
    if (!transform) return std::nullopt;
    pattern::Placement placement{*transform, piece.placement->curl};
    if (!placement.curl) return placement;
    // Rolled tighter than it was, a piece that nearly closes would overlap itself.
    placement.curl->radius *= std::max(1.0, body::sizeRatio(from, to, limb).value_or(1));
    return placement;
}

/// Every piece moved clear of the body, tubes rolled round their limbs.
pattern::Pattern cleared(const pattern::Pattern& pattern, std::vector<Roll> rolls, const body::Body& body) {
    const auto surface = collision::BodySurface::create(body.mesh);
    if (!surface) return pattern;
    pattern::Pattern arranged = body.axes.empty() ? pattern : withLegsApart(pattern, body);
    for (auto& shared : arranged.pieces) {
        if (!shared->placement) continue;
        pattern::Piece piece = *shared;
        piece.placement = movedClear(pointsOn(pattern::resolved(pattern, piece)), *piece.placement, *surface);
        shared = std::move(piece);
    }
    return rolledRound(arranged, std::move(rolls), *surface);
}

} // namespace

pattern::Pattern arrangedOn(const pattern::Pattern& pattern, const body::Body& from, const body::Body& to) {
    if (from.axes.empty() || to.axes.empty()) return pattern;
    pattern::Pattern arranged = pattern;
    for (auto& shared : arranged.pieces) {
        if (!shared->placement) continue;
        const auto placement = carriedOver(pattern::resolved(pattern, *shared), from, to);
        if (!placement) continue;
        pattern::Piece piece = *shared;
        piece.placement = *placement;
        shared = std::move(piece);
    }
    if (from == to) return arranged;
    std::vector<Roll> rolls = tubesOnBentLimbs(arranged, to);
    std::ranges::move(flatTubesOf(arranged, to), std::back_inserter(rolls));
    return cleared(arranged, std::move(rolls), to);
}

pattern::Pattern startingClearOf(const pattern::Pattern& pattern, const body::Body& body) {
    return cleared(pattern, body.axes.empty() ? std::vector<Roll>{} : flatTubesOf(pattern, body), body);
}

} // namespace toile::simulation
