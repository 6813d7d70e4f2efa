// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "UiFixtures.h"
#include "core/io/ToileFile.h"
#include "ui/workbench/Workbench.h"

#include <atomic>

/// Parts of a workbench that only remember what they were told.
namespace toile::ui {

/// Remembers what it was told; frames are made by the test.
struct FakeSimulation : Simulation {
    struct Log {
        std::vector<std::uint64_t> generations;
        std::optional<simulation::Frame> frame;
        bool playing = false, busy = false;
        bool finishes = false;
        dynamics::Method method = dynamics::Method::xpbd;
        int resets = 0;
        std::vector<simulation::Grip> grips;
        std::optional<simulation::Checkpoint> resumed;
        std::shared_ptr<const geometry::VertexMotion> motion;
    };
    explicit FakeSimulation(Log& l) : log(l) {}
    void setScene(simulation::Scene, std::uint64_t generation) override { log.generations.push_back(generation); }
    void play() override { log.playing = true; }
    void pause() override { log.playing = false; }
    void step() override {}
    void reset() override { ++log.resets; }
    void finishAtRest(bool wanted) override { log.finishes = wanted; }
    void drapeWith(dynamics::Method method) override { log.method = method; }
    void hold(std::vector<simulation::Grip> grips) override { log.grips = std::move(grips); }
    void moveBody(std::shared_ptr<const geometry::VertexMotion> motion) override { log.motion = std::move(motion); }
    void askForCheckpoint() override {}
    std::optional<Result<simulation::Checkpoint>> takeCheckpoint() override { return {}; }
    void resume(simulation::Checkpoint checkpoint) override { log.resumed = std::move(checkpoint); }
    bool isPlaying() const override { return log.playing; }
    bool isBusy() const override { return log.busy; }
    std::optional<simulation::Frame> takeFrame() override { return std::exchange(log.frame, std::nullopt); }
    Log& log;
};

struct Fixture {
    FakeSimulation::Log log;
    std::atomic<int> meshed{0};
    WorkbenchParts parts() {
        WorkbenchParts result;
        result.read = io::readDocument;
        result.write = [](const std::string& file, const document::Document& d) { return io::writeToile(d, file); };
        result.mesh = [this, mesh = std::make_shared<meshing::GarmentMesh>()](
                          const pattern::Pattern& pattern) -> Result<const meshing::GarmentMesh*> {
            ++meshed;
            mesh->pieces.resize(pattern.pieces.size());
            return mesh.get();
        };
        result.simulation = std::make_unique<FakeSimulation>(log);
        result.recoveryDelay = std::chrono::milliseconds(1);
        return result;
    }
};

inline simulation::Frame frameOf(std::uint64_t generation) {
    simulation::Frame frame;
    frame.generation = generation;
    frame.positions = {{0, 0, 0}};
    return frame;
}

} // namespace toile::ui
