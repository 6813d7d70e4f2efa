// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/Inspect.h"

#include "core/base/Sha256.h"
#include "core/cloth/Curvature.h"
#include "core/cloth/Strain.h"
#include "core/collision/Intersections.h"
#include "core/dynamics/SelfContact.h"
#include "core/simulation/LayersApart.h"
#include "core/simulation/Plackets.h"
#include "core/simulation/Topology.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace toile::simulation {
namespace {

geometry::TriangleMesh clothMesh(const Simulation& simulation) {
    geometry::TriangleMesh mesh{simulation.state().positions, {}};
    for (const auto& t : particleTriangles(simulation.garment()))
        if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) mesh.triangles.push_back(t);
    return mesh;
}

/// Pairs of these triangles that will share a corner when all seams are closed.
int neighboursOnceSewn(const std::vector<std::pair<int, int>>& pairs, const std::vector<std::array<int, 3>>& triangles,
                       const std::vector<int>& becomes) {
    if (becomes.empty()) return 0;
    const auto willShareACorner = [&](const std::pair<int, int>& pair) {
        return std::ranges::any_of(triangles[pair.first], [&](int p) {
            return std::ranges::any_of(triangles[pair.second], [&](int q) { return becomes[p] == becomes[q]; });
        });
    };
    return static_cast<int>(std::ranges::count_if(pairs, willShareACorner));
}

/// Cloth is judged by no less of it than lies within so much of a place: at a dart's tip, in an armhole's corner the
/// strain of a membrane has no bound, and an element has the more of it the smaller it is [m].
constexpr double judgedRadius = 0.005;

/// Of every element of the pieces that are asked for, the mean of what lies within a radius of it [m].
template <class Wanted>
std::vector<cloth::Strain> strainsOf(const Simulation& simulation, const Wanted& wanted, double radius = 0) {
    std::vector<cloth::Strain> all;
    const Garment& garment = simulation.garment();
    for (std::size_t piece = 0; piece < garment.mesh->pieces.size(); ++piece) {
        if (!wanted(*simulation.scene().pattern.pieces[piece])) continue;
        const cloth::Patch patch = elementsOf(garment, piece);
        std::vector<cloth::Strain> strains = cloth::strains(patch, simulation.state().positions);
        if (radius > 0) strains = cloth::meanStrains(patch, strains, radius);
        all.insert(all.end(), strains.begin(), strains.end());
    }
    return all;
}

StrainSummary summaryOf(const std::vector<cloth::Strain>& strains) {
    StrainSummary summary;
    if (strains.empty()) return summary;
    std::vector<std::pair<double, double>> warp, weft, shear;
    double area = 0, squares = 0;
    for (const cloth::Strain& strain : strains) {
        warp.emplace_back(strain.warp, strain.area);
        weft.emplace_back(strain.weft, strain.area);
        shear.emplace_back(std::abs(strain.shear), strain.area);
        summary.warpMaximum = std::max(summary.warpMaximum, strain.warp);
        summary.weftMaximum = std::max(summary.weftMaximum, strain.weft);
        summary.shearMaximum = std::max(summary.shearMaximum, std::abs(strain.shear));
        squares += strain.area * (strain.warp * strain.warp + strain.weft * strain.weft);
        area += strain.area;
    }
    summary.rms = std::sqrt(squares / (2 * area));
    summary.warpPercentile95 = cloth::areaPercentile(warp, 0.95);
    summary.weftPercentile95 = cloth::areaPercentile(weft, 0.95);
    summary.shearPercentile95 = cloth::areaPercentile(std::move(shear), 0.95);
    summary.warpPercentile99 = cloth::areaPercentile(std::move(warp), 0.99);
    summary.weftPercentile99 = cloth::areaPercentile(std::move(weft), 0.99);
    return summary;
}

std::optional<int> nodeOf(const pattern::Contour& outline, const meshing::PieceMesh& mesh,
                          const pattern::VertexId& vertex) {
    for (std::size_t i = 0; i < outline.vertices.size(); ++i)
        if (outline.vertices[i].id == vertex) return mesh.loops[0][i].front().node;
    return std::nullopt;
}

/// Corners of the outline: shoulder tips, underarms, ends of hems. Points that only shape an edge are no landmarks: in
/// the middle of a side seam the cloth may fold one way on the left and the other way on the right.
std::vector<pattern::Vertex> landmarkVertices(const pattern::Contour& outline) {
    constexpr double leastTurn = 0.5; // [rad]
    std::vector<pattern::Vertex> corners;
    const std::size_t count = outline.vertices.size();
    for (std::size_t i = 0; i < count; ++i) {
        const Vec2 in = geometry::tangentAt(pattern::curveOf(outline, (i + count - 1) % count), 1);
        const Vec2 out = geometry::tangentAt(pattern::curveOf(outline, i), 0);
        if (std::abs(std::atan2(geometry::cross(in, out), geometry::dot(in, out))) > leastTurn)
            corners.push_back(outline.vertices[i]);
    }
    return corners;
}

