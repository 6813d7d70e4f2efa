// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/Runner.h"
#include "ui/workbench/Simulation.h"

namespace toile::ui {

/// The real simulation, on the runner's thread.
class RunnerSimulation : public Simulation {
public:
    void setScene(simulation::Scene scene, std::uint64_t generation) override {
        runner_.setScene(std::move(scene), generation);
    }
    void play() override { runner_.play(); }
    void pause() override { runner_.pause(); }
    void step() override { runner_.step(); }
    void reset() override { runner_.reset(); }
    void finishAtRest(bool wanted) override { runner_.finishAtRest(wanted); }
    void drapeWith(dynamics::Method method) override { runner_.drapeWith(method); }
    void hold(std::vector<simulation::Grip> grips) override { runner_.hold(std::move(grips)); }
    void moveBody(std::shared_ptr<const geometry::VertexMotion> motion) override {
        runner_.moveBody(std::move(motion));
    }
    void askForCheckpoint() override { runner_.askForCheckpoint(); }
    [[nodiscard]] std::optional<Result<simulation::Checkpoint>> takeCheckpoint() override {
        return runner_.takeCheckpoint();
    }
    void resume(simulation::Checkpoint checkpoint) override { runner_.resume(std::move(checkpoint)); }
    [[nodiscard]] bool isPlaying() const override { return runner_.isPlaying(); }
    [[nodiscard]] bool isBusy() const override { return runner_.isBusy(); }
    [[nodiscard]] std::optional<simulation::Frame> takeFrame() override { return runner_.takeFrame(); }

private:
    simulation::Runner runner_;
};

} // namespace toile::ui
