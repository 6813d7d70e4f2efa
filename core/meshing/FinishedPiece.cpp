// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/meshing/FinishedPiece.h"

#include "core/base/Contracts.h"
#include "core/meshing/DisplayTriangles.h"

#include <algorithm>
#include <bit>
#include <cstdlib>
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
    for (const Cell& cell : cells.layer.cells)
        for (std::size_t side = 0; cell.hanging >= 0 && side < 4; ++side) {
            const int a = cell.corners[side], b = cell.corners[(side + 1) % 4];
            const Vec2 from = cells.position[at(a)], along = cells.position[at(b)] - from;
            for (const int node : hangingOn(cells.layer, cell, side)) {
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
    for (const auto& [master, share] : found->second) collectMasters(direct, master, weight * share, depth + 1, result);
}

using KeyedNode = std::pair<std::uint64_t, int>;

/// Sorts by key: counts over as many of the leading bits that vary as tell most nodes apart, then what is
/// left.
void sortByKey(std::vector<KeyedNode>& nodes) {
    std::uint64_t varying = 0;
    for (const KeyedNode& node : nodes) varying |= node.first ^ nodes.front().first;
    const int high = static_cast<int>(std::bit_width(varying));
    const int low = std::max(0, high - static_cast<int>(std::bit_width(nodes.size())) - 5);
    constexpr int digit = 11; // bits
    std::vector<KeyedNode> sorted(nodes.size());
    for (int shift = low; shift < high; shift += digit) {
        std::array<std::size_t, (1 << digit) + 1> first{};
        const auto digitOf = [shift](std::uint64_t key) {
            return static_cast<std::size_t>((key >> shift) & ((1 << digit) - 1));
        };
        for (const KeyedNode& node : nodes) ++first[digitOf(node.first) + 1];
        std::partial_sum(first.begin(), first.end(), first.begin());
        for (const KeyedNode& node : nodes) sorted[first[digitOf(node.first)]++] = node;
        std::swap(nodes, sorted);
    }
    for (auto run = nodes.begin(); run != nodes.end();) {
        auto end = run + 1;
        while (end != nodes.end() && end->first >> low == run->first >> low) ++end;
        if (end - run > 1) std::sort(run, end);
        run = end;
    }
}

/// A power of two that no coordinate of the points reaches.
std::int32_t reach(const std::vector<GridPoint>& points) {
    std::uint32_t bits = 0;
    for (const GridPoint p : points) bits |= static_cast<std::uint32_t>(std::abs(p.x) | std::abs(p.y));
    return static_cast<std::int32_t>(std::bit_ceil(bits + 1));
}

std::vector<int> mortonNumbers(const CellMesh& cells, const std::map<int, Masters>& slaves) {
    std::vector<KeyedNode> free, hanging;
    free.reserve(cells.grid.size());
    const std::int32_t origin = reach(cells.grid) - gridLimit; // the same order by fewer bits
    for (std::size_t i = 0; i < cells.grid.size(); ++i) {
        const int node = static_cast<int>(i);
        auto& list = !slaves.empty() && slaves.contains(node) ? hanging : free;
        const GridPoint point = cells.grid[i];
        list.emplace_back(mortonCode({point.x + origin, point.y + origin}), node);
    }
    std::vector<int> numbers(cells.grid.size());
    int next = 0;
    for (auto* list : {&free, &hanging}) {
        if (!list->empty()) sortByKey(*list);
        for (const auto& [key, node] : *list) numbers[at(node)] = next++;
    }
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
    const Vec2 warp = geometry::rotated({0, 1}, frame.grain), weft = geometry::rotated({1, 0}, frame.grain);
    for (std::size_t i = 0; i < cells.position.size(); ++i) {
        const std::size_t n = at(numbers[i]);
        const Vec2 material = mesh.material[n] = frame.materialFromFrame(cells.position[i]);
        mesh.nodes[n] =
            static_cast<int>(i) < cells.boundaryCount ? boundary.points[i] : weft * material.x + warp * material.y;
    }
    mesh.rectangles.reserve(cells.layer.cells.size());
    for (const Cell& cell : cells.layer.cells) {
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
    mesh.triangles.reserve(cells.triangles.size());
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

    mesh.display.reserve(2 * cells.layer.cells.size() + cells.triangles.size());
    for (const Cell& cell : cells.layer.cells) appendCellTriangles(cells, cell, mesh.display);
    for (const Triangle& triangle : cells.triangles) mesh.display.push_back(triangle.nodes);
    for (auto& triangle : mesh.display) triangle = turned(triangle);
    return finished;
}

} // namespace toile::meshing
