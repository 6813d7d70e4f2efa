// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/batch/Opening.h"
#include "core/dynamics/Xpbd.h"
#include "core/io/DocumentFile.h"
#include "core/simulation/BodyContactOf.h"
#include "core/simulation/Simulation.h"
#include "core/study/Calibration.h"

#include <algorithm>
#include <benchmark/benchmark.h>
#include <cstdint>
#include <cstdlib>

/// Times of position-based substeps: the pieces of the blouse, let go round the body, by the spacing of their mesh.
/// `cloth_ms` and `contact_ms` are the least of all frames, for one substep; `cloth_ns` and `contact_ns` the same for a
/// particle. The label is a hash of the positions after the first frames: a faster wrong answer is seen.
namespace toile::bench {
namespace {

/// A stage, and how long it took.
struct Timed final : dynamics::Stage {
    explicit Timed(dynamics::Stage& timed) : stage(timed) {}

    std::string_view name() const override { return stage.name(); }
    std::size_t bytes() const override { return stage.bytes(); }
    void beginStep(const dynamics::ParticleState& state, double duration) override { stage.beginStep(state, duration); }
    void project(dynamics::Substep& substep) override {
        const double start = study::threadSeconds();
        stage.project(substep);
        seconds += study::threadSeconds() - start;
    }
    void beginIteration(std::span<const Vec3>) override {}
    double energy(std::span<const Vec3>) const override { return 0; }
    void addForces(std::span<const Vec3>, std::span<Vec3>) const override {}
    void addHessian(std::span<const Vec3>, dynamics::HessianSink&) const override {}

    dynamics::Stage& stage;
    double seconds = 0;
};

simulation::Simulation blouse(double spacing) {
    const std::string file = TOILE_SAMPLES "/blouse.toile";
    const auto read = io::readDocument(file);
    if (!read) std::abort();
    auto opened = batch::openScene(read->document, file);
    if (!opened) std::abort();
    auto made = simulation::Simulation::create(std::move(opened->scene), {.spacing = spacing});
    if (!made) std::abort();
    return std::move(*made);
}

/// FNV-1a over the bits of all positions.
std::uint64_t hashOf(const std::vector<Vec3>& positions) {
    std::uint64_t hash = 14695981039346656037ULL;
    const auto* bytes = reinterpret_cast<const unsigned char*>(positions.data());
    for (std::size_t i = 0; i < positions.size() * sizeof(Vec3); ++i) hash = (hash ^ bytes[i]) * 1099511628211ULL;
    return hash;
}

void substeps(benchmark::State& run) {
    constexpr int inFrame = 20, framesBefore = 10;
    const simulation::Simulation garment = blouse(1e-4 * static_cast<double>(run.range(0)));
    const cloth::ClothModel& model = garment.garment().model;
    dynamics::ParticleState state = garment.state();
    const auto contact =
        simulation::bodyContactOf(garment.scene(), garment.garment(), *garment.body(), state.positions);
    Timed timed(*contact);
    dynamics::Stage* stages[] = {&timed};
    dynamics::Xpbd xpbd(model, {.damping = 3, .speedLimit = 10});
    const auto frame = [&] {
        if (!xpbd.step(state, 1.0 / 60, inFrame, {0, -9.81, 0}, stages)) std::abort();
    };
    for (int i = 0; i < framesBefore; ++i) frame();
    char hash[20];
    std::snprintf(hash, sizeof hash, "%016llx", static_cast<unsigned long long>(hashOf(state.positions)));
    double cloth = 1e9, contacts = 1e9;
    for (auto _ : run) {
        timed.seconds = 0;
        const double start = study::threadSeconds();
        frame();
        const double all = study::threadSeconds() - start;
        run.SetIterationTime(all);
        cloth = std::min(cloth, (all - timed.seconds) / inFrame);
        contacts = std::min(contacts, timed.seconds / inFrame);
    }
    run.SetLabel(hash);
    const double particles = model.particleCount();
    run.counters["particles"] = particles;
    run.counters["cloth_ms"] = 1e3 * cloth;
    run.counters["contact_ms"] = 1e3 * contacts;
    run.counters["cloth_ns"] = 1e9 * cloth / particles;
    run.counters["contact_ns"] = 1e9 * contacts / particles;
}

BENCHMARK(substeps)
    ->ArgName("tenths_of_mm")
    ->Arg(200)
    ->Arg(100)
    ->Arg(70)
    ->Arg(31)
    ->UseManualTime()
    ->Iterations(20)
    ->Unit(benchmark::kMillisecond);

} // namespace
} // namespace toile::bench
