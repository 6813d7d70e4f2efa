// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/Simulation.h"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>

/// Cloth that nothing drives sleeps once it is still.
namespace toile::simulation {

/// What determines its steps is as it was, so it would go on lying there.
bool Simulation::isAsleep() const {
    return stillTime_ >= beforeSleep;
}

void Simulation::sleepFor(double duration) {
    state_.time += duration;
    sleptTime_ += duration;
    ++sleptSteps_;
    restingTime_ += duration;
    largestSpeed_ = 0;
    ++steps_;
    note(duration, {.parts = 0});
    goOnDressing(false);
}

/// Of pieces that touch no others, some may sleep while others move. Coarse levels would move all.
void Simulation::noteSleepers(std::span<const Vec3> before, double duration) {
    constexpr double reach = 0.02; // to be awake before it is touched [m]
    if (phase_ != Phase::draping || motion_ || plannedLevels_ > 0 || scene_.paper) return;
    if (before.size() != state_.positions.size()) return; // a seam has just been merged
    if (!sleepers_) sleepers_ = std::make_unique<Sleepers>(*garment_, tacks_);
    sleptApart_ += sleepers_->share();
    const bool meet = plan_.find("self-contact") != nullptr;
    if (sleepers_->note(*garment_, before, state_.positions, duration, meet ? std::optional(reach) : std::nullopt))
        planAnew();
}

/// Null where all of it is.
std::unique_ptr<const Garment> Simulation::awakeNow() const {
    if (!sleepers_ || sleepers_->pieces().empty()) return nullptr;
    return std::make_unique<const Garment>(sleepers_->awakeOf(*garment_));
}

void Simulation::leaveOutSleepers() {
    if (!awake_) return;
    std::vector<std::string_view> names;
    for (const int piece : sleepers_->pieces()) names.push_back(scene_.pattern.pieces[piece]->name);
    plan_.leaveOut("pieces", fmt::format("they lie still: {}", fmt::join(names, ", ")));
}

bool Simulation::holdsSleepers() const {
    return awake_ && std::ranges::any_of(*grips_, [&](const Grip& grip) {
               const auto& pieces = scene_.pattern.pieces;
               const auto held = std::ranges::find_if(pieces, [&](const auto& p) { return p->id.value == grip.piece; });
               return held != pieces.end() && sleepers_->isAsleep(static_cast<int>(held - pieces.begin()));
           });
}

} // namespace toile::simulation
