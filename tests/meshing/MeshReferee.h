// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/meshing/MeshFixtures.h"

#include <algorithm>
#include <numeric>
#include <set>
#include <span>

/// What must hold for every mesh, found without the mesher's own lists.
namespace toile::meshing {

/// The sides of all triangles of a mesh, each in the direction its triangle walks it.
class DirectedSides {
public:
    explicit DirectedSides(const PieceMesh& mesh) : first_(mesh.nodes.size() + 2) {
        for (const auto& t : mesh.display)
            for (const int node : t) ++first_[static_cast<std::size_t>(node) + 2];
        std::partial_sum(first_.begin(), first_.end(), first_.begin());
        ends_.resize(3 * mesh.display.size());
        for (const auto& t : mesh.display)
            for (std::size_t i = 0; i < 3; ++i) ends_[first_[static_cast<std::size_t>(t[i]) + 1]++] = t[(i + 1) % 3];
    }
    std::size_t size() const { return ends_.size(); }
    bool contains(int from, int to) const { return std::ranges::count(endsFrom(from), to) > 0; }
    bool hasTwice() const {
        for (int from = 0; from < nodes(); ++from)
            for (const int to : endsFrom(from))
                if (std::ranges::count(endsFrom(from), to) > 1) return true;
        return false;
    }
    /// Those of one triangle alone, low node first, sorted.
    std::vector<std::array<int, 2>> open() const {
        std::vector<std::array<int, 2>> result;
        for (int from = 0; from < nodes(); ++from)
            for (const int to : endsFrom(from))
                if (!contains(to, from)) result.push_back({std::min(from, to), std::max(from, to)});
        std::ranges::sort(result);
        return result;
    }

private:
    int nodes() const { return static_cast<int>(first_.size()) - 2; }
    std::span<const int> endsFrom(int node) const {
        const std::size_t begin = first_[static_cast<std::size_t>(node)];
        return std::span(ends_).subspan(begin, first_[static_cast<std::size_t>(node) + 1] - begin);
    }

    std::vector<std::size_t> first_; ///< of each node's sides in ends_
    std::vector<int> ends_;          ///< where the sides lead
};

/// The segments between neighbouring nodes of the borders, low node first, sorted, each once.
inline std::vector<std::array<int, 2>> borderSegments(const PieceMesh& mesh) {
    std::vector<std::array<int, 2>> border;
    for (const auto& loop : mesh.loops)
        for (const EdgeNodes& edge : loop)
            for (std::size_t k = 0; k + 1 < edge.size(); ++k)
                if (edge[k].node != edge[k + 1].node)
                    border.push_back(
                        {std::min(edge[k].node, edge[k + 1].node), std::max(edge[k].node, edge[k + 1].node)});
    std::ranges::sort(border);
    border.erase(std::unique(border.begin(), border.end()), border.end());
    return border;
}

/// The triangles are a disk with so many holes, whose border is the piece's; empty when they are.
inline std::string surfaceDefectOf(const PieceMesh& mesh, int holes) {
    const auto at = [](int i) { return static_cast<std::size_t>(i); };
    std::vector<bool> used(mesh.nodes.size());
    for (const auto& t : mesh.display) {
        if (triangleArea(mesh.nodes[at(t[0])], mesh.nodes[at(t[1])], mesh.nodes[at(t[2])]) <= 0)
            return "an inverted triangle";
        for (const int node : t) used[at(node)] = true;
    }
    if (std::ranges::find(used, false) != used.end()) return "a node without a triangle";
    const DirectedSides sides(mesh);
    if (sides.hasTwice()) return "an edge used twice in one direction";
    const auto open = sides.open(), border = borderSegments(mesh);
    if (!std::ranges::includes(border, open)) return "a crack or an edge beside the border";
    if (open.size() != border.size()) return "a border segment that bears no triangle";
    const std::size_t edges = (sides.size() + open.size()) / 2;
    const long euler =
        static_cast<long>(mesh.nodes.size()) - static_cast<long>(edges) + static_cast<long>(mesh.display.size());
    if (euler != 1 - holes) return "Euler's number is " + std::to_string(euler);
    if (std::abs(displayArea(mesh) - boundaryArea(mesh)) > 1e-9 * boundaryArea(mesh)) return "the areas differ";
    return {};
}

/// Slaves lie inside, at the weighted mean of masters that are free; empty when they do.
inline std::string slaveDefectOf(const PieceMesh& mesh) {
    const auto at = [](int i) { return static_cast<std::size_t>(i); };
    std::vector<bool> isSlave(mesh.nodes.size()), onBorder(mesh.nodes.size());
    for (const SlaveNode& slave : mesh.slaves) isSlave[at(slave.node)] = true;
    for (const auto& [low, high] : borderSegments(mesh)) onBorder[at(low)] = onBorder[at(high)] = true;
    for (const SlaveNode& slave : mesh.slaves) {
        Vec2 sum;
        double weights = 0;
        for (const auto& [master, weight] : slave.masters) {
            if (isSlave[at(master)]) return "a slave of a slave";
            sum += mesh.material[at(master)] * weight;
            weights += weight;
        }
        if (onBorder[at(slave.node)]) return "a slave on the border";
        if (std::abs(weights - 1) > 1e-14) return "weights that do not sum to one";
        if (distance(sum, mesh.material[at(slave.node)]) > 1e-12) return "a slave beside its masters' line";
    }
    return {};
}

/// What must hold for every mesh; empty when it does.
inline std::string defectOf(const PieceMesh& mesh, int holes = 0) {
    if (std::string defect = surfaceDefectOf(mesh, holes); !defect.empty()) return defect;
    for (const Rectangle& r : mesh.rectangles) {
        const auto corner = [&](std::size_t i) { return mesh.material[static_cast<std::size_t>(r.nodes[i])]; };
        if (corner(0).y != corner(1).y || corner(1).x != corner(2).x || corner(2).y != corner(3).y ||
            corner(3).x != corner(0).x || corner(1).x <= corner(0).x || corner(3).y <= corner(0).y)
            return "a rectangle that is none";
    }
    return slaveDefectOf(mesh);
}

/// Every two neighbours of a fold's nodes are a side of an element on either side of it, and lie on its line; empty
/// when they are.
inline std::string foldDefectOf(const PieceMesh& mesh, const FoldReport& report, double spacing) {
    // A bend of less than 15° half-way between two nodes is cut off by half a spacing · sin(7.5°).
    if (report.deviation > 0.0653 * spacing)
        return "the fold is " + std::to_string(report.deviation) + " m beside its line";
    const DirectedSides sides(mesh);
    std::set<std::array<int, 2>> creases;
    for (const auto& fold : mesh.folds)
        for (std::size_t i = 0; i + 1 < fold.size(); ++i) {
            if (!sides.contains(fold[i], fold[i + 1]) || !sides.contains(fold[i + 1], fold[i]))
                return "a side of the fold that bears no triangle";
            creases.insert({std::min(fold[i], fold[i + 1]), std::max(fold[i], fold[i + 1])});
        }
    for (const Triangle& t : mesh.triangles) {
        if (t.mergedWith < 0) continue;
        const Triangle& other = mesh.triangles[static_cast<std::size_t>(t.mergedWith)];
        for (const auto& [a, b] : creases) {
            const auto has = [&, a = a, b = b](const Triangle& one) {
                return std::ranges::count(one.nodes, a) > 0 && std::ranges::count(one.nodes, b) > 0;
            };
            if (has(t) && has(other)) return "a quadrilateral across the fold";
        }
    }
    return {};
}

} // namespace toile::meshing
