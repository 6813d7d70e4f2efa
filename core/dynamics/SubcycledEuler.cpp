// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/dynamics/SubcycledEuler.h"

#include "core/cloth/Forces.h"
#include "core/cloth/Levels.h"
#include "core/dynamics/FrequencyBound.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace toile::dynamics {
namespace {

std::int64_t elementsOf(const cloth::ClothModel& m) {
    return static_cast<std::int64_t>(m.structural.size() + m.shear.size() + m.elastics.size() + m.flexion.size() +
                                     m.bending.size() + m.twist.size() + m.hinges.size() + m.triangles.size() +
                                     m.cells.size());
}

} // namespace

SubcycledEuler::SubcycledEuler(const cloth::ClothModel& model, SubcycledEulerSettings settings)
    : Integrator(model), settings_(settings), bound_(model), forces_(model.mass.size()) {}

std::size_t SubcycledEuler::bytes() const {
    std::size_t sum =
        (forces_.capacity() + stageForces_.capacity()) * sizeof(Vec3) + partsNeeded_.capacity() * sizeof(int);
    for (const Level& level : levels_)
        sum += (level.joined.capacity() + level.slaves.capacity() + level.drifting.capacity()) * sizeof(int);
    return sum;
}

double SubcycledEuler::stepLimit(std::span<const Vec3> positions, std::span<Stage* const> stages) const {
    return 2 / bound_.largest(positions, stages);
}

Result<std::vector<int>> SubcycledEuler::partsFor(double duration, std::span<const Vec3> positions,
                                                  std::span<Stage* const> stages) const {
    double ofStages = 0;
    for (const Stage* stage : stages) ofStages += stage->largestFrequencySquared();
    std::vector<int> parts(positions.size(), 1);
    const std::vector<double> squared = cloth::frequenciesSquared(model(), positions);
    for (const int p : eliminated().free()) {
        const auto needed = explicitParts(duration, 2 / std::sqrt(squared[p] + ofStages), settings_.safety);
        if (!needed) return tl::unexpected(needed.error());
        parts[p] = *needed;
    }
    for (const int s : eliminated().slaves())
        for (const auto& [master, weight] : model().slaves[s].masters)
            parts[model().slaves[s].particle] = std::max(parts[model().slaves[s].particle], parts[master]);
    return parts;
}

void SubcycledEuler::sortInto(std::span<const int> partsNeeded, bool allDriftTogether) {
    // From the finest down, so that what costs most takes no step more than it needs.
    int most = 1, fewest = std::numeric_limits<int>::max();
    for (const int p : eliminated().free()) {
        most = std::max(most, partsNeeded[p]);
        fewest = std::min(fewest, partsNeeded[p]);
    }
    fewest = std::min(fewest, most);
    const int octaves = static_cast<int>(std::bit_width(static_cast<unsigned>(most / fewest))) - 1;
    const int highest = std::min(settings_.levels - 1, octaves);
    parts_ = (most + (1 << highest) - 1) >> highest;
    std::vector<int> levelOf(partsNeeded.size());
    for (std::size_t p = 0; p < levelOf.size(); ++p)
        while (levelOf[p] < highest && partsNeeded[p] > parts_ << levelOf[p]) ++levelOf[p];

    levels_.assign(highest + 1, {});
    std::vector<cloth::ClothModel> parts = cloth::elementsByLevel(model(), levelOf, highest + 1);
    std::vector<int> clock(partsNeeded.size(), 0);
    for (int l = 0; l <= highest; ++l) {
        Level& level = levels_[l];
        level.elements = std::move(parts[l]);
        level.count = elementsOf(level.elements);
        level.joined = cloth::joinedParticles(level.elements);
        for (const int p : level.joined) clock[p] = l;
        for (const int s : eliminated().slaves()) {
            const cloth::Slave& slave = model().slaves[s];
            if (!std::ranges::binary_search(level.joined, slave.particle)) continue;
            level.slaves.push_back(s);
            for (const auto& [master, weight] : slave.masters) clock[master] = l;
        }
    }
    for (const int p : eliminated().free()) levels_[allDriftTogether ? highest : clock[p]].drifting.push_back(p);
}

void SubcycledEuler::push(const Level& level, ParticleState& state, double h) {
    for (const int s : level.slaves) {
        const cloth::Slave& slave = model().slaves[s];
        state.positions[slave.particle] = {};
        for (const auto& [master, weight] : slave.masters)
            state.positions[slave.particle] += weight * state.positions[master];
    }
    cloth::addForces(level.elements, state.positions, forces_);
    for (const int p : level.joined) {
        give(forces_[p] * h, p, state.velocities);
        forces_[p] = {};
    }
    elementPushes_ += level.count;
}

void SubcycledEuler::pushByStages(ParticleState& state, std::span<Stage* const> stages, double h) {
    eliminated().place(state.positions);
    stageForces_.assign(state.positions.size(), {});
    eliminated().place(state.velocities);
    for (Stage* stage : stages) {
        stage->take({.velocities = state.velocities, .span = h});
        stage->fixFriction(state.positions);
        stage->beginIteration(state.positions);
        stage->addForces(state.positions, stageForces_);
    }
    for (int p = 0; p < model().particleCount(); ++p) give(stageForces_[p] * h, p, state.velocities);
}

void SubcycledEuler::give(const Vec3& impulse, int particle, std::span<Vec3> velocities) const {
    for (const auto& [unknown, weight] : eliminated().termsOf(particle)) {
        const int free = eliminated().free()[unknown];
        velocities[free] += impulse * (weight / model().mass[free]);
    }
}

Result<StepReport> SubcycledEuler::advance(ParticleState& state, double duration, const Vec3& gravity,
                                           std::span<Stage* const> stages, std::stop_token stop) {
    auto needed = partsFor(duration, state.positions, stages);
    if (!needed) return tl::unexpected(needed.error());
    if (levels_.empty() || *needed != partsNeeded_ || !stages.empty() != withStages_) {
        partsNeeded_ = std::move(*needed);
        withStages_ = !stages.empty();
        sortInto(partsNeeded_, withStages_);
    }
    const double limit = stepLimit(state.positions, stages);
    for (Stage* stage : stages) stage->beginStep(state, duration);
    const int highest = static_cast<int>(levels_.size()) - 1, ticks = parts_ << highest;
    const double shortest = duration / ticks;
    std::vector<Vec3> from;
    for (int tick = 0; tick < ticks; ++tick) {
        if (stop.stop_requested()) return fail(ErrorCode::cancelled, "The step was stopped.");
        // Level l has its turn every 2^(highest − l) ticks; then all that its elements join has come to this time.
        int first = 0;
        while (tick % (1 << (highest - first)) != 0) ++first;
        const auto stepOf = [&](int level) { return shortest * (1 << (highest - level)); };
        for (int l = first; l <= highest; ++l)
            for (const int p : levels_[l].drifting)
                state.velocities[p] += stepOf(l) * (gravity - settings_.damping * state.velocities[p]);
        if (withStages_) pushByStages(state, stages, shortest);
        for (int l = first; l <= highest; ++l) push(levels_[l], state, stepOf(l));
        if (withStages_) from = state.positions;
        for (int l = first; l <= highest; ++l)
            for (const int p : levels_[l].drifting) state.positions[p] += stepOf(l) * state.velocities[p];
        if (!withStages_) continue;
        eliminated().place(state.positions);
        hold(from, state, shortest, stages);
    }
    eliminated().place(state.positions);
    eliminated().place(state.velocities);
    return StepReport{.parts = ticks, .limit = limit};
}

} // namespace toile::dynamics
