// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/SeamClosing.h"

namespace toile::simulation {

/// Puts both particles of a pair that has nearly met into one place, their common centre of mass, once contact with
/// the body has had its say.
///
/// Where the cloth beside a seam rests on the body on one side only, the seam carries the force F of that contact
/// across. Contact comes after the seams, so it leaves each substep of length h with a gap of F h² (1/m_a + 1/m_b): at
/// 20 mm spacing 0.03 N part the light particles of a border by 0.8 mm, and a seam that nothing blocks would never
/// merge.
class SeamMeeting final : public dynamics::Stage {
public:
    SeamMeeting(std::vector<SeamPair> pairs, SeamClosingSettings settings);

    [[nodiscard]] std::string_view name() const override { return "seams that meet"; }
    [[nodiscard]] std::size_t bytes() const override { return pairs_.capacity() * sizeof(SeamPair); }
    void beginStep(const dynamics::ParticleState&, double) override {}
    void project(dynamics::Substep& substep) override;

    // Where forces are solved for nothing is left to do: there the body's push is part of the balance.
    void beginIteration(std::span<const Vec3>) override {}
    [[nodiscard]] double energy(std::span<const Vec3>) const override { return 0; }
    void addForces(std::span<const Vec3>, std::span<Vec3>) const override {}
    void addHessian(std::span<const Vec3>, dynamics::HessianSink&) const override {}

private:
    std::vector<SeamPair> pairs_;
    SeamClosingSettings settings_;
};

} // namespace toile::simulation
