// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/batch/SewBegin.h"

#include "app/batch/Console.h"
#include "core/dynamics/Method.h"
#include "core/io/CheckpointFile.h"
#include "core/simulation/BodyThrough.h"
#include "core/simulation/Inspect.h"

#include <algorithm>
#include <fmt/format.h>
#include <limits>

namespace toile::batch {
namespace {

/// The main spacings of a document's pieces.
struct OwnSpacings {
    double least = std::numeric_limits<double>::infinity(), greatest = 0; ///< [m]
};

OwnSpacings ownSpacings(const pattern::Pattern& pattern) {
    OwnSpacings own;
    for (const auto& piece : pattern.pieces) {
        const double spacing = pattern::resolved(pattern, *piece).spacing;
        own.least = std::min(own.least, spacing);
        own.greatest = std::max(own.greatest, spacing);
    }
    return own;
}

/// A document says how many substeps its own mesh needs. What stiffness a substep lets cloth have falls with the square
/// of the spacing, and rises with that of the number of substeps: on a mesh twice as fine twice as many keep it.
int substepsFor(const simulation::Scene& scene, const SewOptions& options) {
    if (options.substeps) return *options.substeps;
    const int own = scene.settings.substeps;
    if (!options.spacing || scene.pattern.pieces.empty()) return own;
    return static_cast<int>(std::ceil(own * std::max(1.0, ownSpacings(scene.pattern).least / *options.spacing)));
}

/// How the garment overlaps the body or itself before it moves; empty if it does not.
std::string overlapAtStart(const simulation::Simulation& simulation) {
    const simulation::ContactSummary start = simulation::contactOf(simulation);
    std::string overlap;
    if (start.bodyPenetrationMaximum > 0 || start.bodyIntersections > 0) {
        overlap = fmt::format("{:.1f} mm inside the body, with {} intersections", 1000 * start.bodyPenetrationMaximum,
                              start.bodyIntersections);
        for (const simulation::BodyThrough& part : simulation::bodyThrough(simulation))
            overlap += fmt::format(", with the {} through piece \"{}\"", partOf(part),
                                   simulation.scene().pattern.pieces[part.piece]->name);
    }
    if (start.selfIntersections > 0)
        overlap += fmt::format("{}with {} intersections with itself", overlap.empty() ? "" : ", and ",
                               start.selfIntersections);
    return overlap;
}

/// Error with --strict, else a warning.
Result<void> judgeStart(OpenedScene& opened, const simulation::Simulation& simulation, const SewOptions& options) {
    const auto& pieces = simulation.scene().pattern.pieces;
    for (const auto& [a, b] : simulation.meeting())
        opened.warnings.push_back({fmt::format("pieces \"{}\" and \"{}\"", pieces[a]->name, pieces[b]->name),
                                   "They are placed through each other: while the garment is sewn they are let "
                                   "through, then drawn apart. What lies in one plane starts 5 mm apart."});
    const std::string overlap = overlapAtStart(simulation);
    if (overlap.empty()) return {};
    if (options.strict)
        return fail(ErrorCode::invalidInput,
                    fmt::format("The garment starts {}: place its pieces clear of it, or leave out --strict.", overlap),
                    {.file = options.file});
    opened.warnings.push_back({"start", fmt::format("The garment starts {}.", overlap)});
    return {};
}

/// The garment as it is placed, on this mesh.
Result<simulation::Simulation> placed(const SewOptions& options, OpenedScene& opened, const simulation::Scene& scene,
                                      const simulation::MeshOverrides& mesh) {
    auto simulation = simulation::Simulation::create(scene, mesh);
    if (!simulation) return simulation;
    simulation->workWith(std::make_shared<Team>(options.threads));
    if (const auto start = judgeStart(opened, *simulation, options); !start) return tl::unexpected(start.error());
    return simulation;
}

Result<simulation::Simulation> resumed(const std::string& checkpoint, const simulation::Scene& scene,
                                       const simulation::MeshOverrides& mesh) {
    const auto point = io::readCheckpoint(checkpoint);
    if (!point) return tl::unexpected(point.error());
    return simulation::Simulation::resumed(scene, mesh, *point);
}

Result<Begun> beginning(Result<simulation::Simulation> simulation) {
    if (!simulation) return tl::unexpected(simulation.error());
    return Begun{std::move(*simulation), std::nullopt};
}

/// Sewn on the document's own mesh, with the substeps that it asks for.
Result<Begun> sewnCoarsely(const SewOptions& options, OpenedScene& opened, const simulation::Scene& scene,
                           const simulation::MeshOverrides& mesh, const simulation::SewSettings& settings,
                           std::stop_token stop) {
    if (const double own = ownSpacings(scene.pattern).greatest; *options.spacing >= own)
        return fail(ErrorCode::invalidInput,
                    fmt::format("Its own mesh has a spacing of {:g} mm, no coarser than --spacing {:g}: leave out "
                                "--refine.",
                                1000 * own, 1000 * *options.spacing),
                    {.file = options.file});
    auto coarse = placed(options, opened, opened.scene, {.rule = options.rule});
    if (!coarse) return tl::unexpected(coarse.error());
    ProgressBar bar(options.quiet);
    const auto stiff = options.substeps ? simulation::StiffBand::bySubsteps : simulation::StiffBand::byInertia;
    auto refined = simulation::refined(std::move(*coarse), scene, mesh, settings, stiff, stop, bar.progress());
    if (!refined) return tl::unexpected(refined.error());
    return Begun{std::move(refined->fine), std::move(refined->coarse)};
}

} // namespace

Result<Begun> begun(const SewOptions& options, OpenedScene& opened, const simulation::SewSettings& settings,
                    std::stop_token stop) {
    const simulation::MeshOverrides mesh{.spacing = options.spacing, .rule = options.rule};
    simulation::Scene scene = opened.scene;
    scene.settings.substeps = substepsFor(opened.scene, options);
    auto begun = options.refine           ? sewnCoarsely(options, opened, scene, mesh, settings, stop)
                 : options.resume.empty() ? beginning(placed(options, opened, scene, mesh))
                                          : beginning(resumed(options.resume, scene, mesh));
    if (!begun) return begun;
    begun->simulation.workWith(std::make_shared<Team>(options.threads));
    if (options.method != dynamics::nameOf(dynamics::Method::xpbd))
        begun->simulation.drapeWith(dynamics::methodNamed(options.method)); // absent for "static"
    return begun;
}

} // namespace toile::batch
