// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/dynamics/Stage.h"

#include <vector>

namespace toile::simulation {

struct SeamClosingSettings {
    double duration = 0.6;       ///< in which a seam's gap goes to zero [s]
    double maximumSpeed = 5;     ///< at which a gap may close; long gaps take longer [m/s]
    double maximumForce = 5;     ///< between the two particles of a pair, so that a blocked seam does not tear [N]
    double staticStiffness = 10; ///< of an open pair in the finish [N/m]: a seam that a body holds open by 50 mm pulls
                                 ///< with 0.5 N a pair, which dents the contact by less than a millimetre
    int iterations = 4;          ///< sweeps over the pairs in a substep: corners belong to several
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
    SeamClosing(std::vector<SeamPair> pairs, SeamClosingSettings settings);

    [[nodiscard]] std::string_view name() const override { return "seams"; }
    [[nodiscard]] std::size_t bytes() const override { return pairs_.capacity() * sizeof(SeamPair); }
    void beginStep(const dynamics::ParticleState&, double) override {}
    void project(dynamics::Substep& substep) override;

    void beginIteration(std::span<const Vec3>) override {}
    [[nodiscard]] double energy(std::span<const Vec3> positions) const override;
    void addForces(std::span<const Vec3> positions, std::span<Vec3> forces) const override;
    void addHessian(std::span<const Vec3> positions, dynamics::HessianSink& sink) const override;

    /// The distance that a pair may have at a time [m].
    [[nodiscard]] static double allowedGap(const SeamPair& pair, double time, const SeamClosingSettings& settings);

private:
    std::vector<SeamPair> pairs_;
    SeamClosingSettings settings_;
};

} // namespace toile::simulation
