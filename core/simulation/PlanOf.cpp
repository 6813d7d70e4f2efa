// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/PlanOf.h"

#include "core/dynamics/StrainDamping.h"
#include "core/dynamics/StrainLimit.h"
#include "core/simulation/AirOf.h"
#include "core/simulation/BodyContactOf.h"
#include "core/simulation/SeamMeeting.h"
#include "core/simulation/SelfContactOf.h"

#include <algorithm>

namespace toile::simulation {
namespace {

/// The paper's sewing force. It grows, so that pieces neither fling through the body nor are torn out; in the end it is
/// what position-based sewing may pull with.
constexpr SeamClosingSettings paperSewing{.maximumForce = 5, .stiffness = 2000, .forceRamp = 1.5};

constexpr const char* whileSewing = "as gravity it waits until the garment is sewn";

/// Why layers need not be kept apart; empty if they must.
const char* whyNoSelfContact(const Scene& scene, const Garment& garment, bool isForced) {
    if (scene.paper) return "the paper knows the body alone";
    if (isForced) return "";
    if (!scene.settings.selfContact) return "the scene does not ask for it";
    return canReachItself(garment) ? "" : "the cloth is too small to reach itself";
}

/// Parts of the cloth that this garment has no use for.
void leaveOutElements(StepPlan& plan, const Garment& garment) {
    const cloth::ClothModel& model = garment.model;
    if (model.slaves.empty()) plan.leaveOut("slaves", "one spacing in every piece");
    if (model.pinned.empty()) plan.leaveOut("pins", "nothing is pinned");
    if (garment.paper) {
        for (const char* element :
             {"elastics", "membrane cells", "membrane triangles", "bending", "twist", "folds", "seam hinges"})
            plan.leaveOut(element, "the paper has springs alone");
        return;
    }
    if (model.structural.empty()) plan.leaveOut("springs", "no woven piece");
    if (model.elastics.empty()) plan.leaveOut("elastics", "no seam that is merged has one");
    if (model.cells.empty()) plan.leaveOut("membrane cells", "no knit");
    if (model.triangles.empty()) plan.leaveOut("membrane triangles", "rectangles only");
    if (model.bending.empty()) plan.leaveOut("bending", "no bending stiffness");
    if (model.twist.empty()) plan.leaveOut("twist", "4·B45 does not exceed B1 + B2 in any fabric");
    if (garment.folds.empty()) plan.leaveOut("folds", "no pressed fold");
    if (std::ssize(model.hinges) == hingesOf(garment.folds)) plan.leaveOut("seam hinges", "no merged seam");
}

} // namespace

StepPlan planOf(const Scene& scene, const Garment& garment, const Garment& awake, const collision::BodySurface* body,
                std::unique_ptr<BodyPins> carried, DressingNow now, std::shared_ptr<const std::vector<Grip>> grips,
                std::span<const Vec3> positions, std::span<const std::string> forced) {
    auto& [phase, pairs, tacks, meeting] = now;
    const bool isSewing = phase == Phase::sewing;
    const auto isForced = [&](std::string_view stage) { return std::ranges::find(forced, stage) != forced.end(); };
    StepPlan plan;
    leaveOutElements(plan, garment);

    if (carried) plan.add(std::move(carried)); // first: air finds the cloth where it is
    else if (garment.pinnedToBody.empty()) plan.leaveOut("pins to the body", "nothing is pinned to it");
    else plan.leaveOut("pins to the body", body ? "it stands still" : "no body");

    if (isForced("wind")) plan.add(windOn(scene, garment, scene.settings.air.value_or(Air{.drag = 0})));
    else if (!scene.settings.air) plan.leaveOut("wind", "the scene has no air");
    else if (scene.paper) plan.leaveOut("wind", "the paper knows gravity alone");
    else if (isSewing) plan.leaveOut("wind", whileSewing);
    else if (scene.settings.air->drag == 0) plan.leaveOut("wind", "its air does not drag");
    else plan.add(windOn(scene, garment, *scene.settings.air));

    if (isForced("pressure")) plan.add(pressureBehind(scene, garment, positions));
    else if (!hasPressure(scene.pattern)) plan.leaveOut("pressure", "no piece has any");
    else if (scene.paper) plan.leaveOut("pressure", "the paper knows gravity alone");
    else if (isSewing) plan.leaveOut("pressure", whileSewing);
    else plan.add(pressureBehind(scene, garment, positions));

    const double damping = scene.settings.strainDamping;
    if (isForced("strain damping") || (damping > 0 && !scene.paper && !isSewing))
        plan.add(std::make_unique<dynamics::StrainDamping>(awake.model, damping, positions));
    else if (damping == 0) plan.leaveOut("strain damping", "the scene has none");
    else plan.leaveOut("strain damping", scene.paper ? "the paper's springs have none" : whileSewing);

    const SeamClosingSettings closing =
        scene.paper ? paperSewing : SeamClosingSettings{.duration = scene.settings.seamTime};
    if (!pairs.empty() || isForced("seams"))
        plan.add(std::make_unique<SeamClosing>(pairs, closing, garment.model.mass));
    else plan.leaveOut("seams", garment.mergedSeams.empty() ? "the pattern has no seam" : "all seams are merged");

    if (!tacks.empty() || isForced("tacks"))
        plan.add(std::make_unique<Tacks>(tacks, garment.particles, scene.settings.seamTime, garment.model.mass));
    else plan.leaveOut("tacks", scene.paper ? "the paper knows seams alone" : "the pattern has no tack");

    const bool isHeld = !grips->empty();
    std::vector<int> held;
    if (isHeld || isForced("hands")) {
        auto hands = std::make_unique<Grips>(std::move(grips), scene.pattern, garment, positions);
        held = hands->particles();
        plan.add(std::move(hands));
    } else plan.leaveOut("hands", "nobody holds the cloth");

    if (isForced("strain limit") || (isHeld && !scene.paper && !garment.model.structural.empty()))
        plan.add(std::make_unique<dynamics::StrainLimit>(awake.model, held));
    else if (!isHeld) plan.leaveOut("strain limit", "nobody holds the cloth");
    else plan.leaveOut("strain limit", scene.paper ? "the paper's springs give" : "no woven piece");

    const std::string whyNot = whyNoSelfContact(scene, garment, isForced("self-contact"));
    if (body) plan.add(bodyContactOf(scene, awake, *body, positions, whyNot.empty()));
    else plan.leaveOut("body contact", "no body");

    if (scene.paper) plan.leaveOut("seams that meet", "the paper sews by a force");
    else if ((body && !pairs.empty()) || isForced("seams that meet"))
        plan.add(std::make_unique<SeamMeeting>(std::move(pairs), closing));
    else plan.leaveOut("seams that meet", body ? "all seams are merged" : "no body parts them");

    if (!whyNot.empty()) plan.leaveOut("self-contact", whyNot);
    else // last: it goes back where anything has pushed layers through layers
        plan.add(selfContactOf(scene, garment, isSewing ? meeting : std::span<const PiecePair>{}));
    return plan;
}

} // namespace toile::simulation
