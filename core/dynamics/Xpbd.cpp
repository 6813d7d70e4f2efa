// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/dynamics/Xpbd.h"

#include "core/base/Contracts.h"
#include "core/dynamics/CoarseLevels.h"
#include "core/dynamics/Eliminated.h"
#include "core/dynamics/XpbdSweep.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <optional>
#include <utility>

namespace toile::dynamics {
namespace {

/// Of which a thread's part holds at least so many: it takes some microseconds.
constexpr int leastParticles = 4000;

} // namespace

struct Xpbd::Data {
    Data(const cloth::ClothModel& m, XpbdSettings s, std::vector<double> i)
        : model(m), settings(s), eliminated(m), inertia(std::move(i)), inverseMass(eliminated.inverseMass(inertia)) {}

    void compileFor(double h);
    void predict(ParticleState& state, double h, const Vec3& gravity);
    void runStages(ParticleState& state, double h, double time, std::span<Stage* const> stages, bool beforeSweep);
    void handSlavesToMasters(std::span<Vec3> positions) const;
    void updateVelocities(ParticleState& state, double h) const;

    const cloth::ClothModel& model;
    XpbdSettings settings;
    Eliminated eliminated;
    std::vector<double> inertia, inverseMass;
    std::vector<Vec3> previous, slavesBefore;
    std::optional<XpbdSweep> sweep;
    CoarseLevels* levels = nullptr;
    Team* team = nullptr;
    double compiledStep = 0;
};

Xpbd::Xpbd(const cloth::ClothModel& model, XpbdSettings settings, std::vector<double> inertia)
    : data_(std::make_unique<Data>(model, settings, std::move(inertia))) {
    expects(data_->inertia.empty() || data_->inertia.size() == model.mass.size(), "one inertia per particle");
}
Xpbd::Xpbd(Xpbd&&) noexcept = default;
Xpbd& Xpbd::operator=(Xpbd&&) noexcept = default;
Xpbd::~Xpbd() = default;

Result<void> Xpbd::step(ParticleState& state, double duration, int substeps, const Vec3& gravity,
                        std::span<Stage* const> stages, std::stop_token stop) {
    Data& d = *data_;
    expects(state.positions.size() == d.model.mass.size(), "one position per particle");
    expects(duration > 0 && substeps > 0, "a step takes time");
    if (d.eliminated.massless() >= 0)
        return fail(ErrorCode::invalidInput, fmt::format("Particle {} has no mass.", d.eliminated.massless()));
    state.velocities.resize(state.positions.size());
    const ParticleState start = state;
    const double h = duration / substeps;
    d.compileFor(h);
    for (Stage* stage : stages) stage->beginStep(state, duration);
    if (d.levels) d.levels->beginStep(state.positions, h, d.settings.stiffnessCap);
    for (int s = 1; s <= substeps; ++s) {
        if (stop.stop_requested()) {
            state = start;
            return fail(ErrorCode::cancelled, "The step was stopped.");
        }
        d.predict(state, h, gravity);
        d.runStages(state, h, start.time + s * h, stages, true);
        d.sweep->apply(state.positions, d.team);
        if (d.levels) d.levels->correct(state.positions, d.team);
        d.eliminated.place(state.positions);
        d.runStages(state, h, start.time + s * h, stages, false);
        d.updateVelocities(state, h);
    }
    state.time = start.time + duration;
    for (std::size_t p = 0; p < state.positions.size(); ++p)
        if (!isFinite(state.positions[p]) || !isFinite(state.velocities[p])) {
            state = start;
            return fail(
                ErrorCode::notConverged,
                fmt::format("The position of particle {} was no number after the step from {:.4f} s.", p, start.time));
        }
    return {};
}

void Xpbd::Data::compileFor(double h) {
    if (sweep && std::abs(h - compiledStep) <= 1e-12 * h) return;
    sweep.emplace(model, eliminated, inverseMass, h, settings.stiffnessCap);
    compiledStep = h;
}

void Xpbd::Data::predict(ParticleState& state, double h, const Vec3& gravity) {
    previous.resize(state.positions.size());
    const double limit = settings.speedLimit;
    const std::span<const int> free = eliminated.free();
    inParts(team, static_cast<int>(previous.size()), leastParticles, [&](int begin, int end) {
        std::copy(state.positions.begin() + begin, state.positions.begin() + end, previous.begin() + begin);
    });
    inParts(team, static_cast<int>(free.size()), leastParticles, [&](int begin, int end) {
        for (const int p : free.subspan(begin, end - begin)) {
            Vec3& v = state.velocities[p];
            v += (inertia.empty() ? h : h / inertia[p]) * gravity;
            if (limit > 0 && squaredLength(v) > limit * limit) v *= limit / geometry::length(v);
            state.positions[p] += h * v;
        }
    });
    eliminated.place(state.positions);
}

/// Those from outside act with gravity, before the sweep: what answers them is then the cloth's true stiffness. So does
/// what damps the way that is foreseen.
void Xpbd::Data::runStages(ParticleState& state, double h, double time, std::span<Stage* const> stages,
                           bool beforeSweep) {
    Substep substep{state.positions, previous, inverseMass, h, time, team};
    for (Stage* stage : stages) {
        if (stage->isBeforeSweep() != beforeSweep) continue;
        slavesBefore.clear();
        for (int s : eliminated.slaves()) slavesBefore.push_back(state.positions[model.slaves[s].particle]);
        stage->project(substep);
        handSlavesToMasters(state.positions);
    }
}

/// A slave that a stage has moved moves its masters so that it stays where it was put, by the least weighted motion.
/// One after the other: neighbours share masters.
void Xpbd::Data::handSlavesToMasters(std::span<Vec3> positions) const {
    for (std::size_t i = 0; i < slavesBefore.size(); ++i) {
        const cloth::Slave& slave = model.slaves[eliminated.slaves()[i]];
        const double w = inverseMass[slave.particle];
        if (w == 0 || positions[slave.particle] == slavesBefore[i]) continue;
        Vec3 place;
        for (const auto& [master, weight] : slave.masters) place += weight * positions[master];
        const Vec3 move = positions[slave.particle] - place;
        for (const auto& [master, weight] : slave.masters)
            positions[master] += (weight * inverseMass[master] / w) * move;
    }
    eliminated.place(positions);
}

void Xpbd::Data::updateVelocities(ParticleState& state, double h) const {
    const double factor = 1 / (h * (1 + settings.damping * h));
    inParts(team, static_cast<int>(previous.size()), leastParticles, [&](int begin, int end) {
        for (int p = begin; p < end; ++p) state.velocities[p] = factor * (state.positions[p] - previous[p]);
    });
}

void Xpbd::workWith(Team* team) {
    data_->team = team;
}

CoarseLevels* Xpbd::correctBy(CoarseLevels* levels) {
    return std::exchange(data_->levels, levels);
}

void Xpbd::setSettings(XpbdSettings settings) {
    if (settings.stiffnessCap != data_->settings.stiffnessCap) data_->sweep.reset();
    data_->settings = settings;
}

std::span<const double> Xpbd::inverseMass() const {
    return data_->inverseMass;
}

std::size_t Xpbd::bytes() const {
    return sizeof(Data) + (data_->inertia.capacity() + data_->inverseMass.capacity()) * sizeof(double) +
           data_->previous.capacity() * sizeof(Vec3) + (data_->sweep ? data_->sweep->bytes() : 0);
}

int substepsFor(double frameStep, int springsOnLine, double gravity, double error) {
    // e ≈ ½·c·g·h²·n² with c = 1.6, the middle of what was measured; the stiffness cap costs 1.4 times the substeps.
    constexpr double c = 1.6, capCost = 1.4;
    const double substeps = capCost * frameStep * springsOnLine * std::sqrt(c * std::abs(gravity) / (2 * error));
    return std::max(1, static_cast<int>(std::ceil(substeps)));
}

int springsOnLongestLine(const cloth::ClothModel& model) {
    const int n = model.particleCount();
    std::vector<std::vector<int>> neighbours(n);
    const auto join = [&](int a, int b) {
        neighbours[a].push_back(b);
        neighbours[b].push_back(a);
    };
    for (const auto& s : model.structural) join(s.a, s.b);
    for (const auto& t : model.triangles)
        for (int i = 0; i < 3; ++i) join(t.particles[i], t.particles[(i + 1) % 3]);
    for (const auto& c : model.cells)
        for (int i = 0; i < 4; ++i) join(c.particles[i], c.particles[(i + 1) % 4]);
    for (const auto& slave : model.slaves)
        for (const auto& [master, weight] : slave.masters) join(slave.particle, master);

    std::vector<int> distance(n, -1), queue;
    const auto flood = [&](std::vector<int> from) { // breadth first; returns the last one reached
        queue = std::move(from);
        for (int p : queue) distance[p] = 0;
        for (std::size_t i = 0; i < queue.size(); ++i)
            for (int q : neighbours[queue[i]])
                if (distance[q] < 0) {
                    distance[q] = distance[queue[i]] + 1;
                    queue.push_back(q);
                }
        return queue.back();
    };
    int longest = 1;
    if (!model.pinned.empty()) longest = std::max(longest, distance[flood(model.pinned)]);
    for (int p = 0; p < n; ++p) {
        if (distance[p] >= 0) continue;
        const int end = flood({p});
        const std::vector<int> part = queue;
        for (int q : part) distance[q] = -1;
        longest = std::max(longest, (distance[flood({end})] + 1) / 2);
    }
    return longest;
}

} // namespace toile::dynamics
