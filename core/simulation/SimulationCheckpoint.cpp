// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/BodyContactOf.h"
#include "core/simulation/Simulation.h"

#include <algorithm>
#include <fmt/format.h>
#include <iterator>

namespace toile::simulation {

Checkpoint Simulation::checkpoint() {
    rebuildPlan();
    Checkpoint point{.scene = fingerprintOf(scene_, *garment_),
                     .time = state_.time,
                     .steps = steps_,
                     .phase = phase_,
                     .method = phases_.empty() ? "" : std::string(phases_.back().method),
                     .sewnTime = sewnTime_,
                     .restingTime = restingTime_,
                     .largestSpeed = largestSpeed_,
                     .goesOnAsItLay = goesOnAsItLay_,
                     .settles = settles_,
                     .leaps = leaps_,
                     .positions = state_.positions,
                     .velocities = state_.velocities,
                     .hangsBy = hangsBy_,
                     .sewn = sewnNodes_,
                     .shown = shown_,
                     .contact = contactMemory()};
    for (std::size_t seam = 0; seam < seams_.size(); ++seam)
        point.seams.push_back(
            {seams_[seam].merged, seams_[seam].initialGap, seams_[seam].gapAtMerge, seamStart_[seam], seamGaps_[seam]});
    for (const TackState& tack : tacks_)
        point.tacks.push_back({tack.closed, tack.initialGap, tack.start, tack.startGap});
    return point;
}

Result<Simulation> Simulation::resumed(Scene scene, const MeshOverrides& overrides, const Checkpoint& point) {
    const auto refused = [](std::string_view why) {
        return fail(ErrorCode::invalidInput, fmt::format("The checkpoint is of another scene: {}.", why));
    };
    auto made = create(std::move(scene), overrides);
    if (!made) return made;
    Simulation after = std::move(*made);
    if (point.seams.size() != after.seams_.size())
        return refused(fmt::format("{} seams, not {}", point.seams.size(), after.seams_.size()));
    if (point.tacks.size() != after.tacks_.size())
        return refused(fmt::format("{} tacks, not {}", point.tacks.size(), after.tacks_.size()));
    std::vector<bool> merged;
    for (const Checkpoint::Seam& seam : point.seams) merged.push_back(seam.merged);
    auto garment = makeGarment(after.scene_.pattern, after.garment_->mesh, std::move(merged), after.scene_.paper);
    if (!garment) return tl::unexpected(garment.error());
    const auto particles = static_cast<std::size_t>(garment->particles.particleCount);
    if (point.positions.size() != particles || point.velocities.size() != particles)
        return refused(fmt::format("{} particles, not {}", point.positions.size(), particles));
    const auto isOfItsNodes = [&](const std::vector<Vec3>& nodes) {
        return nodes.empty() || nodes.size() == garment->particles.particleOf.size();
    };
    if (!isOfItsNodes(point.sewn) || !isOfItsNodes(point.shown)) return refused("it has another number of nodes");
    const auto isItsNode = [&](int node) { return node >= 0 && node < std::ssize(garment->particles.particleOf); };
    if (!std::ranges::all_of(point.hangsBy, isItsNode)) return refused("it hangs by a node that is not there");
    if (point.scene != fingerprintOf(after.scene_, *garment))
        return refused("its mesh, fabrics, body or settings are different");
    for (std::size_t seam = 0; seam < point.seams.size(); ++seam)
        if (!point.seams[seam].gaps.empty() &&
            point.seams[seam].gaps.size() != after.garment_->mesh->seams[seam].pairs.size())
            return refused("a seam has another number of pairs");

    after.garment_ = std::make_unique<const Garment>(std::move(*garment));
    after.state_ = {point.positions, point.velocities, point.time};
    after.steps_ = point.steps;
    after.phase_ = point.phase;
    if (const auto method = dynamics::methodNamed(point.method))
        after.phases_.push_back({.phase = point.phase, .method = dynamics::nameOf(*method)});
    after.sewnTime_ = point.sewnTime;
    after.restingTime_ = point.restingTime;
    after.largestSpeed_ = point.largestSpeed;
    after.goesOnAsItLay_ = point.goesOnAsItLay;
    after.settles_ = point.settles;
    after.leaps_ = point.leaps;
    after.hangsBy_ = point.hangsBy;
    after.sewnNodes_ = point.sewn;
    after.shown_ = point.shown;
    for (std::size_t seam = 0; seam < point.seams.size(); ++seam) {
        const Checkpoint::Seam& from = point.seams[seam];
        after.seams_[seam].merged = from.merged;
        after.seams_[seam].initialGap = from.initialGap;
        after.seams_[seam].gapAtMerge = from.gapAtMerge;
        after.seamStart_[seam] = from.start;
        after.seamGaps_[seam] = from.gaps;
    }
    for (std::size_t tack = 0; tack < point.tacks.size(); ++tack) {
        const Checkpoint::Tack& from = point.tacks[tack];
        TackState& to = after.tacks_[tack];
        to.closed = from.closed;
        to.initialGap = from.initialGap;
        to.start = from.start;
        to.startGap = from.startGap;
    }
    after.rebuildPlan();
    if (auto* contact = bodyContactIn(after.plan_); contact && !point.contact.forces.empty())
        if (!contact->recall(point.contact)) return refused("its cloth touches the body at other places");
    return after;
}

} // namespace toile::simulation
