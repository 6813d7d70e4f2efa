// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/dynamics/FinerSubsteps.h"

namespace toile::dynamics {
namespace {

bool mayEndFiner(const Result<void>& done) {
    return !done && done.error().code == ErrorCode::notConverged;
}

} // namespace

Result<StepReport> stepOrFiner(Xpbd& xpbd, ParticleState& state, double duration, int substeps, const Vec3& gravity,
                               std::span<Stage* const> stages, std::stop_token stop) {
    constexpr int finest = 4; // times the substeps
    StepReport report{.parts = substeps};
    const auto step = [&] { return xpbd.step(state, duration, report.parts, gravity, stages, stop); };
    auto done = step();
    if (mayEndFiner(done)) {
        CoarseLevels* const levels = xpbd.correctBy(nullptr);
        while (mayEndFiner(done) && report.parts < finest * substeps) {
            report.repeated += report.parts;
            report.parts *= 2;
            done = step();
        }
        xpbd.correctBy(levels);
    }
    if (!done) return tl::unexpected(done.error());
    return report;
}

} // namespace toile::dynamics
