// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Team.h"
#include "core/cloth/HessianSink.h"
#include "core/geometry/Vec.h"

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

namespace toile::dynamics {

/// All that moves.
struct ParticleState {
    std::vector<Vec3> positions;  ///< [m]
    std::vector<Vec3> velocities; ///< [m/s]
    double time = 0;              ///< [s]
};

/// What a stage sees of a position-based substep. Stages change positions only; velocities follow from them.
struct Substep {
    std::span<Vec3> positions;           ///< being solved
    std::span<const Vec3> previous;      ///< at the start of the substep
    std::span<const double> inverseMass; ///< [1/kg]; 0 = pinned. A slave's is that of its masters, Σ w²/m
    double duration = 0;                 ///< h [s]
    double time = 0;                     ///< at the end of the substep [s]
    Team* team = nullptr;                ///< to share work with; null = alone. Results are the same to the bit
};

/// How fast particles are, for forces that depend on it. Nothing given: statics, they rest.
struct Motion {
    std::span<const Vec3> velocities; ///< of explicit methods; with from, those about which forces are linear [m/s]
    std::span<const Vec3> from;       ///< of implicit methods: who is at x is as fast as (x − from)/span [m]
    double span = 0;                  ///< of time, in which a force changes velocities [s]
};

/// Collects 3×3 blocks of ∂²E/∂x∂x. Blocks are row-major; (i, j) and (j, i) are both added by the caller.
using cloth::HessianSink;

/// A part of the step beside the cloth's own forces: a seam being closed, contact with the body, a hand that pulls.
/// A stage exists only when the scene needs it, and owns its data.
class Stage {
public:
    virtual ~Stage() = default;
    [[nodiscard]] virtual std::string_view name() const = 0;
    /// Memory this stage holds.
    [[nodiscard]] virtual std::size_t bytes() const = 0;
    /// Substeps so far in which particles did not go as far as they should have, for want of memory.
    [[nodiscard]] virtual int heldBack() const { return 0; }

    /// Once before the substeps of a frame step of the given duration [s]: broad phases, targets.
    virtual void beginStep(const ParticleState& state, double duration) = 0;
    /// Once in every position-based substep, after the cloth's own sweep; before it if the stage is from outside.
    virtual void project(Substep& substep) = 0;

    /// Whether what energy() gives is not stored but taken within the time of the motion.
    [[nodiscard]] virtual bool isDissipative() const { return false; }

    /// What its forces are measured by from now on, until the next call; what is spanned is there as long as forces are
    /// asked for.
    virtual void take(const Motion& motion) { static_cast<void>(motion); }
    /// Whether its forces may put energy in, so that none that it gives stands for them over a step.
    [[nodiscard]] virtual bool isFromOutside() const { return false; }
    /// Whether project() comes before the sweep over the cloth, and so acts on the way that is foreseen.
    [[nodiscard]] virtual bool isBeforeSweep() const { return isFromOutside(); }
    /// Before the first Newton iteration, and again whenever the forces nearly balance: takes the normal forces that
    /// friction rests on, and in statics may act from farther, by what it has yielded.
    virtual void fixFriction(std::span<const Vec3> positions) { static_cast<void>(positions); }
    /// After that: goes back towards the normal forces before it, so that this part of the change is left [–].
    virtual void easeFriction(double part) { static_cast<void>(part); }
    /// Once before every Newton iteration: finds what may act in it. Until the next call of this or of fixFriction()
    /// the energy is one function of the positions.
    virtual void beginIteration(std::span<const Vec3> positions) = 0;
    [[nodiscard]] virtual double energy(std::span<const Vec3> positions) const = 0;
    virtual void addForces(std::span<const Vec3> positions, std::span<Vec3> forces) const = 0;
    virtual void addHessian(std::span<const Vec3> positions, HessianSink& sink) const = 0;
    /// After a part of a step whose end forces alone have decided: shortens ways on which what must stay apart would
    /// meet. What is near was found by beginIteration() on them.
    virtual void hold(std::span<const Vec3> from, std::span<Vec3> positions) {
        static_cast<void>(from);
        static_cast<void>(positions);
    }
    /// Bound of what its forces add to the squared angular frequency of a particle [1/s²], for explicit methods.
    [[nodiscard]] virtual double largestFrequencySquared() const { return 0; }
};

} // namespace toile::dynamics
