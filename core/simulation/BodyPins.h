// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/collision/MovingSurface.h"
#include "core/dynamics/Stage.h"

#include <span>
#include <vector>

namespace toile::simulation {

/// A particle that the body carries along, and as which place.
struct BodyPin {
    int particle = 0;
    collision::CarriedPlace place;
};

/// Pins these particles to what of the body is nearest to them now. positions: of all particles [m].
[[nodiscard]] std::vector<BodyPin> pinnedTo(const collision::MovingSurface& body, std::span<const int> particles,
                                            std::span<const Vec3> positions);

/// The farthest that one of them is now from where the body has carried its place by this time [m].
[[nodiscard]] double farthestOff(const collision::MovingSurface& body, std::span<const BodyPin> pins,
                                 std::span<const Vec3> positions, double time);

/// Carries pinned particles along with a body that moves, substep by substep: the way of each is continuous, and no
/// longer than that of its place. What keeps layers apart comes later in the substep and may hold them back; in the
/// next one they go all the way to their places.
class BodyPins final : public dynamics::Stage {
public:
    /// The body is borrowed and outlives the stage.
    BodyPins(const collision::MovingSurface& body, std::vector<BodyPin> pins) : body_(body), pins_(std::move(pins)) {}

    [[nodiscard]] std::string_view name() const override { return "pins to the body"; }
    [[nodiscard]] std::size_t bytes() const override { return pins_.capacity() * sizeof(BodyPin); }
    void beginStep(const dynamics::ParticleState&, double) override {}
    void project(dynamics::Substep& substep) override;
    /// Before the sweep, so that the cloth beside a pin answers in the same substep.
    [[nodiscard]] bool isFromOutside() const override { return true; }

    void beginIteration(std::span<const Vec3>) override {}
    [[nodiscard]] double energy(std::span<const Vec3>) const override { return 0; }
    void addForces(std::span<const Vec3>, std::span<Vec3>) const override {}
    void addHessian(std::span<const Vec3>, dynamics::HessianSink&) const override {}

private:
    const collision::MovingSurface& body_;
    std::vector<BodyPin> pins_;
};

} // namespace toile::simulation
