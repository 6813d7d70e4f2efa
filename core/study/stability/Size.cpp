// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/Garment.h"
#include "core/simulation/MeshInputOf.h"
#include "core/study/Calibration.h"
#include "core/study/stability/Cases.h"
#include "core/study/validation/Pieces.h"

#include <fmt/format.h>
#include <numeric>

/// Meshes as fine as nobody should ask for.
namespace toile::study::stability {
namespace {

constexpr double budget = 400e6; ///< of a mesh of a million cells [B]
constexpr double allowed = 0.1;  ///< for it [s]

pattern::Pattern squareMetre(double spacing) {
    pattern::Pattern pattern;
    pattern.fabrics.push_back(validation::plainCloth());
    pattern.pieces.push_back(validation::polygonPiece("sheet", {{0, 0}, {1, 0}, {1, 1}, {0, 1}}, spacing));
    return pattern;
}

Result<meshing::GarmentMesh> meshed(const pattern::Pattern& pattern) {
    const auto input = simulation::meshInputOf(pattern, {});
    if (!input) return tl::unexpected(input.error());
    return meshing::meshGarment(*input);
}

template <class Item>
std::size_t bytesOf(const std::vector<Item>& items) {
    return items.capacity() * sizeof(Item);
}

std::size_t bytesOf(const meshing::PieceMesh& mesh) {
    return bytesOf(mesh.nodes) + bytesOf(mesh.material) + bytesOf(mesh.rectangles) + bytesOf(mesh.triangles) +
           bytesOf(mesh.slaves) + bytesOf(mesh.display);
}

/// One step of backward Euler, so short that conjugate gradients solve it: a direct factor would not fit in memory.
Row implicitStep(const pattern::Pattern& pattern, meshing::GarmentMesh mesh) {
    constexpr double step = 1e-4; // [s]
    auto garment = simulation::makeGarment(pattern, Shared<meshing::GarmentMesh>(std::move(mesh)), {}, false);
    if (!garment) return tested("S19", "its cloth", false, garment.error().text);
    cloth::ClothModel& model = garment->model;
    model.pinned = {0};
    dynamics::ParticleState state;
    for (const Vec2& node : garment->mesh->pieces[0].nodes) state.positions.push_back({node.x, node.y, 0});
    state.velocities.assign(state.positions.size(), {});
    const Watched run =
        watched(model, state, {.method = dynamics::Method::backwardEuler, .step = step, .steps = 1, .timeLimit = 600});
    return judged("S19", fmt::format("an implicit step of 0.1 ms of its {} particles", model.particleCount()), run,
                  dynamics::Method::backwardEuler);
}

Findings s19MillionCells(const Effort& effort) {
    Findings found;
    const pattern::Pattern pattern = squareMetre(effort.quick ? 0.002 : 0.001);
    const double start = threadSeconds();
    auto mesh = meshed(pattern);
    Metrics metrics;
    metrics.seconds = threadSeconds() - start;
    if (!mesh) return {{tested("S19", "a square metre", false, mesh.error().text, metrics)}, {}};
    const std::size_t cells = mesh->pieces[0].rectangles.size(), bytes = bytesOf(mesh->pieces[0]);
    Row row = tested("S19", fmt::format("a mesh of {} cells, {:.0f} MB", cells, 1e-6 * static_cast<double>(bytes)),
                     cells == (effort.quick ? 250000u : 1000000u) && static_cast<double>(bytes) < budget,
                     "Other cells than asked for, or more than 400 MB.", metrics);
    if (!effort.quick && row.verdict == Verdict::pass && metrics.seconds > allowed) {
        row.verdict = Verdict::passWithWarning;
        row.why = fmt::format("It took {:.2f} s; {} s were asked for.", metrics.seconds, allowed);
    }
    found.rows.push_back(std::move(row));
    found.rows.push_back(implicitStep(pattern, std::move(*mesh)));
    const auto refused = meshed(squareMetre(0.0001));
    found.rows.push_back(mustBeRefused("S19", "a hundred million cells", refused ? "" : refused.error().text));
    return found;
}

} // namespace

std::vector<Case> sizeCases() {
    return {{"S19", "a million cells", s19MillionCells}};
}

} // namespace toile::study::stability
