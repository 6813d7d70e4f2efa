// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/lean/Lean.h"

#include "core/base/Contracts.h"
#include "core/simulation/Checkpoint.h"
#include "core/simulation/Inspect.h"
#include "core/study/Calibration.h"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace toile::study::lean {
namespace {

using simulation::Simulation;

constexpr int warmUp = 3;            ///< frame steps
constexpr double sameWithin = 1e-12; ///< positions that are the same but for rounding [m]

template <class Element>
std::size_t held(const std::vector<Element>& elements) {
    return elements.capacity() * sizeof(Element);
}

/// Bytes of the cloth's elements of this name; nothing for another name.
std::optional<std::size_t> elementBytes(const cloth::ClothModel& model, std::string_view part) {
    if (part == "slaves") return held(model.slaves);
    if (part == "pins") return held(model.pinned);
    if (part == "springs") return held(model.structural) + held(model.shear);
    if (part == "elastics") return held(model.elastics);
    if (part == "membrane cells") return held(model.cells);
    if (part == "membrane triangles") return held(model.triangles);
    if (part == "bending") return held(model.bending);
    if (part == "twist") return held(model.twist);
    if (part == "seam hinges" || part == "folds") return held(model.hinges);
    return std::nullopt;
}

/// What the plan does not leave out is there.
bool isThere(const Simulation& simulation, std::string_view part) {
    return std::ranges::find(simulation.plan().leftOut(), part, &simulation::LeftOut::stage) ==
           simulation.plan().leftOut().end();
}

std::size_t bytesOf(const Simulation& simulation, std::string_view part) {
    if (const auto* stage = simulation.plan().find(part)) return stage->bytes();
    return elementBytes(simulation.garment().model, part).value_or(0);
}

SceneHashes hashesOf(const Simulation& simulation) {
    return {simulation::fingerprintOf(simulation.scene(), simulation.garment()), simulation::resultHash(simulation)};
}

Result<Simulation> madeFor(const Variant& variant) {
    auto simulation = Simulation::create(variant.scene);
    if (!simulation) return simulation;
    if (!variant.letsGo.empty()) {
        simulation->hold(variant.letsGo);
        simulation->hold({});
    }
    if (!variant.holds.empty()) simulation->hold(variant.holds);
    if (!variant.forced.empty()) simulation->force(variant.forced);
    if (variant.motion)
        if (auto moves = simulation->moveBody(variant.motion); !moves) return tl::unexpected(moves.error());
    return simulation;
}

Result<void> stepped(Simulation& simulation, int frames, std::stop_token stop) {
    for (int frame = 0; frame < frames; ++frame) {
        if (stop.stop_requested()) return fail(ErrorCode::cancelled, "It was stopped.");
        if (auto done = simulation.advance(stop); !done) return done;
    }
    return {};
}

/// One run; its time, of a single repetition, in seconds.
Result<Taken> taken(const Variant& variant, std::string_view part, const LeanSettings& settings,
                    std::vector<double>& seconds, std::stop_token stop) {
    Taken taken;
    const HeapCount before = heapTaken();
    auto simulation = madeFor(variant);
    if (!simulation) return tl::unexpected(simulation.error());
    taken.building = heapTaken() - before;
    taken.hashes = hashesOf(*simulation);
    if (auto done = stepped(*simulation, warmUp, stop); !done) return tl::unexpected(done.error());
    const HeapCount warm = heapTaken();
    const double start = threadSeconds();
    if (auto done = countedSteps(*simulation, settings.frames, stop); !done) return tl::unexpected(done.error());
    seconds.push_back((threadSeconds() - start) / settings.frames);
    taken.stepping = heapTaken() - warm;
    taken.frames = settings.frames;
    taken.particles = simulation->garment().particles.particleCount;
    taken.substeps = simulation->substeps();
    for (const auto* stage : simulation->plan().stages()) taken.stages.emplace_back(stage->name());
    taken.partIsThere = variant.forced.empty() ? isThere(*simulation, part)
                                               : std::ranges::all_of(variant.forced, [&](const std::string& stage) {
                                                     return simulation->plan().find(stage) != nullptr;
                                                 });
    taken.partBytes = bytesOf(*simulation, part);
    taken.positions = simulation->nodePositions();
    taken.hash = simulation::resultHash(*simulation);
    return taken;
}

std::optional<double> largestDifference(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
    if (a.size() != b.size()) return std::nullopt;
    double largest = 0;
    for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, geometry::distance(a[i], b[i]));
    return largest;
}

