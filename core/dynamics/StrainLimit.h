// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/cloth/ClothModel.h"
#include "core/dynamics/Stage.h"

#include <span>
#include <vector>

namespace toile::dynamics {

struct StrainLimitSettings {
    double strain = 0.1;  ///< woven cloth is not pulled longer along warp and weft [–]
    double tension = 500; ///< but what stretches farther by itself under so much may [N/m]: 10 N on 20 mm
    int sweeps = 2;       ///< in a substep
};

/// Keeps cloth from stretching where it is pulled harder than the force is carried on in few substeps: from where it is
/// pulled outward, lengths along warp and weft are brought back to a limit. Momentum is kept. For position-based steps
/// alone. docs/physics/xpbd.md, Ref: Provot 1995
class StrainLimit final : public Stage {
public:
    /// pulled: the particles from which the pull spreads.
    StrainLimit(const cloth::ClothModel& model, std::span<const int> pulled, StrainLimitSettings settings = {});

    [[nodiscard]] std::string_view name() const override { return "strain limit"; }
    [[nodiscard]] std::size_t bytes() const override { return lengths_.capacity() * sizeof(Length); }
    void beginStep(const ParticleState&, double) override {}
    void project(Substep& substep) override;

    void beginIteration(std::span<const Vec3>) override {}
    [[nodiscard]] double energy(std::span<const Vec3>) const override { return 0; }
    void addForces(std::span<const Vec3>, std::span<Vec3>) const override {}
    void addHessian(std::span<const Vec3>, HessianSink&) const override {}

private:
    /// |Σ coefficient·x| ≤ longest. Unused places hold particle −1.
    struct Length {
        std::array<int, 3> particles{-1, -1, -1};
        std::array<double, 3> coefficients{};
        double longest = 0;
    };
    void sortOutward(std::span<const int> pulled, std::size_t particleCount);
    [[nodiscard]] static bool shorten(const Length& length, Substep& substep);

    int sweeps_;
    std::vector<Length> lengths_; ///< those near the pull first
};

} // namespace toile::dynamics
