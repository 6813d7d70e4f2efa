// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Progress.h"
#include "core/base/heap/HeapCount.h"
#include "core/simulation/Simulation.h"
#include "core/study/Repetitions.h"
#include "core/study/lean/Features.h"

#include <span>
#include <stop_token>

namespace toile::study::lean {

struct LeanSettings {
    int frames = 30; ///< frame steps that are counted, after three that are not: seams merge in them, arrays are made
    int repetitions = 5;
    bool counted = false; ///< the instructions are counted, too; addInstructions()
};

/// What a scene is known by.
struct SceneHashes {
    std::string scene; ///< fingerprint of mesh, cloth, body and settings
    std::string start; ///< of the positions before the first step
};
/// Errors: what its simulation refuses.
[[nodiscard]] Result<SceneHashes> hashesOf(const simulation::Scene& scene);

/// What a run of a variant takes.
struct Taken {
    SceneHashes hashes;
    int particles = 0, substeps = 0, frames = 0;
    std::vector<std::string> stages; ///< of the plan at the end, in order
    bool partIsThere = false;
    std::size_t partBytes = 0;    ///< that the part holds
    HeapCount building, stepping; ///< heap asked for until the first step, the least of all repetitions; in all frames
                                  ///< that are counted
    RunTime frame;                ///< CPU time of a frame step
    std::optional<double> instructions; ///< of a frame step
    std::vector<Vec3> positions;        ///< of all nodes at the end [m]
    std::string hash;                   ///< of them
    [[nodiscard]] double blocksPerFrame() const { return static_cast<double>(stepping.blocks) / frames; }
};

struct Row {
    Role role = Role::absent;
    std::string what;
    Taken taken;
    std::optional<double> difference; ///< largest of a node to the variant it is compared with,
                                      ///< if that has the same mesh [m]
    std::string why;                  ///< it fails; empty = it passes
};

struct FeatureResult {
    std::string name, part;
    std::vector<Row> rows;
};

/// Runs all variants of a feature in turns and judges them:
///
/// absent, unused: the part is not there and holds no byte. unused: stages, allocations of every step and positions
/// are those of the variant without it, bit by bit. forced: the part is there, and positions are the same, or nearer
/// than 1e-12 m. in use: the part is there, and positions are others.
/// Errors: what the scene's simulation refuses, cancelled.
[[nodiscard]] Result<FeatureResult> studied(const Feature& feature, const LeanSettings& settings,
                                            std::stop_token stop = {}, const Progress& progress = {});

/// Adds what a profiler counted in the frames of each variant, in their order. What is unused must not cost more than
/// 0.1 % of the instructions without it: malloc's share depends on addresses.
void addInstructions(FeatureResult& result, const Feature& feature, std::span<const double> instructions);

/// The frame steps that are counted: a function of its own, which a profiler finds by its name.
[[nodiscard]] Result<void> countedSteps(simulation::Simulation& simulation, int frames, std::stop_token stop);
inline constexpr const char* countedStepsName =
    "toile::study::lean::countedSteps(toile::simulation::Simulation&, int, std::stop_token)";

[[nodiscard]] bool passes(const FeatureResult& result);

} // namespace toile::study::lean
