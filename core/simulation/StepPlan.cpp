// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/StepPlan.h"

#include "core/base/WallTime.h"

#include <chrono>

namespace toile::simulation {

/// Hands every call on to a stage and adds up the time it takes.
class StepPlan::Timed final : public dynamics::Stage {
public:
    explicit Timed(std::unique_ptr<dynamics::Stage> stage) : stage_(std::move(stage)) {}

    [[nodiscard]] dynamics::Stage& stage() const { return *stage_; }
    [[nodiscard]] double seconds() const { return seconds_; }
    void count(bool counts) { counts_ = counts; }

    [[nodiscard]] std::string_view name() const override { return stage_->name(); }
    [[nodiscard]] std::size_t bytes() const override { return stage_->bytes(); }
    [[nodiscard]] int heldBack() const override { return stage_->heldBack(); }
    void beginStep(const dynamics::ParticleState& state, double duration) override {
        timed([&] { stage_->beginStep(state, duration); });
    }
    void project(dynamics::Substep& substep) override {
        timed([&] { stage_->project(substep); });
    }
    void take(const dynamics::Motion& motion) override { stage_->take(motion); }
    [[nodiscard]] bool isFromOutside() const override { return stage_->isFromOutside(); }
    [[nodiscard]] bool isBeforeSweep() const override { return stage_->isBeforeSweep(); }
    void fixFriction(std::span<const Vec3> positions) override {
        timed([&] { stage_->fixFriction(positions); });
    }
    void easeFriction(double part) override { stage_->easeFriction(part); }
    void beginIteration(std::span<const Vec3> positions) override {
        timed([&] { stage_->beginIteration(positions); });
    }
    [[nodiscard]] double energy(std::span<const Vec3> positions) const override { return stage_->energy(positions); }
    void addForces(std::span<const Vec3> positions, std::span<Vec3> forces) const override {
        stage_->addForces(positions, forces);
    }
    void addHessian(std::span<const Vec3> positions, dynamics::HessianSink& sink) const override {
        stage_->addHessian(positions, sink);
    }
    void hold(std::span<const Vec3> from, std::span<Vec3> positions) override {
        timed([&] { stage_->hold(from, positions); });
    }
    [[nodiscard]] double largestFrequencySquared() const override { return stage_->largestFrequencySquared(); }

private:
    template <class Work>
    void timed(Work work) {
        if (!counts_) return work();
        const auto start = std::chrono::steady_clock::now();
        work();
        seconds_ += secondsSince(start);
    }

    std::unique_ptr<dynamics::Stage> stage_;
    double seconds_ = 0;
    bool counts_ = true;
};

StepPlan::StepPlan() = default;
StepPlan::StepPlan(StepPlan&&) noexcept = default;
StepPlan& StepPlan::operator=(StepPlan&&) noexcept = default;
StepPlan::~StepPlan() = default;

void StepPlan::add(std::unique_ptr<dynamics::Stage> stage) {
    owned_.push_back(std::make_unique<Timed>(std::move(stage)));
    order_.push_back(owned_.back().get());
}

void StepPlan::leaveOut(std::string stage, std::string why) {
    leftOut_.push_back({std::move(stage), std::move(why)});
}

dynamics::Stage* StepPlan::find(std::string_view name) const {
    for (const auto& timed : owned_)
        if (timed->name() == name) return &timed->stage();
    return nullptr;
}

std::vector<StepPlan::StageCost> StepPlan::costs() const {
    std::vector<StageCost> costs;
    for (const auto& timed : owned_)
        costs.push_back({std::string(timed->name()), timed->seconds(), timed->bytes(), timed->heldBack()});
    return costs;
}

StepPlan::OffTheClock::OffTheClock(StepPlan& plan) : plan_(plan) {
    for (const auto& timed : plan_.owned_) timed->count(false);
}

StepPlan::OffTheClock::~OffTheClock() {
    for (const auto& timed : plan_.owned_) timed->count(true);
}

} // namespace toile::simulation
