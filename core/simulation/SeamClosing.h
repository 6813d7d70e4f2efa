// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/dynamics/Stage.h"

#include <vector>

namespace toile::simulation {

struct SeamClosingSettings {
    double duration = 0.6;   ///< in which a seam's gap goes to zero [s]
    double maximumSpeed = 5; ///< at which a gap may close; long gaps take longer [m/s]
    double maximumForce = 5; ///< between the two particles of a pair, so that a blocked seam does not tear [N]
    double stiffness = 10;   ///< of an open pair as a force, in the finish and by methods other than XPBD, up to
                             ///< maximumForce [N/m]: a seam that a body holds open by 50 mm pulls with 0.5 N a
                             ///< pair, which dents the contact by less than a millimetre
    double forceRamp = 0;    ///< in which that force grows from nothing; 0: at once [s]
    int iterations = 4;      ///< sweeps over the pairs in a substep: corners belong to several
};

/// Two particles that a seam draws together.
struct SeamPair {
    int a = 0, b = 0;
    double initialGap = 0; ///< [m]
    double startTime = 0;  ///< when its seam began to close [s]
};

/// Draws the pairs of open seams together: the distance of a pair may not exceed a length that goes from the initial
/// gap to zero. Exists only while there are open seams.
class SeamClosing final : public dynamics::Stage {
public:
    /// mass: one per particle [kg].
    SeamClosing(std::vector<SeamPair> pairs, SeamClosingSettings settings, std::span<const double> mass);

    [[nodiscard]] std::string_view name() const override { return "seams"; }
    [[nodiscard]] std::size_t bytes() const override { return pairs_.capacity() * sizeof(SeamPair); }
    void beginStep(const dynamics::ParticleState& state, double duration) override;
    void project(dynamics::Substep& substep) override;

    void beginIteration(std::span<const Vec3>) override {}
    [[nodiscard]] double energy(std::span<const Vec3> positions) const override;
    void addForces(std::span<const Vec3> positions, std::span<Vec3> forces) const override;
    void addHessian(std::span<const Vec3> positions, dynamics::HessianSink& sink) const override;
    [[nodiscard]] double largestFrequencySquared() const override { return frequencySquared_; }

    /// In which a pair that is so far apart is drawn together [s].
    [[nodiscard]] static double durationOf(double initialGap, const SeamClosingSettings& settings);
    /// The distance that a pair may have at a time [m].
    [[nodiscard]] static double allowedGap(const SeamPair& pair, double time, const SeamClosingSettings& settings);

private:
    std::vector<SeamPair> pairs_;
    [[nodiscard]] double share(const SeamPair& pair) const; ///< of the force, as it grows

    SeamClosingSettings settings_;
    double time_ = 0;             ///< at the end of the frame step; where a force does not grow it is not read [s]
    double frequencySquared_ = 0; ///< [1/s²]
};

} // namespace toile::simulation
