// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Result.h"
#include "core/cloth/ClothModel.h"
#include "core/dynamics/Stage.h"

#include <cstddef>
#include <memory>
#include <span>
#include <stop_token>

namespace toile::dynamics {

class CoarseLevels;

struct XpbdSettings {
    double damping = 0.5; ///< mass-proportional: v̇ = −damping·v [1/s]
    double stiffnessCap =
        1; ///< κ [–]: no element is stiffer than κ/(w h²), w its inverse mass; above 1 energy can grow
    double speedLimit = 0; ///< no particle is faster [m/s]; 0 = no limit
};

/// Position-based dynamics in small steps: one Gauss–Seidel sweep over all elements a substep.
///
/// The integrator of interaction: its error does not depend on the stiffness, but it transports forces over a finite
/// number of elements a substep and so sags by about ½·c·g·h²·n² (substepsFor). Deterministic. The model must
/// outlive it and stay as it is. Ref: Macklin, Müller, Chentanez 2016; Macklin et al. 2019 – docs/physics/xpbd.md
class Xpbd {
public:
    /// inertia: mass scaling, how many times its mass a particle resists being moved, at least 1; its weight stays, and
    /// with it every equilibrium. By particle; empty = once.
    Xpbd(const cloth::ClothModel& model, XpbdSettings settings, std::vector<double> inertia = {});
    Xpbd(Xpbd&&) noexcept;
    Xpbd& operator=(Xpbd&&) noexcept;
    ~Xpbd();

    /// Advances by duration [s] in equal substeps. Pinned particles stay; slaves follow their masters, and what a
    /// stage does to a slave is handed to its masters. Error with step and particle when a number is not finite;
    /// stopped between two substeps it is cancelled. After an error the state is as before.
    [[nodiscard]] Result<void> step(ParticleState& state, double duration, int substeps, const Vec3& gravity,
                                    std::span<Stage* const> stages, std::stop_token stop = {});

    /// Levels that correct each substep between the sweep and the stages; null = none. They are borrowed and outlive
    /// this. Returns those so far.
    CoarseLevels* correctBy(CoarseLevels* levels);
    /// Shares the work of a substep out, where it is much; null = alone. Borrowed. The bits are the same.
    void workWith(Team* team);
    void setSettings(XpbdSettings settings);
    /// 1/kg, of the scaled masses; 0 = pinned, Σ w²/m for a slave.
    [[nodiscard]] std::span<const double> inverseMass() const;
    [[nodiscard]] std::size_t bytes() const;

private:
    struct Data;
    std::unique_ptr<Data> data_;
};

/// Substeps of a frame step that keep the transport error of a line of `springsOnLine` springs, hanging by one end,
/// near `error` [m]. L coarse levels make n springs as good as n/2^L.
[[nodiscard]] int substepsFor(double frameStep, int springsOnLine, double gravity, double error = 0.002);

/// The longest chain of springs a load has to travel: the largest number of edges from any particle to the nearest
/// pinned one, or, where nothing is pinned, the half of the longest way through a patch.
[[nodiscard]] int springsOnLongestLine(const cloth::ClothModel& model);

} // namespace toile::dynamics
