// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/Topology.h"

#include "core/meshing/DisplayElements.h"
#include "core/simulation/PinNodes.h"

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
                                   static_cast<int>(piece.display.size()), pattern.pieces[i]->plies > 1});
        topology.material.insert(topology.material.end(), piece.material.begin(), piece.material.end());
        for (const auto& [a, b, c] : piece.display) topology.triangles.push_back({first + a, first + b, first + c});
        for (const int element : meshing::displayElements(piece))
            topology.triangleRegion.push_back(meshing::regionOf(piece, element));
        std::ranges::copy(meshLinesOf(piece, first), std::back_inserter(topology.meshLines));
    }
    for (const meshing::SeamNodes& seam : mesh.seams) {
        auto& pairs = topology.seams.emplace_back();
        for (const auto& [a, b] : seam.pairs)
            pairs.push_back({firstNode[a.piece] + a.node, firstNode[b.piece] + b.node});
    }
    for (const pattern::Pin& pin : pattern.pins)
        if (const auto node = nodeOf(pin, pattern, mesh))
            topology.pins.push_back({firstNode[node->piece] + node->node, pin.toBody});
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
