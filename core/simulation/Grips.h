// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/dynamics/Stage.h"
#include "core/pattern/Ids.h"
#include "core/simulation/Garment.h"

#include <memory>
#include <string>
#include <vector>

namespace toile::simulation {

/// A place of the cloth that a hand holds: it is drawn towards a point of space, together with the cloth round it.
/// Named by the material, so that it means the same place after the pattern was edited and meshed anew.
struct Grip {
    std::string piece;    ///< id
    Vec2 material;        ///< u weft, v warp, as FrameTopology::material [m]
    Vec3 target;          ///< where the place is to go [m]
    double radius = 0.02; ///< of the cloth that is held, in the material [m]
    double strength = 10; ///< the largest force in all [N]
    double speed = 2;     ///< with which the place is led to the target, however far that jumps [m/s]

    [[nodiscard]] bool samePlace(const Grip& other) const { return piece == other.piece && material == other.material; }
    friend bool operator==(const Grip&, const Grip&) = default;
};

/// Draws held places to their targets. A grip pulls with all its strength from 1 cm away, less nearer to it: neither
/// tears the cloth nor presses it through the body, which has its say afterwards.
class Grips final : public dynamics::Stage {
public:
    /// The grips are read at the beginning of every step: their targets may move, their places may not. Grips of
    /// pieces that the garment has not got hold nothing. positions: of the particles now [m].
    Grips(std::shared_ptr<const std::vector<Grip>> grips, const pattern::Pattern& pattern, const Garment& garment,
          std::span<const Vec3> positions);

    [[nodiscard]] std::vector<int> particles() const; ///< that are held
    [[nodiscard]] std::string_view name() const override { return "hands"; }
    [[nodiscard]] std::size_t bytes() const override;
    void beginStep(const dynamics::ParticleState& state, double duration) override;
    void project(dynamics::Substep& substep) override;

    void beginIteration(std::span<const Vec3>) override {}
    [[nodiscard]] double energy(std::span<const Vec3> positions) const override;
    void addForces(std::span<const Vec3> positions, std::span<Vec3> forces) const override;
    void addHessian(std::span<const Vec3> positions, dynamics::HessianSink& sink) const override;
    [[nodiscard]] double largestFrequencySquared() const override { return frequencySquared_; }

private:
    struct Finger {
        int particle;
        Vec3 offset;  ///< from the grip's point, as it was when it was taken hold of [m]
        double share; ///< of the grip's strength
    };
    struct Hand {
        std::size_t grip; ///< index
        Vec3 from, to;    ///< where it leads the place at the begin and the end of this step [m]
        std::vector<Finger> fingers;
    };

    template <class Visit>
    void eachFinger(Visit visit) const; ///< visit(particle, place it is drawn to, largest force)

    std::shared_ptr<const std::vector<Grip>> grips_;
    std::vector<Hand> hands_;
    double endTime_ = 0, duration_ = 0; ///< of the step [s]
    double frequencySquared_ = 0;
};

} // namespace toile::simulation
