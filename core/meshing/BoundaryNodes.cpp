// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/meshing/BoundaryNodes.h"
#include "core/base/Index.h"

#include "core/meshing/Crossings.h"

#include <algorithm>

namespace toile::meshing {
namespace {

class Walk {
public:
    Walk(const PieceInput& piece, int pieceIndex, const PieceBoundary& boundary, const BoundaryDivision& division,
         Arena& arena, BoundaryNodes& nodes)
        : piece_(piece), pieceIndex_(pieceIndex), boundary_(boundary), division_(division), nodes_(nodes),
          fractions_(&arena), waiting_(&arena) {}

    void run() {
        std::size_t most = 0;
        for (int loop = 0; loop < loopCount(piece_); ++loop) most += division_.mostNodes(pieceIndex_, loop);
        nodes_.points.clear();
        nodes_.grid.clear();
        nodes_.points.reserve(most);
        nodes_.grid.reserve(most);
        fractions_.reserve(most);
        nodes_.loops.resize(at(loopCount(piece_)));
        nodes_.rings.resize(at(loopCount(piece_)));
        nodes_.spots.resize(at(loopCount(piece_)));
        for (int loop = 0; loop < loopCount(piece_); ++loop) walkLoop(loop);
    }

private:
    void walkLoop(int loop) {
        const BoundaryLoop& edges = loopOf(piece_, loop);
        const Vec2 start = edges.front().curve.start;
        const int first = addNode(start, gridOf(start));
        int current = first;
        std::vector<int>& ring = nodes_.rings[at(loop)];
        std::vector<BoundarySpot>& spots = nodes_.spots[at(loop)];
        ring.reserve(division_.mostNodes(pieceIndex_, loop));
        spots.reserve(division_.mostNodes(pieceIndex_, loop));
        ring.assign(1, first);
        spots.clear();
        auto& lists = nodes_.loops[at(loop)];
        lists.resize(edges.size());
        waiting_.clear();
        for (int e = 0, n = static_cast<int>(edges.size()); e < n; ++e) {
            EdgeNodes& list = lists[at(e)];
            const int before = current;
            const EdgeArc& arc = boundary_.loops[at(loop)].edges[at(e)];
            if (arc.collapsed) {
                list.assign({{before, 0}, {before, 1}});
            } else if (division_.passesEnd(pieceIndex_, loop, e)) {
                list.assign({{before, 0}});
                waiting_.push_back(at(e));
            } else {
                division_.listFractions(pieceIndex_, loop, e, fractions_);
                list.reserve(fractions_.size());
                list.assign(1, {before, 0});
                for (std::size_t k = 1; k < fractions_.size(); ++k) {
                    const bool last = k + 1 == fractions_.size();
                    const Vec2 point = last ? edges[at(e)].curve.end : arc.arc.pointAt(fractions_[k]);
                    current = last && isLast(loop, e) ? first : nextNode(current, point);
                    if (current != ring.back()) {
                        ring.push_back(current);
                        spots.push_back({loop, e, 0.5 * (fractions_[k - 1] + fractions_[k])});
                    }
                    list.push_back({current, fractions_[k]});
                    for (const std::size_t edge : waiting_) lists[edge].push_back({current, 1});
                    waiting_.clear();
                }
            }
        }
        closeRing(loop);
    }

    [[nodiscard]] bool isLast(int loop, int edge) const {
        const auto& edges = boundary_.loops[at(loop)].edges;
        for (std::size_t later = at(edge) + 1; later < edges.size(); ++later)
            if (!edges[later].collapsed) return false;
        return true;
    }

    [[nodiscard]] GridPoint gridOf(Vec2 point) const { return boundary_.frame.gridOf(boundary_.frame.frameOf(point)); }

    int addNode(Vec2 point, GridPoint grid) {
        nodes_.points.push_back(point);
        nodes_.grid.push_back(grid);
        return static_cast<int>(nodes_.points.size()) - 1;
    }

    /// The node at a point; the current one if they are the same grid point.
    int nextNode(int current, Vec2 point) {
        const GridPoint grid = gridOf(point);
        return grid == nodes_.grid[at(current)] ? current : addNode(point, grid);
    }

    void closeRing(int loop) {
        std::vector<int>& ring = nodes_.rings[at(loop)];
        std::vector<BoundarySpot>& spots = nodes_.spots[at(loop)];
        if (ring.size() > 1 && ring.back() == ring.front()) ring.pop_back();
        while (spots.size() < ring.size()) spots.push_back(spots.empty() ? BoundarySpot{loop, 0, 0.5} : spots.back());
        if (!boundary_.loops[at(loop)].backwards) return;
        std::reverse(ring.begin() + 1, ring.end());
        std::reverse(spots.begin(), spots.end());
    }

    const PieceInput& piece_;
    int pieceIndex_;
    const PieceBoundary& boundary_;
    const BoundaryDivision& division_;
    BoundaryNodes& nodes_;
    std::pmr::vector<double> fractions_;
    std::pmr::vector<std::size_t> waiting_; ///< edges of a run whose next node is not reached yet
};

using Rings = std::pmr::vector<std::pmr::vector<GridPoint>>;

Rings ringPoints(const BoundaryNodes& nodes, Arena& arena) {
    Rings rings(&arena);
    for (const auto& ring : nodes.rings) {
        auto& points = rings.emplace_back();
        points.reserve(ring.size());
        for (const int node : ring) points.push_back(nodes.grid[at(node)]);
    }
    return rings;
}

} // namespace

void freezeNodes(const PieceInput& piece, int pieceIndex, const PieceBoundary& boundary,
                 const BoundaryDivision& division, Arena& arena, BoundaryNodes& nodes) {
    Walk(piece, pieceIndex, boundary, division, arena, nodes).run();
}

std::pmr::vector<BoundarySpot> spotsTooCoarse(const BoundaryNodes& nodes, Arena& arena) {
    std::pmr::vector<BoundarySpot> spots(&arena);
    const Rings rings = ringPoints(nodes, arena);
    for (std::size_t r = 0; r < rings.size(); ++r) {
        WideInt doubledArea = 0;
        for (std::size_t i = 1; i + 1 < rings[r].size(); ++i)
            doubledArea += orientation(rings[r][0], rings[r][i], rings[r][i + 1]);
        const bool turned = r == 0 ? doubledArea <= 0 : doubledArea >= 0;
        const bool misplaced = r > 0 && !isInside(rings[0], rings[r].front());
        if (rings[r].size() < 3 || turned) spots.insert(spots.end(), nodes.spots[r].begin(), nodes.spots[r].end());
        if (misplaced) spots.insert(spots.end(), nodes.spots[0].begin(), nodes.spots[0].end());
    }
    if (!spots.empty()) return spots;
    std::pmr::vector<RingSegment> segments(&arena);
    segments.reserve(nodes.points.size());
    for (std::size_t r = 0; r < rings.size(); ++r) appendSegments(rings[r], static_cast<int>(r), segments);
    for (const auto& [i, j] : allCrossings(segments, arena))
        for (const int s : {i, j}) {
            const RingSegment& segment = segments[at(s)];
            spots.push_back(nodes.spots[at(segment.ring)][at(segment.index)]);
        }
    return spots;
}

} // namespace toile::meshing
