// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/dynamics/FrequencyBound.h"
#include "core/dynamics/Integrator.h"

#include <cstdint>
#include <vector>

namespace toile::dynamics {

struct SubcycledEulerSettings {
    double damping = 0;  ///< mass-proportional [1/s]
    double safety = 0.9; ///< of the limit 2/ω of each particle that steps use [–]
    int levels = 7;      ///< at most; steps of level m are 2^m times shorter than those of level 0
};

/// Symplectic Euler with a step for each part of the cloth: fine regions take 2^m steps while coarse ones take one, as
/// the 2002 paper moves its sub-regions within a step of the main region. An element pushes as often as its stiffest
/// particle needs, with an impulse for the whole of its step, so that momentum is kept. Stages push with the shortest
/// step: a stiff one that pushed less often would stir up the waves of the fine parts. First order. Ref: Tuckerman,
/// Berne, Martyna 1992 (impulses of several lengths)
class SubcycledEuler final : public Integrator {
public:
    explicit SubcycledEuler(const cloth::ClothModel& model, SubcycledEulerSettings settings = {});

    [[nodiscard]] std::string_view name() const override { return "subcycled-euler"; }
    [[nodiscard]] std::size_t bytes() const override;
    /// Of the level with the shortest steps.
    [[nodiscard]] double stepLimit(std::span<const Vec3> positions = {},
                                   std::span<Stage* const> stages = {}) const override;

    /// How often elements have pushed so far: what the method saves.
    [[nodiscard]] std::int64_t elementPushes() const { return elementPushes_; }

protected:
    [[nodiscard]] Result<StepReport> advance(ParticleState& state, double duration, const Vec3& gravity,
                                             std::span<Stage* const> stages, std::stop_token stop) override;

private:
    /// What moves with one step.
    struct Level {
        cloth::ClothModel elements;
        std::int64_t count = 0;    ///< of elements
        std::vector<int> joined;   ///< particles, by the elements
        std::vector<int> slaves;   ///< of them; indices into the model's
        std::vector<int> drifting; ///< free particles that no element of a higher level joins
    };

    /// Parts of a step that each particle needs; a slave as many as its masters.
    [[nodiscard]] Result<std::vector<int>> partsFor(double duration, std::span<const Vec3> positions,
                                                    std::span<Stage* const> stages) const;
    void sortInto(std::span<const int> partsNeeded, bool allDriftTogether);
    void push(const Level& level, ParticleState& state, double h);
    void pushByStages(ParticleState& state, std::span<Stage* const> stages, double h);
    void give(const Vec3& impulse, int particle, std::span<Vec3> velocities) const;

    SubcycledEulerSettings settings_;
    FrequencyBound bound_;
    std::vector<int> partsNeeded_; ///< that the levels were made for
    bool withStages_ = false;      ///< they push any particle at any time
    std::vector<Level> levels_;    ///< made by the first step
    int parts_ = 1;                ///< of a step, by level 0
    std::int64_t elementPushes_ = 0;
    std::vector<Vec3> forces_; ///< zero but during a push
    std::vector<Vec3> stageForces_;
};

} // namespace toile::dynamics
