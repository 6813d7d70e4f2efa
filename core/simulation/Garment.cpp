// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/Garment.h"

#include "core/base/Contracts.h"
#include "core/cloth/Patch.h"
#include "core/pattern/PatternFabrics.h"
#include "core/simulation/DrawnUp.h"
#include "core/simulation/PinNodes.h"
#include "core/simulation/SeamElastics.h"
#include "core/simulation/SeamHinges.h"

#include <algorithm>
#include <fmt/format.h>
#include <iterator>

namespace toile::simulation {
namespace {

using pattern::Pattern;
using pattern::Piece;

/// At which flexion springs are as stiff as the fabric [1/m]: that of the blouse's folds (docs/simulation.md).
constexpr double paperCurvature = 15;

cloth::CellForm formFor(material::FabricKind kind) {
    return kind == material::FabricKind::knit ? cloth::CellForm::membrane : cloth::CellForm::automatic;
}

cloth::Patch patchOf(const Piece& piece, const meshing::PieceMesh& mesh, std::span<const int> particles) {
    cloth::Patch patch;
    patch.material = mesh.material;
    patch.particles.assign(particles.begin(), particles.end());
    patch.rectangles.reserve(mesh.rectangles.size());
    patch.triangles.reserve(mesh.triangles.size());
    for (const meshing::Rectangle& cell : mesh.rectangles)
        patch.rectangles.push_back({cell.nodes, factorsOf(piece, cell.region)});
    for (const meshing::Triangle& t : mesh.triangles) patch.triangles.push_back({t.nodes, factorsOf(piece, t.region)});
    for (const meshing::SlaveNode& slave : mesh.slaves) patch.slaves.push_back({slave.node, slave.masters});
    for (const auto& fold : mesh.folds)
        for (std::size_t i = 0; i + 1 < fold.size(); ++i) patch.creases.push_back(std::minmax(fold[i], fold[i + 1]));
    std::ranges::sort(patch.creases);
    return patch;
}

/// All particles of frozen pieces.
std::vector<int> frozenParticles(const Garment& garment, const Pattern& pattern) {
    std::vector<int> frozen;
    for (std::size_t i = 0; i < pattern.pieces.size(); ++i) {
        if (!pattern.pieces[i]->frozen) continue;
        const auto first = garment.particles.particleOf.begin() + garment.particles.firstNode[i];
        frozen.insert(frozen.end(), first, first + std::ssize(garment.mesh->pieces[i].nodes));
    }
    return frozen;
}

void sortUnique(std::vector<int>& numbers) {
    std::ranges::sort(numbers);
    const auto [first, last] = std::ranges::unique(numbers);
    numbers.erase(first, last);
}

/// What is held in space and to the body, where a seam has made one particle of both, is held in space.
Result<void> pinParticles(Garment& garment, const Pattern& pattern) {
    std::vector<int> inSpace = frozenParticles(garment, pattern), toBody;
    for (const pattern::Pin& pin : pattern.pins) {
        const auto node = nodeOf(pin, pattern, *garment.mesh);
        if (!node) return tl::unexpected(node.error());
        (pin.toBody ? toBody : inSpace).push_back(garment.particles.particle(*node));
    }
    sortUnique(inSpace);
    sortUnique(toBody);
    std::ranges::set_difference(toBody, inSpace, std::back_inserter(garment.pinnedToBody));
    std::ranges::set_union(inSpace, toBody, std::back_inserter(garment.model.pinned));
    return {};
}

} // namespace

cloth::StiffnessFactors factorsOf(const Piece& piece, int region) {
    if (region < 0) return {};
    expects(region < std::ssize(piece.regions), "the piece that has the region: of a mirror image, its source");
    const pattern::StiffnessFactors& f = piece.regions[region].stiffness;
    return {f.stretch, f.shear, f.bending};
}

Result<Garment> makeGarment(const Pattern& pattern, Shared<meshing::GarmentMesh> mesh, std::vector<bool> mergedSeams,
                            bool paper) {
    Garment garment{std::move(mesh), std::move(mergedSeams), {}, {}, {}, {}, {}, {}};
    garment.particles = particleMap(*garment.mesh, garment.mergedSeams);
    garment.halfThickness.assign(garment.particles.particleCount, 0);
    garment.friction.assign(garment.particles.particleCount, 0);
    std::vector<std::vector<cloth::DrawnSide>> drawn = drawnUp(pattern, *garment.mesh, garment.mergedSeams);
    for (std::size_t i = 0; i < pattern.pieces.size(); ++i) {
        const Piece& piece = *pattern.pieces[i];
        const meshing::PieceMesh& pieceMesh = garment.mesh->pieces[i];
        const std::optional<material::Fabric> fabric = pattern::clothOf(pattern, piece);
        if (!fabric)
            return fail(ErrorCode::invalidInput, fmt::format("There is no fabric \"{}\".", piece.fabric.value),
                        {.object = fmt::format("piece \"{}\"", piece.name)});
        const std::span<const int> particles(garment.particles.particleOf.data() + garment.particles.firstNode[i],
                                             pieceMesh.nodes.size());
        const Piece source = pattern::resolved(pattern, piece);
        cloth::Patch patch = patchOf(source, pieceMesh, particles);
        patch.drawn = std::move(drawn[i]);
        const auto report = cloth::appendPatch(garment.model, patch, *fabric,
                                               {paper ? cloth::CellForm::springs : formFor(fabric->kind)});
        if (!report) return tl::unexpected(report.error());
        for (const int particle : particles) {
            garment.halfThickness[particle] = std::max(garment.halfThickness[particle], 0.5 * fabric->thickness);
            garment.friction[particle] = std::max(garment.friction[particle], fabric->friction);
        }
    }
    if (!paper) {
        garment.folds = appendFoldHinges(garment.model, pattern, *garment.mesh, garment.particles);
        appendSeamHinges(garment.model, pattern, *garment.mesh, garment.mergedSeams, garment.particles);
        appendSeamElastics(garment.model, pattern, *garment.mesh, garment.mergedSeams, garment.particles);
    }
    if (const auto pinned = pinParticles(garment, pattern); !pinned) return tl::unexpected(pinned.error());
    cloth::doubleBendingAtClampedRows(garment.model);
    if (paper) garment.paper = cloth::springsAlone(garment.model, paperCurvature);
    return garment;
}

std::vector<std::array<int, 3>> particleTriangles(const Garment& garment) {
    std::vector<std::array<int, 3>> triangles;
    for (std::size_t piece = 0; piece < garment.mesh->pieces.size(); ++piece) {
        const int first = garment.particles.firstNode[piece];
        for (const auto& [a, b, c] : garment.mesh->pieces[piece].display)
            triangles.push_back({garment.particles.particleOf[first + a], garment.particles.particleOf[first + b],
                                 garment.particles.particleOf[first + c]});
    }
    return triangles;
}

std::vector<int> whatBecomesOf(const Garment& garment) {
    if (std::ranges::all_of(garment.mergedSeams, [](bool merged) { return merged; })) return {};
    const ParticleMap sewn = particleMap(*garment.mesh, std::vector<bool>(garment.mergedSeams.size(), true));
    std::vector<int> becomes(garment.particles.particleCount);
    for (std::size_t node = 0; node < sewn.particleOf.size(); ++node)
        becomes[garment.particles.particleOf[node]] = sewn.particleOf[node];
    return becomes;
}

} // namespace toile::simulation
