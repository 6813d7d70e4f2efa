// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/dynamics/Faces.h"

namespace toile::dynamics {

struct WindSettings {
    Vec3 velocity;            ///< of the air, far from the cloth; zero = still air [m/s]
    double coefficient = 1.2; ///< c of a plate across the stream; square plates have 1.17 (docs/physics/air.md) [–]
    double density = 1.2;     ///< ρ of air at 20 °C [kg/m³]
};

/// The drag of air that streams along or against the cloth.
///
/// Every face feels f = −½ ρ c A |u|·u·n, a third on each corner [N]; u = (v − w)·n speed of the face against the wind
/// w along its normal n [m/s], A its area [m²]. Both sides are alike, and along the cloth there is none. For a given
/// A·n it is −∂D/∂v of D = ρ c A |u|³/6 [W], which is convex. Ref: docs/physics/air.md
class Wind final : public Stage {
public:
    /// The model is borrowed.
    Wind(const cloth::ClothModel& model, std::vector<Face> faces, const WindSettings& settings);

    [[nodiscard]] std::string_view name() const override { return "wind"; }
    [[nodiscard]] std::size_t bytes() const override;
    void beginStep(const ParticleState&, double) override {}
    void project(Substep& substep) override;

    void take(const Motion& motion) override { motion_ = motion; }
    [[nodiscard]] bool isFromOutside() const override { return true; }
    void fixFriction(std::span<const Vec3> positions) override;
    void beginIteration(std::span<const Vec3>) override {}
    /// What the air takes by drag in the time of the motion; of given velocities, the work against its constant force.
    [[nodiscard]] double energy(std::span<const Vec3> positions) const override;
    void addForces(std::span<const Vec3> positions, std::span<Vec3> forces) const override;
    void addHessian(std::span<const Vec3> positions, HessianSink& sink) const override;

private:
    struct Sail {
        Vec3 normal;     ///< n
        double drag = 0; ///< k = ½ ρ c A [kg/m]
    };
    [[nodiscard]] Sail sailOf(const Face& face, std::span<const Vec3> positions) const;
    /// How the force on a face along n, and what stands for it, depend on where the cloth is.
    struct Pull {
        double force = 0;     ///< [N]
        double energy = 0;    ///< [J]
        double stiffness = 0; ///< −∂force/∂x along n [N/m]
    };
    [[nodiscard]] double speedOf(std::size_t face, const Vec3& velocity) const; ///< u [m/s]
    [[nodiscard]] Pull pullOf(std::size_t face, std::span<const Vec3> positions) const;

    const cloth::ClothModel& model_;
    std::vector<Face> faces_;
    WindSettings settings_;
    Motion motion_;
    std::vector<Sail> sails_; ///< as fixFriction found them
    std::vector<Vec3> forces_;
};

} // namespace toile::dynamics
