// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/dynamics/Faces.h"

namespace toile::dynamics {

/// The overpressure of air behind the cloth: f = p·A·n for each face, a third on each corner [N].
///
/// It follows the cloth. Where that closes round a volume V it is ∂(p·V)/∂x. At a border a part remains that no energy
/// stands for: it is taken as it is where a Newton iteration begins, and the derivative is that of −p·V alone, with V
/// the volume of the cone from the faces to their middle. Ref: docs/physics/air.md
class Pressure final : public Stage {
public:
    /// Faces without pressure are left out. The model is borrowed; positions: of its particles now [m].
    Pressure(const cloth::ClothModel& model, std::vector<Face> faces, std::span<const Vec3> positions);

    [[nodiscard]] std::string_view name() const override { return "pressure"; }
    [[nodiscard]] std::size_t bytes() const override;
    void beginStep(const ParticleState&, double) override {}
    void project(Substep& substep) override;

    [[nodiscard]] bool isFromOutside() const override { return true; }
    void fixFriction(std::span<const Vec3> positions) override { beginIteration(positions); }
    void beginIteration(std::span<const Vec3> positions) override;
    [[nodiscard]] double energy(std::span<const Vec3> positions) const override; ///< −Σ p·V, less what the border takes
    void addForces(std::span<const Vec3> positions, std::span<Vec3> forces) const override;
    void addHessian(std::span<const Vec3> positions, HessianSink& sink) const override;
    [[nodiscard]] double largestFrequencySquared() const override { return frequencySquared_; }

private:
    const cloth::ClothModel& model_;
    std::vector<Face> faces_;
    Vec3 middle_;              ///< the apex of all cones
    double datum_ = 0;         ///< of the energy [J]
    std::vector<Vec3> border_; ///< what is not ∂(p·V)/∂x [N]
    std::vector<Vec3> forces_;
    double frequencySquared_ = 0;
};

} // namespace toile::dynamics
