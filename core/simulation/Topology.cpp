// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/Topology.h"

#include <algorithm>

namespace toile::simulation {
namespace {

/// Edges of rectangles and triangles, each once; the inner edge of a merged pair is left out.
std::vector<std::array<int, 2>> meshLinesOf(const meshing::PieceMesh& mesh, int firstNode) {
    std::vector<std::array<int, 2>> lines;
    const auto add = [&](int a, int b) { lines.push_back({firstNode + std::min(a, b), firstNode + std::max(a, b)}); };
    for (const meshing::Rectangle& cell : mesh.rectangles)
        for (std::size_t i = 0; i < 4; ++i) add(cell.nodes[i], cell.nodes[(i + 1) % 4]);
    const auto belongsTo = [](const meshing::Triangle& t, int node) { return std::ranges::count(t.nodes, node) > 0; };
    for (const meshing::Triangle& t : mesh.triangles)
        for (std::size_t i = 0; i < 3; ++i) {
            const int a = t.nodes[i], b = t.nodes[(i + 1) % 3];
            const bool inner = t.mergedWith >= 0 && belongsTo(mesh.triangles[t.mergedWith], a) &&
                               belongsTo(mesh.triangles[t.mergedWith], b);
            if (!inner) add(a, b);
        }
    std::ranges::sort(lines);
    const auto [first, last] = std::ranges::unique(lines);
    lines.erase(first, last);
    return lines;
}

/// Region of each display triangle: that of the element which holds its first edge; found by shared corners.
std::vector<int> displayRegions(const meshing::PieceMesh& mesh) {
    std::vector<std::vector<std::pair<int, int>>> elementsAt(mesh.nodes.size()); // node -> (element, region)
    int element = 0;
    for (const meshing::Rectangle& cell : mesh.rectangles) {
        for (const int node : cell.nodes) elementsAt[node].push_back({element, cell.region});
        ++element;
    }
    for (const meshing::Triangle& t : mesh.triangles) {
        for (const int node : t.nodes) elementsAt[node].push_back({element, t.region});
        ++element;
    }
    std::vector<int> regions;
    for (const std::array<int, 3>& triangle : mesh.display) {
        int best = 0, region = -1;
        for (const int corner : triangle)
            for (const auto& [candidate, itsRegion] : elementsAt[corner]) {
                const int shared = static_cast<int>(std::ranges::count_if(triangle, [&](int node) {
                    return std::ranges::any_of(elementsAt[node], [&](const auto& e) { return e.first == candidate; });
                }));
                if (shared > best) {
                    best = shared;
                    region = itsRegion;
                }
            }
        regions.push_back(region);
    }
    return regions;
}

} // namespace

FrameTopology topologyOf(const pattern::Pattern& pattern, const meshing::GarmentMesh& mesh) {
    FrameTopology topology;
    std::vector<int> firstNode;
    for (std::size_t i = 0; i < mesh.pieces.size(); ++i) {
        const meshing::PieceMesh& piece = mesh.pieces[i];
        const int first = static_cast<int>(topology.material.size());
        firstNode.push_back(first);
        topology.pieces.push_back({pattern.pieces[i]->id.value, pattern.pieces[i]->name, first,
                                   static_cast<int>(piece.nodes.size()), static_cast<int>(topology.triangles.size()),
                                   static_cast<int>(piece.display.size())});
        topology.material.insert(topology.material.end(), piece.material.begin(), piece.material.end());
        for (const auto& [a, b, c] : piece.display) topology.triangles.push_back({first + a, first + b, first + c});
        std::ranges::copy(displayRegions(piece), std::back_inserter(topology.triangleRegion));
        std::ranges::copy(meshLinesOf(piece, first), std::back_inserter(topology.meshLines));
    }
    for (const meshing::SeamNodes& seam : mesh.seams) {
        auto& pairs = topology.seams.emplace_back();
        for (const auto& [a, b] : seam.pairs)
            pairs.push_back({firstNode[a.piece] + a.node, firstNode[b.piece] + b.node});
    }
    return topology;
}

std::vector<Vec3> placedNodes(const pattern::Pattern& pattern, const meshing::GarmentMesh& mesh) {
    std::vector<Vec3> positions;
    for (std::size_t i = 0; i < mesh.pieces.size(); ++i) {
        const pattern::Placement placement = pattern.pieces[i]->placement.value_or(pattern::Placement{});
        for (const Vec2 node : mesh.pieces[i].nodes) positions.push_back(pattern::placed(placement, node));
    }
    return positions;
}

} // namespace toile::simulation
