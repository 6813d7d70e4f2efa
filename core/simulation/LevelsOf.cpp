// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/LevelsOf.h"

#include "core/dynamics/Eliminated.h"
#include "core/meshing/DisplayElements.h"
#include "core/pattern/PatternFabrics.h"
#include "core/pattern/PatternMeasures.h"

namespace toile::simulation {
namespace {

constexpr double leastMass =
    0.05; ///< of a coarse particle over the median of its level; the samples have 0.19 and more

} // namespace

LevelPlan levelPlanFor(int substeps, const LevelRule& rule) {
    constexpr int many = 30, enough = 28, fine = 2;
    if (substeps <= rule.bearable) return {0, substeps};
    const auto leftBy = [&](int levels) { return (substeps + (1 << levels) - 1) >> levels; };
    int levels = 0;
    while (levels < rule.most && leftBy(levels + 1) >= rule.fewest) ++levels;
    if (rule.oneMore && levels >= fine && leftBy(levels) > many) return {levels + 1, enough};
    return {levels, leftBy(levels)};
}

dynamics::LevelMesh levelMeshOf(const pattern::Pattern& pattern, const meshing::GarmentMesh& mesh,
                                const std::vector<bool>& mergedSeams) {
    const ParticleMap map = particleMap(mesh, mergedSeams);
    dynamics::LevelMesh level{map.particleCount, {}};
    for (std::size_t i = 0; i < mesh.pieces.size(); ++i) {
        const meshing::PieceMesh& piece = mesh.pieces[i];
        const material::Fabric fabric = *pattern::clothOf(pattern, *pattern.pieces[i]);
        const pattern::Piece& shape = *pattern::shapeOf(pattern, *pattern.pieces[i]); // which has the regions
        const std::vector<int> elements = meshing::displayElements(piece);
        for (std::size_t at = 0; at < elements.size(); ++at) {
            const cloth::StiffnessFactors factors = factorsOf(shape, meshing::regionOf(piece, elements[at]));
            dynamics::LevelTriangle t{.patch = static_cast<int>(i),
                                      .weft = factors.stretch * fabric.weftStiffness,
                                      .warp = factors.stretch * fabric.warpStiffness,
                                      .shear = factors.shear * fabric.shearStiffness};
            for (int k = 0; k < 3; ++k) {
                const int node = piece.display[at][k];
                t.particles[k] = map.particle({t.patch, node});
                t.material[k] = piece.material[node];
            }
            if (areaOf(t) > 0) level.triangles.push_back(t);
        }
    }
    return level;
}

Result<std::vector<meshing::GarmentMesh>> coarserMeshes(const meshing::MeshInput& fine, int levels) {
    std::vector<meshing::GarmentMesh> meshes;
    meshing::MeshInput input = fine;
    for (meshing::PieceInput& piece : input.pieces) piece.regions.clear();
    for (int level = 0; level < levels; ++level) {
        for (meshing::PieceInput& piece : input.pieces) piece.spacing *= 2;
        auto mesh = meshing::meshGarment(input, {.judged = false});
        if (!mesh) return tl::unexpected(mesh.error());
        meshes.push_back(std::move(*mesh));
    }
    return meshes;
}

Result<std::unique_ptr<dynamics::CoarseLevels>> levelsOf(const pattern::Pattern& pattern,
                                                         const MeshOverrides& overrides, const Garment& garment,
                                                         int levels, std::span<const double> inertia) {
    const auto input = meshInputOf(pattern, overrides);
    if (!input) return tl::unexpected(input.error());
    const auto coarser = coarserMeshes(*input, levels);
    if (!coarser) return tl::unexpected(coarser.error());
    std::vector<dynamics::LevelMesh> meshes;
    for (const meshing::GarmentMesh& mesh : *coarser) meshes.push_back(levelMeshOf(pattern, mesh, garment.mergedSeams));
    std::vector<double> mass = garment.model.mass;
    for (std::size_t particle = 0; particle < inertia.size(); ++particle) mass[particle] *= inertia[particle];
    auto made =
        std::make_unique<dynamics::CoarseLevels>(levelMeshOf(pattern, *garment.mesh, garment.mergedSeams), meshes, mass,
                                                 dynamics::Eliminated(garment.model).inverseMass(inertia));
    if (made->lightest() < leastMass) return fail(ErrorCode::unsupported, "a piece is narrower than their cells");
    return made;
}

} // namespace toile::simulation