/// Whether a corner was placed beyond the middle, on its mirror image's side. Of pieces of different layers one lies
/// over the other there, as the fronts of a shirt, and left and right are not meant to be alike.
bool overlapsItsImage(const Drape& drape, int source, const std::array<int, 2>& pair) {
    Vec3 sum;
    for (std::size_t t = 0; t < drape.piece.size(); ++t)
        if (drape.piece[t] == source)
            for (const int particle : drape.triangles[t]) sum += drape.start[particle];
    const double middle = 1e-3; // [m]; corners on the line itself are landmarks
    return sum.x > 0 ? drape.start[pair[0]].x < -middle : drape.start[pair[0]].x > middle;
}

/// What is buttoned hangs together for the verdict: the slits between its buttons are filled.
void closePlackets(Drape& drape, const Simulation& simulation) {
    std::vector<HeldTogether> tacks;
    const ParticleMap& particles = simulation.garment().particles;
    for (const TackState& tack : simulation.tacks()) {
        HeldTogether& held = tacks.emplace_back();
        for (std::size_t end = 0; end < 2; ++end) {
            const MeshPoint& at = tack.ends[end];
            held.piece[end] = at.piece;
            for (std::size_t k = 0; k < 3; ++k)
                held.place[end] += at.weights[k] * drape.positions[particles.particle({at.piece, at.nodes[k]})];
        }
    }
    const auto plackets = placketsOf(drape.triangles, drape.piece, drape.positions, tacks);
    drape.triangles.insert(drape.triangles.end(), plackets.begin(), plackets.end());
    drape.piece.insert(drape.piece.end(), plackets.size(), Drape::noPiece);
}

} // namespace

cloth::Patch elementsOf(const Garment& garment, std::size_t piece) {
    const meshing::PieceMesh& mesh = garment.mesh->pieces[piece];
    cloth::Patch patch;
    patch.material = mesh.material;
    const auto first = garment.particles.particleOf.begin() + garment.particles.firstNode[piece];
    patch.particles.assign(first, first + static_cast<std::ptrdiff_t>(mesh.nodes.size()));
    for (const meshing::Rectangle& cell : mesh.rectangles) patch.rectangles.push_back({cell.nodes, {}});
    for (const meshing::Triangle& t : mesh.triangles) patch.triangles.push_back({t.nodes, {}});
    return patch;
}

StrainSummary strainOf(const Simulation& simulation) {
    return summaryOf(strainsOf(simulation, [](const auto&) { return true; }));
}

std::optional<StrainSummary> wovenStrainOf(const Simulation& simulation) {
    const auto isWoven = [&](const pattern::Piece& piece) {
        const material::Fabric* fabric = pattern::findFabric(simulation.scene().pattern, piece.fabric);
        return fabric && fabric->kind == material::FabricKind::woven;
    };
    const std::vector<cloth::Strain> strains = strainsOf(simulation, isWoven);
    if (strains.empty()) return std::nullopt;
    StrainSummary summary = summaryOf(strains);
    const StrainSummary means = summaryOf(strainsOf(simulation, isWoven, judgedRadius));
    summary.warpMaximum = means.warpMaximum;
    summary.weftMaximum = means.weftMaximum;
    return summary;
}

CurvatureSummary curvatureOf(const Simulation& simulation) {
    double squares = 0, alternating = 0, area = 0;
    const Garment& garment = simulation.garment();
    for (std::size_t piece = 0; piece < garment.mesh->pieces.size(); ++piece)
        for (const cloth::Curvature& c : cloth::curvatures(elementsOf(garment, piece), simulation.state().positions)) {
            squares += c.area * c.value * c.value;
            alternating += c.area * c.alternating * c.alternating;
            area += c.area;
        }
    return area > 0 ? CurvatureSummary{std::sqrt(squares / area), std::sqrt(alternating / area)} : CurvatureSummary{};
}

Intersections intersectionsOf(const Simulation& simulation) {
    const geometry::TriangleMesh cloth = clothMesh(simulation);
    const auto pairs = collision::selfIntersectingTriangles(cloth);
    Intersections found;
    found.atOpenSeams = neighboursOnceSewn(pairs, cloth.triangles, whatBecomesOf(simulation.garment()));
    found.self = static_cast<int>(pairs.size()) - found.atOpenSeams;
    if (const collision::BodySurface* body = simulation.body())
        found.body = static_cast<int>(collision::intersectingTriangles(cloth, body->mesh()).size());
    return found;
}

