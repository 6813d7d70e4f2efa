// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/meshing/FinishedPiece.h"

#include "core/base/Contracts.h"
#include "core/meshing/DisplayTriangles.h"

#include <algorithm>
#include <map>
#include <numeric>

namespace toile::meshing {
namespace {

std::size_t at(int i) {
    return static_cast<std::size_t>(i);
}

using Masters = std::vector<std::pair<int, double>>;

/// The masters of every hanging node, as the sides say; a master may hang itself.
std::map<int, Masters> directMasters(const CellMesh& cells) {
    std::map<int, Masters> masters;
    for (const Cell& cell : cells.cells)
        for (std::size_t side = 0; side < 4; ++side) {
            const int a = cell.corners[side], b = cell.corners[(side + 1) % 4];
            const Vec2 from = cells.position[at(a)], along = cells.position[at(b)] - from;
            for (const int node : cell.hanging[side]) {
                const double t = dot(cells.position[at(node)] - from, along) / squaredLength(along);
                masters[node] = {{a, 1 - t}, {b, t}};
            }
        }
    return masters;
}

/// Adds the free nodes that a node stands on, with weights.
void collectMasters(const std::map<int, Masters>& direct, int node, double weight, int depth,
                    std::map<int, double>& result) {
    expects(depth < 64, "chains of hanging nodes end");
    const auto found = direct.find(node);
    if (found == direct.end()) {
        result[node] += weight;
        return;
    }
    for (const auto& [master, share] : found->second)
        collectMasters(direct, master, weight * share, depth + 1, result);
}

std::vector<int> mortonNumbers(const CellMesh& cells, const std::map<int, Masters>& slaves) {
    std::vector<int> order(cells.grid.size());
    std::iota(order.begin(), order.end(), 0);
    std::vector<std::pair<bool, std::uint64_t>> key;
    for (std::size_t i = 0; i < order.size(); ++i)
        key.emplace_back(slaves.contains(static_cast<int>(i)), mortonCode(cells.grid[i]));
    std::sort(order.begin(), order.end(), [&](int a, int b) { return key[at(a)] < key[at(b)]; });
    std::vector<int> numbers(order.size());
    for (std::size_t i = 0; i < order.size(); ++i) numbers[at(order[i])] = static_cast<int>(i);
    return numbers;
}

} // namespace

FinishedPiece finishedPiece(const PieceFrame& frame, const BoundaryNodes& boundary, const CellMesh& cells) {
    const std::map<int, Masters> direct = directMasters(cells);
    FinishedPiece finished{{}, mortonNumbers(cells, direct)};
    const auto& numbers = finished.numbers;
    const auto number = [&](int node) { return numbers[at(node)]; };
    PieceMesh& mesh = finished.mesh;
    const bool mirrored = frame.side < 0;

    mesh.nodes.resize(cells.position.size());
    mesh.material.resize(cells.position.size());
    for (std::size_t i = 0; i < cells.position.size(); ++i) {
        const std::size_t n = at(numbers[i]);
        mesh.nodes[n] = static_cast<int>(i) < cells.boundaryCount ? boundary.points[i]
                                                                  : frame.pointFromFrame(cells.position[i]);
        mesh.material[n] = frame.materialFromFrame(cells.position[i]);
    }
    for (const Cell& cell : cells.cells) {
        std::array<int, 4> c{};
        for (std::size_t i = 0; i < 4; ++i) c[i] = number(cell.corners[i]);
        if (mirrored) c = {c[1], c[0], c[3], c[2]};
        mesh.rectangles.push_back({c, cell.region});
    }
    const auto turned = [&](std::array<int, 3> t) {
        for (int& node : t) node = number(node);
        if (mirrored) std::swap(t[1], t[2]);
        return t;
    };
    for (const Triangle& triangle : cells.triangles)
        mesh.triangles.push_back({turned(triangle.nodes), triangle.region, triangle.mergedWith});

    for (const auto& [node, masters] : direct) {
        std::map<int, double> free;
        collectMasters(direct, node, 1, 0, free);
        SlaveNode slave{number(node), {}};
        for (const auto& [master, weight] : free) slave.masters.emplace_back(number(master), weight);
        std::sort(slave.masters.begin(), slave.masters.end());
        mesh.slaves.push_back(std::move(slave));
    }
    std::sort(mesh.slaves.begin(), mesh.slaves.end(),
              [](const SlaveNode& a, const SlaveNode& b) { return a.node < b.node; });

    mesh.loops = boundary.loops;
    for (auto& loop : mesh.loops)
        for (EdgeNodes& edge : loop)
            for (EdgeNode& node : edge) node.node = number(node.node);

    std::vector<std::array<int, 3>> display;
    for (const Cell& cell : cells.cells) appendCellTriangles(cells.position, cell, display);
    for (const Triangle& triangle : cells.triangles) display.push_back(triangle.nodes);
    for (const auto& triangle : display) mesh.display.push_back(turned(triangle));
    return finished;
}

} // namespace toile::meshing