std::string whyNotLeftOut(const Taken& taken, const Taken* like) {
    if (taken.partIsThere) return "It is in the plan.";
    if (taken.partBytes > 0) return fmt::format("It holds {} bytes.", taken.partBytes);
    if (!like) return "";
    if (taken.stages != like->stages) return fmt::format("The stages are {}.", fmt::join(taken.stages, ", "));
    if (taken.stepping != like->stepping)
        return fmt::format("Its steps ask for {} blocks of {} bytes, not {} of {}.", taken.stepping.blocks,
                           taken.stepping.bytes, like->stepping.blocks, like->stepping.bytes);
    if (taken.hash != like->hash) return "Its positions are others than without it.";
    return "";
}

std::string whyNotForced(const Row& row, const std::string& part) {
    if (!part.empty() && !row.taken.partIsThere) return "It was not built.";
    if (!row.difference) return "Its mesh is another than without it.";
    if (*row.difference > sameWithin)
        return fmt::format("Leaving it out moves the cloth by {:.2g} m.", *row.difference);
    return "";
}

std::string whyNotInUse(const Row& row, const std::string& part, const Taken* like) {
    if (!part.empty() && !row.taken.partIsThere) return "It is not in the plan.";
    return like && like->hash == row.taken.hash ? "It has no effect." : "";
}

void judge(FeatureResult& result, const Feature& feature) {
    for (std::size_t i = 0; i < result.rows.size(); ++i) {
        Row& row = result.rows[i];
        const int other = feature.variants[i].like;
        const Taken* like = other < 0 ? nullptr : &result.rows[static_cast<std::size_t>(other)].taken;
        if (like) row.difference = largestDifference(row.taken.positions, like->positions);
        if (row.role == Role::forced) row.why = whyNotForced(row, feature.part);
        else if (row.role == Role::inUse) row.why = whyNotInUse(row, feature.part, like);
        else if (!feature.part.empty()) row.why = whyNotLeftOut(row.taken, like);
    }
}

} // namespace

[[gnu::noinline]] Result<void> countedSteps(Simulation& simulation, int frames, std::stop_token stop) {
    return stepped(simulation, frames, std::move(stop));
}

Result<SceneHashes> hashesOf(const simulation::Scene& scene) {
    const auto simulation = Simulation::create(scene);
    if (!simulation) return tl::unexpected(simulation.error());
    return hashesOf(*simulation);
}

Result<FeatureResult> studied(const Feature& feature, const LeanSettings& settings, std::stop_token stop,
                              const Progress& progress) {
    expects(settings.frames > 0 && settings.repetitions > 0, "something is run");
    FeatureResult result{feature.name, feature.part, {}};
    for (const Variant& variant : feature.variants) result.rows.push_back({variant.role, variant.what});
    const std::size_t count = feature.variants.size();
    std::vector<std::vector<double>> seconds(count);
    const auto runOne = [&](std::size_t i, int repetition) -> Result<void> {
        report(progress, double(repetition * count + i) / double(settings.repetitions * count),
               fmt::format("{}: {}", feature.name, feature.variants[i].what));
        auto run = taken(feature.variants[i], feature.part, settings, seconds[i], stop);
        if (!run) return tl::unexpected(run.error());
        const HeapCount before = result.rows[i].taken.building;
        result.rows[i].taken = std::move(*run);
        if (repetition > 0 && before.blocks < result.rows[i].taken.building.blocks)
            result.rows[i].taken.building = before; // which thread meshes which piece is chance
        return {};
    };
    if (auto done = inTurns(count, settings.repetitions, runOne); !done) return tl::unexpected(done.error());
    for (std::size_t i = 0; i < count; ++i) result.rows[i].taken.frame = runTimeOf(seconds[i]);
    judge(result, feature);
    return result;
}

void addInstructions(FeatureResult& result, const Feature& feature, std::span<const double> instructions) {
    constexpr double spread = 1e-3;
    expects(instructions.size() == result.rows.size(), "a count for each variant");
    for (std::size_t i = 0; i < result.rows.size(); ++i)
        result.rows[i].taken.instructions = instructions[i] / result.rows[i].taken.frames;
    for (std::size_t i = 0; i < result.rows.size(); ++i) {
        Row& row = result.rows[i];
        if (row.role != Role::unused || feature.variants[i].like < 0 || !row.why.empty()) continue;
        const double with = *row.taken.instructions,
                     without = *result.rows[static_cast<std::size_t>(feature.variants[i].like)].taken.instructions;
        if (with > (1 + spread) * without)
            row.why = fmt::format("Its steps take {:.0f} instructions, not {:.0f}.", with, without);
    }
}

bool passes(const FeatureResult& result) {
    return std::ranges::all_of(result.rows, [](const Row& row) { return row.why.empty(); });
}

} // namespace toile::study::lean
