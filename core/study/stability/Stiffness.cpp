// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cloth/Forces.h"
#include "core/dynamics/Statics.h"
#include "core/simulation/Garment.h"
#include "core/simulation/MeshInputOf.h"
#include "core/study/Calibration.h"
#include "core/study/Scenes.h"
#include "core/study/stability/Cases.h"
#include "core/study/validation/Pieces.h"
#include "core/study/validation/Sheets.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

/// Cloth that is far stiffer than the step, or than its neighbour.
namespace toile::study::stability {
namespace {

using dynamics::Method;
using validation::downward;

std::string cellName(const MapCell& cell) {
    return fmt::format("{:.0e} N/m at {:.2g} s", cell.stiffness, cell.step);
}

/// All runs of the map by one method as one line.
Row rowOf(const MapMethod& method, const std::vector<MapCell>& map) {
    Row row{.number = "S1"};
    int runs = 0, refused = 0, flagged = 0;
    const MapCell* grown = nullptr;
    double worstError = 0;
    const auto growth = [](const MapCell& cell) { return cell.run.metrics.energyGrowth.value_or(0); };
    for (const MapCell& cell : map) {
        if (cell.method != method.name) continue;
        ++runs;
        refused += cell.run.refused;
        flagged += !cell.run.solved;
        row.metrics = worst(row.metrics, cell.run.metrics);
        if (std::isfinite(cell.error)) worstError = std::max(worstError, cell.error);
        if (!cell.bounded && (!grown || growth(cell) > growth(*grown))) grown = &cell;
    }
    row.what =
        fmt::format("{}: {} runs, {} refused; largest error {:.2g} of the way", method.name, runs, refused, worstError);
    const bool isDefault = method.stiffnessCap <= 1; // without cap growth is what the cap is there for
    if (grown) {
        row.verdict = isDefault ? Verdict::fail : Verdict::passWithWarning;
        row.why = grown->run.stopped.empty() ? "Energy grows, most at " + cellName(*grown) + "."
                                             : cellName(*grown) + ": " + grown->run.stopped;
    } else if (flagged > 0) {
        row.verdict = Verdict::passWithWarning;
        row.why = fmt::format("{} runs with a part taken unsolved, with the flag for it.", flagged);
    }
    return row;
}

/// The largest angular frequency of the flap at rest, by power iteration on M⁻¹K [1/s].
double trueFrequency(const Scene& scene) {
    const auto& model = scene.model;
    const double move = 1e-7;
    std::vector<Vec3> mode(model.mass.size());
    for (std::size_t p = 0; p < mode.size(); ++p) mode[p] = {std::sin(7.0 * p), std::cos(3.0 * p), std::sin(5.0 * p)};
    for (const int p : model.pinned) mode[p] = {};
    double squared = 0;
    for (int round = 0; round < 400; ++round) {
        double norm = 0;
        for (const Vec3& m : mode) norm += squaredLength(m);
        norm = std::sqrt(norm);
        std::vector<Vec3> forces(mode.size()), opposite(mode.size()), there = scene.start.positions, back = there;
        for (std::size_t p = 0; p < mode.size(); ++p) {
            mode[p] = mode[p] / norm;
            there[p] += move * mode[p];
            back[p] += -move * mode[p];
        }
        cloth::addForces(model, there, forces);
        cloth::addForces(model, back, opposite);
        squared = 0;
        for (std::size_t p = 0; p < mode.size(); ++p) {
            const Vec3 next = (opposite[p] - forces[p]) / (2 * move * model.mass[p]);
            squared += dot(next, mode[p]);
            mode[p] = next;
        }
        for (const int p : model.pinned) mode[p] = {};
    }
    return std::sqrt(squared);
}

Findings s1StiffnessAgainstStep(const Effort& effort) {
    const MapSettings settings = mapSettings(effort.quick);
    Findings found{.map = stiffnessMap(settings)};
    for (const MapMethod& method : mapMethods()) found.rows.push_back(rowOf(method, found.map));
    double least = 1, most = 0;
    for (const double stiffness : settings.stiffnesses) {
        const Scene scene = *sceneNamed("flap", {settings.cells, stiffness / 50});
        const double printed = std::sqrt(cloth::largestFrequencySquared(scene.model));
        const double ratio = trueFrequency(scene) / printed; // of limits: printed over true
        least = std::min(least, ratio);
        most = std::max(most, ratio);
    }
    found.rows.push_back(
        tested("S1", fmt::format("printed limit of explicit steps over the true one: {:.3f} to {:.3f}", least, most),
               most <= 1 + 1e-6 && least > 1 / 1.5, "It should be between 1/1.5 and 1."));
    return found;
}

Findings s2RoundingFloor(const Effort&) {
    const cloth::Patch patch = cloth::gridPatch(cloth::evenLines(0.008, 8), cloth::evenLines(0.008, 8));
    material::Fabric fabric = validation::unequalWeave();
    fabric.warpStiffness = fabric.weftStiffness = 1e9;
    fabric.shearStiffness = 1e8;
    cloth::ClothModel model = validation::modelOf(patch, fabric);
    for (int p = 0; p <= 8; ++p) model.pinned.push_back(72 + p);
    dynamics::ParticleState state{.positions = cloth::flatPositions(patch), .velocities = {}};
    const double start = threadSeconds();
    const dynamics::StaticSettings settings{.tolerance = 1e-12};
    const auto rest = dynamics::solveStatic(model, state, downward, {}, settings);
    Metrics metrics{.seconds = threadSeconds() - start};
    if (!rest) return {{{"S2", "1e9 N/m, cells of 1 mm", metrics, Verdict::fail, rest.error().text}}, {}};
    metrics.residual = rest->newton.residual;
    return {{tested("S2",
                    fmt::format("1e9 N/m, cells of 1 mm: floor {:.2g}, reached in {} iterations",
                                rest->newton.residualFloor, rest->newton.iterations),
                    rest->newton.converged && rest->newton.iterations < settings.maximumIterations / 2,
                    fmt::format("It should stop at the floor of rounding, well before {} iterations.",
                                settings.maximumIterations),
                    metrics)},
            {}};
}

/// The flap with a button on its free corner.
Findings s3MassRatio(const Effort&) {
    Findings found;
    double plain = 0;
    for (const double ratio : {1.0, 1e3, 1e6}) {
        Scene scene = *sceneNamed("flap", {16, 100});
        scene.model.mass.back() *= ratio;
        const Watched run = watched(scene.model, scene.start, {.integrator = {.damping = 0.5}, .steps = 24});
        Row row =
            judged("S3", fmt::format("a particle {:g} times as heavy, TR-BDF2 at 1/60 s", ratio), run, Method::trBdf2);
        const double newton = run.metrics.newtonPerStep.value_or(0);
        if (ratio == 1) plain = newton;
        else if (row.verdict == Verdict::pass && newton > 3 * plain)
            row = tested(row.number, row.what, false, "It takes over three times the iterations of equal masses.",
                         row.metrics);
        found.rows.push_back(std::move(row));
    }
    return found;
}

Findings s24StiffBesideSoft(const Effort&) {
    Findings found;
    cloth::Patch patch = cloth::gridPatch(cloth::evenLines(0.2, 12), cloth::evenLines(0.2, 12));
    for (std::size_t c = 0; c < patch.rectangles.size(); ++c)
        if (c % 12 >= 6) patch.rectangles[c].factors = {1e6, 1e6, 1};
    cloth::ClothModel model = validation::modelOf(patch, validation::unequalWeave());
    for (int p = 0; p <= 12; ++p) model.pinned.push_back(p);
    dynamics::ParticleState start;
    for (const Vec2& m : patch.material) start.positions.push_back({m.x, 0, m.y});
    for (const Method method : {Method::trBdf2, Method::xpbd}) {
        dynamics::ParticleState state = start;
        found.rows.push_back(judged("S24",
                                    fmt::format("one half of a sheet a million times stiffer, {}", nameOf(method)),
                                    watched(model, state, {.method = method, .steps = 30}), method));
    }
    return found;
}

/// A piece of 0.2 m with a painted square 64 times finer than the rest, pulled evenly: no inner particle may feel a
/// force.
Findings s18FineRegion(const Effort&) {
    constexpr int refinement = 6;
    constexpr double spacing = 0.032;
    const std::string what = "region 64 times finer than its piece";
    pattern::Pattern pattern;
    pattern.fabrics.push_back(validation::plainCloth());
    pattern::Piece piece = validation::polygonPiece("piece", {{0, 0}, {0.192, 0}, {0.192, 0.192}, {0, 0.192}}, spacing);
    pattern::Region region{.id = pattern::RegionId("fine"), .name = "fine", .outline = {}, .refinement = refinement};
    region.outline = {{0.064, 0.064}, {0.096, 0.064}, {0.096, 0.096}, {0.064, 0.096}};
    piece.regions.push_back(std::move(region));
    pattern.pieces.push_back(std::move(piece));
    const auto input = simulation::meshInputOf(pattern);
    if (!input) return {{tested("S18", what, false, input.error().text)}, {}};
    auto mesh = meshing::meshGarment(*input);
    if (!mesh) return {{mustBeRefused("S18", what, mesh.error().text)}, {}};
    const std::vector<Vec2> places = mesh->pieces.front().material;
    const auto garment = simulation::makeGarment(pattern, Shared<meshing::GarmentMesh>(std::move(*mesh)), {});
    if (!garment) return {{tested("S18", what, false, garment.error().text)}, {}};
    constexpr double strain = 1e-6;
    std::vector<Vec3> x, forces(places.size());
    for (const Vec2& m : places) x.push_back({(1 + strain) * m.x, m.y, 0});
    cloth::addForces(garment->model, x, forces);
    cloth::gatherToMasters(garment->model, forces);
    double most = 0;
    for (std::size_t p = 0; p < places.size(); ++p) {
        const auto isInner = [](double t) { return t > 1e-9 && t < 0.192 - 1e-9; };
        if (isInner(places[p].x) && isInner(places[p].y)) most = std::max(most, length(forces[p]));
    }
    const double pull = 1000 * strain * spacing; // of one coarse cell [N]
    const double limit = 2 / std::sqrt(cloth::largestFrequencySquared(garment->model, x));
    return {{tested("S18",
                    fmt::format("{}: {} particles, forces inside {:.1g} of a cell's pull, limit of explicit steps "
                                "{:.2g} s",
                                what, places.size(), most / pull, limit),
                    most / pull < 1e-5, "They should vanish with the square of the strain of 1e-6.")},
            {}};
}

} // namespace

std::vector<Case> stiffnessCases() {
    return {{"S1", "stiffness against step", s1StiffnessAgainstStep},
            {"S2", "rounding floor", s2RoundingFloor},
            {"S3", "mass ratio of a million", s3MassRatio},
            {"S18", "fine region", s18FineRegion},
            {"S24", "stiff beside soft", s24StiffBesideSoft}};
}

} // namespace toile::study::stability