ContactSummary contactOf(const Simulation& simulation) {
    ContactSummary summary;
    const Intersections intersections = intersectionsOf(simulation);
    summary.selfIntersections = intersections.self + intersections.atOpenSeams;
    summary.bodyIntersections = intersections.body;
    summary.layersApart = summary.selfIntersections == 0 || !simulation.scene().settings.selfContact;
    summary.nodesInWrongOrder =
        nodesInWrongOrder(simulation.scene().pattern, *simulation.garment().mesh, simulation.nodePositions());
    if (const auto* stage = dynamic_cast<const dynamics::SelfContact*>(simulation.plan().find("self-contact")))
        summary.guarantee = stage->guaranteed();
    const collision::BodySurface* body = simulation.body();
    if (!body) return summary;
    double least = std::numeric_limits<double>::infinity();
    constexpr double searchRadius = 0.1; // [m]; cloth farther off does not set the minimum
    for (const Vec3& p : simulation.state().positions)
        if (const auto nearest = body->nearest(p, searchRadius)) least = std::min(least, nearest->signedDistance);
    if (std::isfinite(least)) {
        summary.bodyClearanceMinimum = least;
        summary.bodyPenetrationMaximum = std::max(0.0, -least);
    }
    summary.outsideBody = summary.bodyIntersections == 0 && least >= simulation.scene().settings.skinOffset / 3;
    return summary;
}

Drape drapeOf(const Simulation& simulation) {
    const Garment& garment = simulation.garment();
    const pattern::Pattern& pattern = simulation.scene().pattern;
    Drape drape{particleTriangles(garment), simulation.state().positions, {}, {}, {}, wovenStrainOf(simulation)};
    const std::vector<Vec3> placed = placedNodes(pattern, *garment.mesh);
    drape.start.resize(garment.particles.particleCount);
    for (std::size_t piece = 0; piece < pattern.pieces.size(); ++piece)
        drape.piece.insert(drape.piece.end(), garment.mesh->pieces[piece].display.size(), static_cast<int>(piece));
    for (std::size_t node = 0; node < placed.size(); ++node)
        drape.start[garment.particles.particleOf[node]] = placed[node];

    for (std::size_t image = 0; image < pattern.pieces.size(); ++image) {
        if (!pattern.pieces[image]->mirror) continue;
        const auto source = std::ranges::find_if(
            pattern.pieces, [&](const auto& piece) { return piece->id == pattern.pieces[image]->mirror->source; });
        if (source == pattern.pieces.end()) continue;
        const auto sourceIndex = static_cast<int>(source - pattern.pieces.begin());
        const pattern::Piece resolved = pattern::resolved(pattern, *pattern.pieces[image]);
        for (const pattern::Vertex& vertex : landmarkVertices((*source)->outline)) {
            const auto left = nodeOf((*source)->outline, garment.mesh->pieces[sourceIndex], vertex.id);
            const auto right = nodeOf(resolved.outline, garment.mesh->pieces[image], vertex.id);
            if (!left || !right) continue;
            const std::array<int, 2> pair{garment.particles.particle({sourceIndex, *left}),
                                          garment.particles.particle({static_cast<int>(image), *right})};
            const bool liesOver = resolved.layer != (*source)->layer && overlapsItsImage(drape, sourceIndex, pair);
            if (!liesOver) drape.mirrorPairs.push_back(pair);
        }
    }
    closePlackets(drape, simulation);
    return drape;
}

std::string resultHash(const Simulation& simulation) {
    const Garment& garment = simulation.garment();
    std::vector<double> numbers;
    for (std::size_t piece = 0; piece < garment.mesh->pieces.size(); ++piece) {
        const meshing::PieceMesh& mesh = garment.mesh->pieces[piece];
        std::vector<int> order(mesh.nodes.size());
        std::iota(order.begin(), order.end(), 0);
        std::ranges::stable_sort(order, {},
                                 [&](int node) { return std::pair(mesh.material[node].y, mesh.material[node].x); });
        for (const int node : order) {
            const Vec3& p =
                simulation.state().positions[garment.particles.particleOf[garment.particles.firstNode[piece] + node]];
            numbers.insert(numbers.end(), {p.x, p.y, p.z});
        }
    }
    return sha256(std::as_bytes(std::span(numbers)));
}

} // namespace toile::simulation
