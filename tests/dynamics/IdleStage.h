// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/dynamics/Stage.h"

namespace toile::dynamics {

/// Does nothing: for stages of tests, which do one thing.
class IdleStage : public Stage {
public:
    [[nodiscard]] std::string_view name() const override { return "idle"; }
    [[nodiscard]] std::size_t bytes() const override { return 0; }
    void beginStep(const ParticleState&, double) override {}
    void project(Substep&) override {}
    void beginIteration(std::span<const Vec3>) override {}
    [[nodiscard]] double energy(std::span<const Vec3>) const override { return 0; }
    void addForces(std::span<const Vec3>, std::span<Vec3>) const override {}
    void addHessian(std::span<const Vec3>, HessianSink&) const override {}
};

} // namespace toile::dynamics
