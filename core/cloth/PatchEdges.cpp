// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cloth/PatchEdges.h"

#include "core/base/Contracts.h"
#include "core/cloth/NodeIndex.h"

#include <algorithm>
#include <map>

namespace toile::cloth {
namespace {

/// The slaves of a patch, found by where they lie.
class SlaveFinder {
public:
    explicit SlaveFinder(const Patch& patch) : patch_(patch) {
        for (int s = 0; s < static_cast<int>(patch.slaves.size()); ++s) {
            byNode_[patch.slaves[s].node] = s;
            rows_.push_back(s);
            columns_.push_back(s);
        }
        std::ranges::sort(rows_, {}, [&](int s) { return place(s).y; });
        std::ranges::sort(columns_, {}, [&](int s) { return place(s).x; });
    }

    struct Hit {
        double t;
        int node;
    };

    /// Slaves strictly between nodes a and b of a grain-parallel side, from a to b.
    [[nodiscard]] std::vector<Hit> between(int a, int b) const {
        const Vec2 from = patch_.material[a], along = patch_.material[b] - from;
        const bool horizontal = std::abs(along.x) > std::abs(along.y);
        const double length = geometry::length(along), tolerance = 1e-6 * length;
        const auto& order = horizontal ? rows_ : columns_;
        const auto across = [&](int s) { return horizontal ? place(s).y : place(s).x; };
        const double level = horizontal ? from.y : from.x;
        std::vector<Hit> hits;
        for (auto it = std::ranges::lower_bound(order, level - tolerance, {}, across);
             it != order.end() && across(*it) <= level + tolerance; ++it) {
            const double t = dot(place(*it) - from, along) / (length * length);
            if (t > 1e-6 && t < 1 - 1e-6 && hangsOn(*it, a, b)) hits.push_back({t, patch_.slaves[*it].node});
        }
        std::ranges::sort(hits, {}, &Hit::t);
        return hits;
    }

private:
    [[nodiscard]] Vec2 place(int slave) const { return patch_.material[patch_.slaves[slave].node]; }

    /// Its masters are a and b, or theirs: two nodes on the two sides of a slit may share a place.
    [[nodiscard]] bool hangsOn(int slave, int a, int b) const {
        return std::ranges::all_of(patch_.slaves[slave].masters, [&](const auto& master) {
            return stands(master.first, a) || stands(master.first, b);
        });
    }
    [[nodiscard]] bool stands(int master, int node) const {
        if (master == node) return true;
        const auto it = byNode_.find(node);
        return it != byNode_.end() &&
               std::ranges::any_of(patch_.slaves[it->second].masters, [&](const auto& m) { return m.first == master; });
    }

    const Patch& patch_;
    std::vector<int> rows_, columns_;
    std::map<int, int> byNode_;
};

class EdgeCollector {
public:
    explicit EdgeCollector(std::size_t expected) : byNodes_(expected) { edges_.reserve(expected); }

    void add(int a, int b, const EdgeSide& side) {
        const int next = static_cast<int>(edges_.size());
        const int index = byNodes_.findOrAdd({std::min(a, b), std::max(a, b)}, next);
        if (index == next) {
            edges_.push_back({a, b, side, {}});
            return;
        }
        PatchEdge& edge = edges_[index];
        expects(!edge.isInner(), "an edge of a patch has at most two cells");
        edge.second = side;
    }
    [[nodiscard]] std::vector<PatchEdge> take() { return std::move(edges_); }

private:
    std::vector<PatchEdge> edges_;
    NodeIndex<2> byNodes_;
};

} // namespace

std::vector<PatchEdge> edgesOf(const Patch& patch) {
    const SlaveFinder slaves(patch);
    EdgeCollector edges(2 * patch.rectangles.size() + 2 * patch.triangles.size() + 16);
    for (int r = 0; r < static_cast<int>(patch.rectangles.size()); ++r)
        for (int side = 0; side < 4; ++side) {
            const auto& nodes = patch.rectangles[r].nodes;
            int last = nodes[side];
            double from = 0;
            for (const auto& [t, node] : slaves.between(nodes[side], nodes[(side + 1) % 4])) {
                edges.add(last, node, {true, r, side, from, t});
                last = node;
                from = t;
            }
            edges.add(last, nodes[(side + 1) % 4], {true, r, side, from, 1});
        }
    for (int t = 0; t < static_cast<int>(patch.triangles.size()); ++t)
        for (int side = 0; side < 3; ++side)
            edges.add(patch.triangles[t].nodes[side], patch.triangles[t].nodes[(side + 1) % 3], {false, t, side, 0, 1});
    return edges.take();
}

} // namespace toile::cloth
