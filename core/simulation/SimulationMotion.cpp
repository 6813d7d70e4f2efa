// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/BodyContactOf.h"
#include "core/simulation/Simulation.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

/// A garment on a body that moves.
namespace toile::simulation {

Result<void> Simulation::moveBody(std::shared_ptr<const geometry::VertexMotion> motion) {
    constexpr double sameBody = 1e-3; // [m]
    if (!body_) return fail(ErrorCode::invalidInput, "The scene has no body that could move.");
    if (phase_ != Phase::draping || fallsUnseen())
        return fail(ErrorCode::invalidInput, "The garment is still being put on: the body moves when it is worn.");
    if (scene_.paper || drapingMethod_ != dynamics::Method::xpbd)
        return fail(ErrorCode::unsupported, fmt::format("On a body that moves cloth is simulated by {} alone.",
                                                        nameOf(dynamics::Method::xpbd)));
    if (motion_) return fail(ErrorCode::invalidInput, "The body is still moving.");
    if (auto sound = geometry::checkedMotion(*motion, body_->mesh(), sameBody); !sound) return sound;
    motion_ = std::make_shared<collision::MovingSurface>(body_->mesh(), std::move(motion), state_.time);
    body_ = std::shared_ptr<const collision::BodySurface>(motion_, &motion_->surface());
    restingTime_ = 0;
    sewnNodes_.clear();
    hangsBy_.clear(); // what is to move has its own mass
    pinToBody();
    rebuildPlan();
    return {};
}

/// Where the cloth lies now, on the body as it is now: when it begins to move, and whenever the cloth is built anew
/// while it does.
void Simulation::pinToBody() {
    bodyPins_.clear();
    if (!motion_ || garment_->pinnedToBody.empty()) return;
    motion_->moveTo(state_.time);
    bodyPins_ = pinnedTo(*motion_, garment_->pinnedToBody, state_.positions);
}

std::unique_ptr<BodyPins> Simulation::carriedAlong() const {
    return bodyPins_.empty() ? nullptr : std::make_unique<BodyPins>(*motion_, bodyPins_);
}

double Simulation::farthestOffItsPin() const {
    return bodyPins_.empty() ? 0 : farthestOff(*motion_, bodyPins_, state_.positions, state_.time);
}

void Simulation::followBody() {
    if (auto* contact = bodyContactIn(plan_); motion_ && contact) contact->follow(*motion_);
}

/// The surface stays the one that moved: cloth that was flung by it still wants a closer look.
void Simulation::standStill() {
    motion_->moveTo(motion_->ends());
    for (const BodyPin& pin : bodyPins_) state_.velocities[pin.particle] = {};
    bodyPins_.clear();
    motion_.reset();
    rebuildPlan();
}

/// After a frame step beside a body that moves.
void Simulation::noteBody() {
    if (state_.time > motion_->ends() - 1e-9) standStill();
    const body::Body& atFirst = **scene_.body;
    const std::vector<Vec3>& vertices = body_->mesh().vertices;
    movedBody_.reset();
    if (vertices == atFirst.mesh.vertices) return;
    body::Body now = atFirst;
    now.mesh.vertices = vertices;
    movedBody_ = Shared<body::Body>(std::move(now));
}

/// In no substep may the body go a quarter as far as cloth keeps away from it: it cannot leap through. Where it goes
/// far, the plan is made anew on the way, for other cells are near its bumps then.
Result<dynamics::StepReport> Simulation::moveBesideBody(double duration, std::stop_token stop) {
    constexpr double planReach = 0.01; // cells are taken for near a bump within 30 mm [m]
    const double way = motion_->farthestBetween(state_.time, state_.time + duration);
    const int parts = std::max(1, static_cast<int>(std::ceil(way / planReach)));
    constexpr double leastKept = 0.001; // cloth that is to lie on the skin itself does not ask for endless substeps [m]
    const double least = way / (std::max(scene_.settings.skinOffset, leastKept) / 4);
    dynamics::StepReport report{.parts = 0};
    for (int part = 0; part < parts; ++part) {
        if (way > 0) {
            rebuildPlan();
            correctByDueLevels();
        }
        const int substeps = static_cast<int>(std::ceil(std::max<double>(substeps_, least) / parts));
        const auto done = moveInSubsteps(duration / parts, substeps, stop);
        if (!done) return done;
        report += *done;
    }
    return report;
}

} // namespace toile::simulation
