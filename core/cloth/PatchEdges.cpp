// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cloth/PatchEdges.h"

#include "core/base/Contracts.h"
#include "core/cloth/NodeChains.h"

#include <algorithm>
#include <map>

namespace toile::cloth {
namespace {

/// The slaves of a patch, found by where they lie.
class SlaveFinder {
public:
    explicit SlaveFinder(const Patch& patch) : patch_(patch), bears_(patch.material.size(), 0) {
        for (int s = 0; s < static_cast<int>(patch.slaves.size()); ++s) {
            byNode_[patch.slaves[s].node] = s;
            bears_[patch.slaves[s].node] = 1;
            for (const auto& [master, weight] : patch.slaves[s].masters) bears_[master] = 1;
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
        if (!bears_[a] && !bears_[b]) return {};
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
    std::vector<char> bears_; ///< of each node: a master or a slave; others have no slave beside them
    std::vector<int> rows_, columns_;
    std::map<int, int> byNode_;
};

class EdgeCollector {
public:
    EdgeCollector(std::size_t nodes, std::size_t expected) : byNode_(nodes, expected) { edges_.reserve(expected); }

    void add(int a, int b, const EdgeSide& side) {
        const int low = std::min(a, b), high = std::max(a, b);
        const int known =
            byNode_.find(low, [&](int entry) { return std::max(edges_[entry].a, edges_[entry].b) == high; });
        if (known < 0) {
            edges_.push_back({a, b, side, {}});
            byNode_.add(low);
            return;
        }
        expects(!edges_[known].isInner(), "an edge of a patch has at most two cells");
        edges_[known].second = side;
    }
    [[nodiscard]] std::vector<PatchEdge> take() { return std::move(edges_); }

private:
    std::vector<PatchEdge> edges_;
    NodeChains byNode_; ///< the smaller of both
};

} // namespace

std::vector<PatchEdge> edgesOf(const Patch& patch) {
    const SlaveFinder slaves(patch);
    EdgeCollector edges(patch.material.size(), 2 * patch.rectangles.size() + 2 * patch.triangles.size() + 16);
    for (int r = 0; r < static_cast<int>(patch.rectangles.size()); ++r)
        for (std::int8_t side = 0; side < 4; ++side) {
            const auto& nodes = patch.rectangles[r].nodes;
            int last = nodes[side];
            double from = 0;
            for (const auto& [t, node] : slaves.between(nodes[side], nodes[(side + 1) % 4])) {
                edges.add(last, node, {from, t, r, true, side});
                last = node;
                from = t;
            }
            edges.add(last, nodes[(side + 1) % 4], {from, 1, r, true, side});
        }
    for (int t = 0; t < static_cast<int>(patch.triangles.size()); ++t)
        for (std::int8_t side = 0; side < 3; ++side)
            edges.add(patch.triangles[t].nodes[side], patch.triangles[t].nodes[(side + 1) % 3], {0, 1, t, false, side});
    return edges.take();
}

} // namespace toile::cloth
