// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/validation/Tube.h"

#include "core/simulation/MeshInputOf.h"
#include "core/study/validation/Pieces.h"

#include <cmath>
#include <numbers>

namespace toile::study::validation {

double Tube::radius() const {
    return round / (2 * std::numbers::pi);
}

std::optional<Tube> tubeOf(Findings& found, const material::Fabric& fabric, double round, double height,
                           double spacing) {
    pattern::Pattern pattern;
    material::Fabric cloth = fabric;
    cloth.id = material::FabricId("cloth");
    pattern.fabrics.push_back(std::move(cloth));
    pattern.pieces.push_back(polygonPiece("tube", {{0, 0}, {round, 0}, {round, height}, {0, height}}, spacing));
    pattern.seams.push_back(seamBetween("side", "tube", "e1", "tube", "e3"));
    const auto input = simulation::meshInputOf(pattern);
    if (!found.ran(input)) return std::nullopt;
    auto mesh = meshing::meshGarment(*input);
    if (!found.ran(mesh)) return std::nullopt;
    const std::vector<Vec2> nodes = mesh->pieces.front().material;
    auto garment = simulation::makeGarment(pattern, Shared<meshing::GarmentMesh>(std::move(*mesh)), {true});
    if (!found.ran(garment)) return std::nullopt;
    Tube tube{std::move(*garment), round, height, {}, {}};
    const std::size_t particles = tube.garment.model.mass.size();
    tube.material.resize(particles);
    tube.state.positions.resize(particles);
    tube.state.velocities.resize(particles);
    for (std::size_t node = 0; node < nodes.size(); ++node) {
        const int particle = tube.garment.particles.particleOf[node];
        const double turn = 2 * std::numbers::pi * nodes[node].x / round;
        tube.material[particle] = nodes[node];
        tube.state.positions[particle] = {tube.radius() * std::cos(turn), nodes[node].y,
                                          tube.radius() * std::sin(turn)};
    }
    return tube;
}

} // namespace toile::study::validation
