// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/Wearing.h"

#include "core/base/CpuTime.h"
#include "core/base/TimeLimit.h"
#include "core/simulation/Inspect.h"

#include <algorithm>

namespace toile::simulation {
namespace {

double lowestPoint(const Simulation& simulation) {
    return std::ranges::min(simulation.state().positions, {}, &Vec3::y).y;
}

void keepWorst(ContactSummary& worst, const ContactSummary& now) {
    worst.bodyPenetrationMaximum = std::max(worst.bodyPenetrationMaximum, now.bodyPenetrationMaximum);
    if (!worst.bodyClearanceMinimum) worst.bodyClearanceMinimum = now.bodyClearanceMinimum;
    if (now.bodyClearanceMinimum)
        worst.bodyClearanceMinimum = std::min(*worst.bodyClearanceMinimum, *now.bodyClearanceMinimum);
    worst.selfIntersections = std::max(worst.selfIntersections, now.selfIntersections);
    worst.bodyIntersections = std::max(worst.bodyIntersections, now.bodyIntersections);
    worst.nodesInWrongOrder = std::max(worst.nodesInWrongOrder, now.nodesInWrongOrder);
    worst.outsideBody = worst.outsideBody && now.outsideBody;
    worst.layersApart = worst.layersApart && now.layersApart;
}

} // namespace

bool WearingReport::reachedItsGoal() const {
    return after.atRest && contact.outsideBody && contact.selfIntersections == 0;
}

Result<WearingReport> wear(Simulation& simulation, std::shared_ptr<const geometry::VertexMotion> motion,
                           const SewSettings& settings, std::stop_token stop, const Progress& progress,
                           const FrameObserver& observer) {
    const double begin = simulation.state().time, cpuBegin = processSeconds(), hem = lowestPoint(simulation);
    const double frameStep = simulation.scene().settings.frameStep;
    WearingReport result;
    result.contact = contactOf(simulation);
    if (auto moved = simulation.moveBody(motion); !moved) return tl::unexpected(moved.error());
    const TimeLimit limit(settings.deadline, stop);
    while (simulation.bodyMoves() && !limit.isOver()) {
        if (stop.stop_requested()) return fail(ErrorCode::cancelled, "The run was stopped.");
        const double elapsed = simulation.state().time - begin;
        result.bodySpeed = std::max(result.bodySpeed, motion->farthest(elapsed, elapsed + frameStep) / frameStep);
        if (auto stepped = simulation.advance(limit.token()); !stepped) {
            if (limit.ended(stepped.error())) break;
            return tl::unexpected(stepped.error());
        }
        keepWorst(result.contact, contactOf(simulation));
        result.offItsPin = std::max(result.offItsPin, simulation.farthestOffItsPin());
        ++result.steps;
        report(progress, 0.5 * elapsed / motion->duration(), "the body moves");
        if (observer) observer(simulation);
    }
    result.seconds = simulation.state().time - begin;
    result.cpuSeconds = processSeconds() - cpuBegin;

    SewSettings resting = settings;
    resting.seconds.reset();
    resting.hold = 0;
    auto after = sew(simulation, resting, stop, progress, observer);
    if (!after) return tl::unexpected(after.error());
    result.after = std::move(*after);
    result.after.worn.reset();
    result.hemRise = lowestPoint(simulation) - hem;
    return result;
}

} // namespace toile::simulation
