// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/Shapes.h"
#include "core/pattern/PatternCheck.h"
#include "core/simulation/Inspect.h"
#include "core/study/Calibration.h"
#include "core/study/stability/Cases.h"
#include "core/study/validation/Pieces.h"

#include <algorithm>
#include <fmt/format.h>
#include <functional>
#include <numbers>

/// Seams that are too long, too far, or blocked.
namespace toile::study::stability {
namespace {

using simulation::Simulation;
using validation::polygonPiece;
using validation::seamBetween;

std::string firstError(const pattern::Pattern& pattern) {
    const auto problems = pattern::checkPattern(pattern);
    const auto problem = std::ranges::find_if(problems, &pattern::Problem::isError);
    return problem == problems.end() ? "" : problem->text;
}

/// What sewing showed, frame by frame.
struct Sewn {
    std::optional<Simulation> simulation;
    Metrics metrics;
    std::string stopped;
    [[nodiscard]] bool merged() const { return simulation && simulation->allSeamsMerged(); }
};

Sewn sewn(const simulation::Scene& scene, int frames, const std::function<void(const Simulation&)>& look = {}) {
    Sewn out;
    const double start = threadSeconds();
    auto simulation = Simulation::create(scene);
    if (!simulation) {
        out.stopped = simulation.error().text;
        return out;
    }
    double speed = 0;
    for (int frame = 0; frame < frames && out.stopped.empty(); ++frame) {
        if (const auto done = simulation->advance(); !done) out.stopped = done.error().text;
        speed = std::max(speed, simulation->largestSpeed());
        if (look) look(*simulation);
    }
    out.metrics.speed = speed;
    out.metrics.seconds = threadSeconds() - start;
    out.simulation = std::move(*simulation);
    return out;
}

Row closes(const std::string& number, const std::string& what, const Sewn& run) {
    if (!run.stopped.empty()) return tested(number, what, false, run.stopped, run.metrics);
    return tested(number, what, run.merged(), run.merged() ? "" : "The seam stays open.", run.metrics);
}

/// Two pieces of 0.2 m height whose facing sides are so long.
simulation::Scene unequalSides(double longSide, double shortSide) {
    simulation::Scene scene = validation::twoSquares();
    const auto place = [&](int index, const char* id, double side) {
        pattern::Piece piece = polygonPiece(id, {{0, 0}, {0.1, 0}, {0.1, side}, {0, side}}, 0.01);
        piece.placement = scene.pattern.pieces[index]->placement;
        piece.placement->transform.origin = {index == 0 ? -0.15 : 0.05, 1 - side / 2, 0};
        scene.pattern.pieces[index] = Shared<pattern::Piece>(std::move(piece));
    };
    place(0, "left", longSide);
    place(1, "right", shortSide);
    return scene;
}

Findings s15UnequalSides(const Effort&) {
    return {{mustBeRefused("S15", "seam between 0.3 m and 0.1 m, no ease declared",
                           firstError(unequalSides(0.3, 0.1).pattern))},
            {}};
}

Findings s31Gathers(const Effort& effort) {
    simulation::Scene scene = unequalSides(0.4, 0.1);
    scene.pattern.seams[0].sections = {{.gatherRatio = 4}};
    const Sewn run = sewn(scene, effort.quick ? 120 : 240);
    Findings found{{closes("S31", "gathers 4 : 1 over 0.1 m", run)}, {}};
    if (!run.merged()) return found;
    // How evenly: the distances of neighbouring seam particles along the short side.
    const auto& garment = run.simulation->garment();
    double least = 1, most = 0;
    const auto& pairs = garment.mesh->seams[0].pairs;
    for (std::size_t i = 1; i < pairs.size(); ++i) {
        const double apart =
            geometry::distance(run.simulation->state().positions[garment.particles.particle(pairs[i - 1][0])],
                               run.simulation->state().positions[garment.particles.particle(pairs[i][0])]);
        least = std::min(least, apart);
        most = std::max(most, apart);
    }
    found.rows.push_back(
        tested("S31", fmt::format("the same: longest over shortest way between stitches {:.2f}", most / least),
               most / least < 3, "The fullness is not even.", run.metrics));
    return found;
}

Findings s16FarOrBlocked(const Effort& effort) {
    Findings found;
    simulation::Scene far = validation::twoSquares();
    pattern::Piece piece = *far.pattern.pieces[1];
    piece.placement->transform.origin.x = 10;
    far.pattern.pieces[1] = Shared<pattern::Piece>(std::move(piece));
    double gap = 10, fastest = 0; // of the seam [m], [m/s]
    const Sewn run = sewn(far, 300, [&](const Simulation& simulation) {
        const double now = simulation.gapOf(0).maximum;
        if (!simulation.allSeamsMerged()) fastest = std::max(fastest, 60 * (gap - now));
        gap = now;
    });
    Row row = closes("S16", fmt::format("seam between pieces 10 m apart, closing at {:.1f} m/s at most", fastest), run);
    if (row.verdict == Verdict::pass && fastest > 5.05) // its gap is read once a frame
        row = tested(row.number, row.what, false, "It may close at 5 m/s.", run.metrics);
    found.rows.push_back(std::move(row));

    simulation::Scene blocked = validation::twoSquares(0.02);
    body::Body wall;
    wall.name = "wall";
    wall.mesh = geometry::box({-0.05, 0.5, -0.5}, {0.05, 1.7, 0.5});
    blocked.body = Shared<body::Body>(std::move(wall));
    const Sewn stuck = sewn(blocked, effort.quick ? 150 : 300);
    if (!stuck.stopped.empty()) {
        found.rows.push_back(tested("S16", "seam across a wall", false, stuck.stopped, stuck.metrics));
        return found;
    }
    gap = stuck.simulation->gapOf(0).maximum;
    row = tested("S16", fmt::format("seam across a wall of 100 mm: reported open by {:.0f} mm", 1e3 * gap),
                 !stuck.merged() && gap > 0.09, "It should be reported as open.", stuck.metrics);
    if (row.verdict == Verdict::pass) {
        row.verdict = Verdict::passWithWarning;
        row.why = "The report says that the seam is open.";
    }
    found.rows.push_back(std::move(row));
    return found;
}

/// Four squares of 0.1 m round a point, 20 mm apart.
simulation::Scene fourSquares() {
    simulation::Scene scene;
    scene.settings.gravity = {};
    scene.pattern.fabrics.push_back(validation::plainCloth());
    for (int k = 0; k < 4; ++k) {
        const std::string id(1, static_cast<char>('a' + k));
        pattern::Piece piece = polygonPiece(id, {{0, 0}, {0.1, 0}, {0.1, 0.1}, {0, 0.1}}, 0.02);
        piece.placement = pattern::Placement{};
        piece.placement->transform.origin = {k % 2 == 0 ? -0.11 : 0.01, k < 2 ? -0.11 : 0.01, 0};
        scene.pattern.pieces.push_back(std::move(piece));
    }
    scene.pattern.seams = {seamBetween("ab", "a", "e1", "b", "e3"), seamBetween("cd", "c", "e1", "d", "e3"),
                           seamBetween("ac", "a", "e2", "c", "e0"), seamBetween("bd", "b", "e2", "d", "e0")};
    return scene;
}

Findings s17Loops(const Effort&) {
    Findings found;
    const Sewn run = sewn(fourSquares(), 180);
    Row row = closes("S17", "four pieces sewn round a point", run);
    if (row.verdict == Verdict::pass) {
        const int particles = run.simulation->garment().particles.particleCount;
        row = tested(row.number, fmt::format("{}: {} particles, 121 of one sheet", row.what, particles),
                     particles == 121, "The middle is not one particle.", run.metrics);
    }
    found.rows.push_back(std::move(row));
    simulation::Scene band; // both ends walked the same way: a half turn
    band.pattern.fabrics.push_back(validation::plainCloth());
    band.pattern.pieces.push_back(polygonPiece("band", {{0, 0}, {0.4, 0}, {0.4, 0.05}, {0, 0.05}}, 0.02));
    pattern::Seam seam = seamBetween("turned", "band", "e1", "band", "e3");
    seam.sides[1][0].reversed = false;
    band.pattern.seams.push_back(seam);
    const auto problems = pattern::checkPattern(band.pattern);
    Row turned =
        tested("S17", "band sewn to itself with a half turn: it is said", !problems.empty(), "Nothing is said.");
    if (!problems.empty()) {
        turned.verdict = problems.front().isError ? Verdict::refused : Verdict::passWithWarning;
        turned.why = problems.front().text;
    }
    found.rows.push_back(std::move(turned));
    return found;
}

Findings s29Swimsuit(const Effort& effort) {
    constexpr double bodyRadius = 0.12;
    const double girth = 2 * std::numbers::pi * bodyRadius, width = 0.85 * girth;
    simulation::Scene scene;
    scene.settings.gravity = {}; // a cylinder has no waist to hold it while it is shaken down without friction
    material::Fabric jersey = validation::plainCloth();
    jersey.warpStiffness = jersey.weftStiffness = 200;
    jersey.shearStiffness = 30;
    scene.pattern.fabrics.push_back(jersey);
    pattern::Piece piece =
        polygonPiece("tube", {{-width / 2, 0}, {width / 2, 0}, {width / 2, 0.15}, {-width / 2, 0.15}}, 0.015);
    piece.placement = pattern::Placement{};
    piece.placement->curl = pattern::Curl{.radius = bodyRadius + 0.01};
    piece.placement->transform.origin = {0, 0.93, bodyRadius + 0.01};
    scene.pattern.pieces.push_back(std::move(piece));
    scene.pattern.seams.push_back(seamBetween("back", "tube", "e1", "tube", "e3"));
    body::Body body;
    body.name = "cylinder";
    body.mesh = geometry::cylinder(bodyRadius, 0.3, 128, 16);
    for (Vec3& v : body.mesh.vertices) v.y += 1;
    scene.body = Shared<body::Body>(std::move(body));
    Sewn run = sewn(scene, effort.quick ? 120 : 240);
    if (!run.simulation) return {{closes("S29", "tube 15 % too narrow sewn on a cylinder", run)}, {}};
    const auto contact = simulation::contactOf(*run.simulation);
    run.metrics.distance = contact.bodyClearanceMinimum;
    run.metrics.strain = simulation::strainOf(*run.simulation).weftMaximum;
    Row row = closes("S29", "tube 15 % too narrow sewn on a cylinder", run);
    if (row.verdict == Verdict::pass && (contact.bodyPenetrationMaximum > 0 || contact.bodyIntersections > 0))
        row = tested(row.number, row.what, false, "Cloth is in the body.", run.metrics);
    return {{std::move(row)}, {}};
}

/// A skirt of 0.3 m that hangs by a strap of 5 mm, sewn to the middle of its upper side.
Findings s34Strap(const Effort& effort) {
    simulation::Scene scene;
    scene.pattern.fabrics.push_back(validation::plainCloth());
    pattern::Piece skirt = polygonPiece("skirt", {{0, 0}, {0.3, 0}, {0.3, 0.3}, {0, 0.3}}, 0.02);
    skirt.placement = pattern::Placement{};
    skirt.placement->transform.origin = {-0.15, 0.69, 0};
    pattern::Piece strap = polygonPiece("strap", {{0, 0}, {0.005, 0}, {0.005, 0.25}, {0, 0.25}}, 0.005);
    strap.placement = pattern::Placement{};
    strap.placement->transform.origin = {-0.0025, 1, 0};
    scene.pattern.pieces.push_back(std::move(skirt));
    scene.pattern.pieces.push_back(std::move(strap));
    scene.pattern.seams.push_back(seamBetween("strap", "skirt", "e2", "strap", "e0"));
    scene.pattern.seams[0].sides[0][0].from = 0.5 - 0.0025 / 0.3;
    scene.pattern.seams[0].sides[0][0].to = 0.5 + 0.0025 / 0.3;
    for (const char* vertex : {"v2", "v3"})
        scene.pattern.pins.push_back({pattern::PinId(vertex), pattern::PieceId("strap"), pattern::VertexId(vertex)});
    Sewn run = sewn(scene, effort.quick ? 180 : 300);
    if (run.simulation) run.metrics.strain = simulation::strainOf(*run.simulation).warpMaximum;
    Findings found{{closes("S34", "skirt of 0.3 m on a strap of 5 mm, while moving", run)}, {}};
    if (!run.merged()) return found;
    const auto rest = run.simulation->settle({});
    if (!rest) {
        found.rows.push_back(tested("S34", "the same at rest", false, rest.error().text));
        return found;
    }
    run.metrics = {.strain = simulation::strainOf(*run.simulation).warpMaximum, .residual = rest->newton.residual};
    const double pull = 0.15 * 0.3 * 0.3 * 9.81 / 0.005 / 1000; // ρ A g over width and stiffness: 2.6 %
    found.rows.push_back(tested("S34", "the same at rest", rest->newton.converged && *run.metrics.strain < 4 * pull,
                                "The strap is stretched over four times what the weight asks, or not at rest.",
                                run.metrics));
    return found;
}

Findings s33HeavyAndLight(const Effort& effort) {
    simulation::Scene scene = validation::twoSquares();
    material::Fabric chiffon = validation::plainCloth(), denim = validation::plainCloth();
    chiffon.id = material::FabricId("chiffon");
    chiffon.arealDensity = 0.03;
    chiffon.warpStiffness = chiffon.weftStiffness = 300;
    chiffon.shearStiffness = 5;
    chiffon.warpBending = chiffon.weftBending = chiffon.biasBending = 1e-6;
    denim.id = material::FabricId("denim");
    denim.arealDensity = 0.4;
    denim.warpStiffness = denim.weftStiffness = 9000;
    denim.shearStiffness = 100;
    denim.warpBending = denim.weftBending = denim.biasBending = 80e-6;
    scene.pattern.fabrics = {};
    scene.pattern.fabrics.push_back(chiffon);
    scene.pattern.fabrics.push_back(denim);
    for (int index : {0, 1}) {
        pattern::Piece piece = *scene.pattern.pieces[index];
        piece.fabric = index == 0 ? chiffon.id : denim.id;
        scene.pattern.pieces[index] = Shared<pattern::Piece>(std::move(piece));
    }
    return {{closes("S33", "chiffon of 30 g/m² sewn to denim of 400 g/m²", sewn(scene, effort.quick ? 120 : 240))}, {}};
}

} // namespace

std::vector<Case> sewingCases() {
    return {{"S15", "unequal sides", s15UnequalSides},
            {"S16", "far or blocked seams", s16FarOrBlocked},
            {"S17", "seam loops", s17Loops},
            {"S29", "swimsuit", s29Swimsuit},
            {"S31", "gathers", s31Gathers},
            {"S33", "heavy and light", s33HeavyAndLight},
            {"S34", "strap", s34Strap}};
}

} // namespace toile::study::stability
