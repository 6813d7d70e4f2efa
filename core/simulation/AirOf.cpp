// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/AirOf.h"

#include "core/dynamics/Pressure.h"
#include "core/dynamics/Wind.h"
#include "core/pattern/PatternFabrics.h"

#include <algorithm>

namespace toile::simulation {
namespace {

/// The cells of a piece with the mass of its cloth.
void appendFaces(std::vector<dynamics::Face>& faces, const meshing::PieceMesh& mesh, std::span<const int> particleOf,
                 double arealDensity, double pressure) {
    const auto massOf = [&](int a, int b, int c) {
        const auto& m = mesh.material;
        return arealDensity * 0.5 * cross(m[b] - m[a], m[c] - m[a]);
    };
    for (const meshing::Rectangle& cell : mesh.rectangles) {
        const auto [a, b, c, d] = cell.nodes;
        dynamics::appendRectangle(faces, {particleOf[a], particleOf[b], particleOf[c], particleOf[d]},
                                  2 * massOf(a, b, c), pressure);
    }
    for (const meshing::Triangle& t : mesh.triangles) {
        const auto [a, b, c] = t.nodes;
        faces.push_back({{particleOf[a], particleOf[b], particleOf[c]}, massOf(a, b, c), 1, pressure});
    }
}

std::vector<dynamics::Face> facesOf(const Scene& scene, const Garment& garment) {
    std::vector<dynamics::Face> faces;
    for (std::size_t i = 0; i < scene.pattern.pieces.size(); ++i) {
        const pattern::Piece& piece = *scene.pattern.pieces[i];
        const auto fabric = pattern::clothOf(scene.pattern, piece); // there is one: it made the garment
        const std::span<const int> particleOf =
            std::span(garment.particles.particleOf).subspan(garment.particles.firstNode[i]);
        appendFaces(faces, garment.mesh->pieces[i], particleOf, fabric->arealDensity, piece.pressure);
    }
    return faces;
}

} // namespace

bool hasPressure(const pattern::Pattern& pattern) {
    return std::ranges::any_of(pattern.pieces, [](const auto& piece) { return piece->pressure != 0; });
}

double loadOf(const Scene& scene) {
    const dynamics::WindSettings still;
    const Air air = scene.settings.air.value_or(Air{});
    const double stagnation = 0.5 * still.density * air.drag * squaredLength(air.wind); // [Pa]
    double ofAir = 0;
    for (const auto& piece : scene.pattern.pieces)
        if (const auto fabric = pattern::clothOf(scene.pattern, *piece))
            ofAir = std::max(ofAir, (std::abs(piece->pressure) + stagnation) / fabric->arealDensity);
    return length(scene.settings.gravity) + (scene.paper ? 0 : ofAir);
}

std::unique_ptr<dynamics::Stage> windOn(const Scene& scene, const Garment& garment, const Air& air) {
    return std::make_unique<dynamics::Wind>(garment.model, facesOf(scene, garment),
                                            dynamics::WindSettings{.velocity = air.wind, .coefficient = air.drag});
}

std::unique_ptr<dynamics::Stage> pressureBehind(const Scene& scene, const Garment& garment,
                                                std::span<const Vec3> positions) {
    return std::make_unique<dynamics::Pressure>(garment.model, facesOf(scene, garment), positions);
}

} // namespace toile::simulation
