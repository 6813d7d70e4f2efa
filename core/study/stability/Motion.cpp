// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/body/ArmLift.h"
#include "core/body/Mannequin.h"
#include "core/simulation/Wearing.h"
#include "core/study/Calibration.h"
#include "core/study/stability/Cases.h"
#include "core/study/validation/Pieces.h"

#include <algorithm>
#include <fmt/format.h>
#include <numbers>

/// Bodies that move faster than their cloth would like.
namespace toile::study::stability {
namespace {

using simulation::Simulation;

constexpr double degree = std::numbers::pi / 180;
/// To which position-based steps hold free cloth [m/s].
constexpr double clothSpeed = 10;

/// A strip of cloth of 20 mm mesh, its corner and its sides there.
simulation::Scene stripBeside(const body::Body& body, double width, double height, const Transform& place) {
    simulation::Scene scene;
    scene.pattern.fabrics.push_back(validation::plainCloth());
    pattern::Piece piece = validation::polygonPiece("strip", {{0, 0}, {width, 0}, {width, height}, {0, height}}, 0.02);
    piece.placement = pattern::Placement{};
    piece.placement->transform = place;
    scene.pattern.pieces.push_back(Shared<pattern::Piece>(std::move(piece)));
    scene.body = Shared<body::Body>(body);
    scene.settings.selfContact = true;
    scene.settings.bodyFriction = 4; // with the cloth's, enough to stay on a sloping arm
    return scene;
}

/// What a motion did to cloth.
struct Moved {
    simulation::WearingReport report;
    Metrics metrics;
    std::string stopped;
};

/// Lets the cloth fall into its place for so many frame steps; then the arms are turned.
Moved armsTurned(const simulation::Scene& scene, int before, double angle, double seconds) {
    Moved out;
    const double start = threadSeconds();
    const auto motion = body::armLift(**scene.body, angle, seconds);
    auto simulation = Simulation::create(scene);
    if (!motion || !simulation) {
        out.stopped = motion ? simulation.error().text : motion.error().text;
        return out;
    }
    double speed = 0;
    for (int frame = 0; frame < before && out.stopped.empty(); ++frame)
        if (const auto done = simulation->advance(); !done) out.stopped = done.error().text;
    auto report = simulation::wear(*simulation, std::make_shared<const geometry::VertexMotion>(*motion),
                                   {.limit = 0.5, .finish = false}, {}, {},
                                   [&](const Simulation& now) { speed = std::max(speed, now.largestSpeed()); });
    if (!report) out.stopped = report.error().text;
    else out.report = std::move(*report);
    out.metrics.speed = speed;
    out.metrics.distance = out.report.contact.bodyClearanceMinimum;
    out.metrics.seconds = threadSeconds() - start;
    return out;
}

/// A towel over the left forearm, half of it in front and half behind.
simulation::Scene towelOverArm(const body::Body& body) {
    const Vec3 &joint = axisOf(body, body::Limb::leftArm)->points.front(), &wrist = body.landmarks.wristLeft;
    const Vec3 along = normalized(wrist - joint), up = normalized(cross({0, 0, 1}, along)), across = cross(along, up);
    const Vec3 corner = joint + (wrist - joint) * 0.55 + up * 0.07 - across * 0.2;
    return stripBeside(body, 0.2, 0.4,
                       {.axisX = along, .axisY = across, .axisZ = cross(along, across), .origin = corner});
}

/// A lift by so many degrees in so many seconds.
struct Lift {
    double degrees = 120, seconds = 0.3;
};

Row liftedTowel(const body::Body& body, const Lift& lift) {
    const Moved run = armsTurned(towelOverArm(body), 60, lift.degrees * degree, lift.seconds);
    const simulation::ContactSummary& contact = run.report.contact;
    const int after = run.report.after.contact.bodyIntersections;
    const std::string what =
        fmt::format("towel over an arm that is lifted by {:.0f}° in {:.1f} s, at {:.1f} m/s: {} "
                    "intersections with the body at worst, {} after it",
                    lift.degrees, lift.seconds, run.report.bodySpeed, contact.bodyIntersections, after);
    const std::string why = !run.stopped.empty()                 ? run.stopped
                            : !contact.bodyClearanceMinimum      ? "The towel fell off before."
                            : contact.bodyPenetrationMaximum > 0 ? "A node of the cloth came into the body."
                            : contact.selfIntersections > 0      ? "The cloth crossed itself."
                            : after > 0                          ? "The arm still cuts it when it stands."
                                                                 : "";
    Row row = tested("S35", what, why.empty(), why, run.metrics);
    if (why.empty() && contact.bodyIntersections > 0) {
        row.verdict = Verdict::passWithWarning;
        row.why = "Cells are cut by a thin limb for a moment: no node came into it, and the report says so.";
    }
    return row;
}

Findings s35ArmsLifted(const Effort& effort) {
    Findings found;
    const auto mannequin = body::makeMannequin({});
    if (!mannequin) return {{tested("S35", "mannequin", false, mannequin.error().text)}, {}};
    std::vector<Lift> lifts{{}};
    if (!effort.quick) { // where a fling ends hangs on little: many of them
        lifts.push_back({.seconds = 1});
        lifts.push_back({.seconds = 0.1});
        for (const double degrees : {105, 110, 112, 115, 118, 121, 122, 125, 130})
            lifts.push_back({.degrees = degrees});
    }
    for (const Lift& lift : lifts) found.rows.push_back(liftedTowel(mannequin->body, lift));
    return found;
}

Findings s37ClothUnderArm(const Effort&) {
    const auto mannequin = body::makeMannequin({});
    if (!mannequin) return {{tested("S37", "mannequin", false, mannequin.error().text)}, {}};
    const body::Body& body = mannequin->body;
    // A strip that leans on the side of the trunk below the armpit; then the arm comes down on it.
    const Vec3& joint = axisOf(body, body::Limb::leftArm)->points.front();
    const Transform place{
        .axisX = {0, 0, -1}, .axisY = {0, 1, 0}, .axisZ = {1, 0, 0}, .origin = {joint.x + 0.03, joint.y - 0.32, 0.08}};
    simulation::Scene scene = stripBeside(body, 0.16, 0.2, place);
    scene.settings.gravity = {};
    Moved run = armsTurned(scene, 1, -50 * degree, 0.5);
    const simulation::ContactSummary& contact = run.report.contact;
    const std::string what =
        fmt::format("cloth caught under an arm that is lowered: {:.1f} mm in the body at worst, {} "
                    "intersections with it, {} with itself",
                    1000 * contact.bodyPenetrationMaximum, contact.bodyIntersections, contact.selfIntersections);
    if (!run.stopped.empty() || !(*run.metrics.speed <= clothSpeed))
        return {{tested("S37", what, false, run.stopped.empty() ? "The cloth was faster than it may be." : run.stopped,
                        run.metrics)},
                {}};
    Row row = tested("S37", what, true, "", run.metrics);
    if (!contact.outsideBody) {
        row.verdict = Verdict::passWithWarning;
        row.why = "It has nowhere to go; the report says how deep it is in the body.";
    }
    return {{std::move(row)}, {}};
}

} // namespace

std::vector<Case> motionCases() {
    return {{"S35", "arms lifted in 0.3 s", s35ArmsLifted},
            {"S37", "cloth caught between arm and trunk", s37ClothUnderArm}};
}

} // namespace toile::study::stability
