// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/Shapes.h"
#include "core/simulation/Sew.h"
#include "core/study/Calibration.h"
#include "core/study/stability/Cases.h"
#include "core/study/validation/Pieces.h"

#include <algorithm>
#include <fmt/format.h>
#include <numbers>

/// Flared skirts of two panels that hang on a cone: one over the other, and one on finer and finer meshes.
namespace toile::study::stability {
namespace {

using simulation::Simulation;
using validation::polygonPiece;
using validation::seamBetween;

constexpr double skirtLength = 0.15;

/// Radius 80 mm at a height of 1.2 m, and 200 mm more for every metre below.
body::Body cone() {
    body::Body body;
    body.name = "cone";
    body.mesh = geometry::cylinder(1, 0.25, 128, 32);
    for (Vec3& v : body.mesh.vertices) {
        v.y += 0.95;
        const double radius = 0.08 + 0.2 * (1.2 - v.y);
        v.x *= radius;
        v.z *= radius;
    }
    return body;
}

/// Adds a skirt whose upper edge is as long as the girth at this radius; its panels start so far before and behind the
/// axis [m].
void addSkirt(simulation::Scene& scene, const std::string& name, double radius, double apart, double spacing,
              int layer) {
    const double top = std::numbers::pi * radius, hem = std::numbers::pi * (radius + 0.3 * skirtLength);
    for (const bool front : {true, false}) {
        const std::string id = name + (front ? " front" : " back");
        pattern::Piece piece =
            polygonPiece(id, {{-hem / 2, 0}, {hem / 2, 0}, {top / 2, skirtLength}, {-top / 2, skirtLength}}, spacing);
        piece.layer = layer;
        piece.placement = pattern::Placement{};
        const double side = front ? 1 : -1;
        piece.placement->transform = {.axisX = {side, 0, 0}, .axisZ = {0, 0, side}, .origin = {0, 1, side * apart}};
        scene.pattern.pieces.push_back(std::move(piece));
    }
    scene.pattern.seams.push_back(seamBetween(name + " left", name + " front", "e1", name + " back", "e3"));
    scene.pattern.seams.push_back(seamBetween(name + " right", name + " front", "e3", name + " back", "e1"));
}

simulation::Scene coneScene() {
    simulation::Scene scene;
    scene.pattern.fabrics.push_back(validation::plainCloth());
    scene.body = Shared<body::Body>(cone());
    scene.settings.bodyFriction = 0.01; // it slides to where its girth fits, but does not turn for ever
    return scene;
}

/// A scene sewn until it rests, or for a time.
struct SewnSkirts {
    std::optional<Simulation> simulation;
    simulation::SewReport report;
    Metrics metrics;
    std::string why; ///< it is not closed, not outside the body, or not at rest where no time was set
};

SewnSkirts sewn(const simulation::Scene& scene, const simulation::SewSettings& settings = {}) {
    SewnSkirts out;
    const double start = threadSeconds();
    auto simulation = Simulation::create(scene);
    if (!simulation) {
        out.why = simulation.error().text;
        return out;
    }
    auto report = simulation::sew(*simulation, settings);
    out.metrics.seconds = threadSeconds() - start;
    out.simulation = std::move(*simulation);
    if (!report) {
        out.why = report.error().text;
        return out;
    }
    out.report = std::move(*report);
    out.metrics.residual = out.report.residual;
    out.metrics.distance = out.report.contact.bodyClearanceMinimum;
    if (!out.report.allClosed()) out.why = "A seam stays open.";
    else if (!out.report.contact.outsideBody) out.why = "The cloth is in the body.";
    else if (!settings.seconds && !out.report.atRest) out.why = "It does not come to rest.";
    return out;
}

Findings s30Petticoat(const Effort& effort) {
    const double spacing = effort.quick ? 0.03 : 0.02;
    simulation::Scene scene = coneScene();
    scene.settings.selfContact = true;
    for (int layer = 0; layer < 3; ++layer)
        addSkirt(scene, fmt::format("skirt {}", layer + 1), 0.11 + 0.003 * layer, 0.16 + 0.03 * layer, spacing, layer);
    const SewnSkirts run = sewn(scene, {.seconds = 4}); // folded layers tremble for longer
    const simulation::ContactSummary& contact = run.report.contact;
    const std::string why = !run.why.empty()                ? run.why
                            : contact.selfIntersections > 0 ? "The skirts cross."
                            : contact.nodesInWrongOrder > 0 ? "A lower layer lies outside."
                            : !contact.guarantee            ? "The layers were not kept apart all the time."
                                                            : "";
    return {{tested("S30",
                    fmt::format(
                        "three skirts over one another, {} particles, 4 s: {} intersections, {} nodes in wrong order",
                        run.report.particles, contact.selfIntersections, contact.nodesInWrongOrder),
                    why.empty(), why, run.metrics)},
            {}};
}

/// Mean height of the nodes on an edge of both panels [m].
double heightOf(const Simulation& simulation, std::size_t edge) {
    double sum = 0, count = 0;
    for (std::size_t piece = 0; piece < 2; ++piece)
        for (const meshing::EdgeNode& end : simulation.garment().mesh->pieces[piece].loops[0][edge]) {
            sum += simulation.state()
                       .positions[simulation.garment().particles.particle({static_cast<int>(piece), end.node})]
                       .y;
            ++count;
        }
    return sum / count;
}

Findings s38FinerAndFiner(const Effort& effort) {
    Findings found;
    std::vector<double> waists, hems;
    for (const double spacing : {0.03, 0.01, effort.quick ? 0.006 : 0.003}) {
        simulation::Scene scene = coneScene();
        addSkirt(scene, "skirt", 0.11, 0.16, spacing, 0);
        const SewnSkirts run = sewn(scene);
        std::string what = fmt::format("skirt on a mesh of {:.3g} mm", 1000 * spacing);
        if (run.simulation) {
            waists.push_back(heightOf(*run.simulation, 2));
            hems.push_back(heightOf(*run.simulation, 0));
            what += fmt::format(", {} particles: waist at {:.1f} mm, hem at {:.1f} mm", run.report.particles,
                                1000 * waists.back(), 1000 * hems.back());
        }
        found.rows.push_back(tested("S38", what, run.why.empty(), run.why, run.metrics));
    }
    if (waists.size() < 3) return found;
    const auto narrows = [](const std::vector<double>& heights) {
        return std::abs(heights[2] - heights[1]) < std::abs(heights[1] - heights[0]);
    };
    found.rows.push_back(
        tested("S38",
               fmt::format("from mesh to mesh the waist moves by {:.2f} and {:.2f} mm, the hem by {:.2f} and {:.2f} mm",
                           1000 * std::abs(waists[1] - waists[0]), 1000 * std::abs(waists[2] - waists[1]),
                           1000 * std::abs(hems[1] - hems[0]), 1000 * std::abs(hems[2] - hems[1])),
               narrows(waists) && narrows(hems), "A finer mesh does not bring them closer."));
    return found;
}

} // namespace

std::vector<Case> skirtCases() {
    return {{"S30", "petticoat of three layers", s30Petticoat},
            {"S38", "one garment on finer and finer meshes", s38FinerAndFiner}};
}

} // namespace toile::study::stability
