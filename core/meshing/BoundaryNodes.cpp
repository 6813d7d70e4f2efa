// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/meshing/BoundaryNodes.h"

#include "core/meshing/Crossings.h"

#include <algorithm>
#include <utility>

namespace toile::meshing {
namespace {

std::size_t at(int i) {
    return static_cast<std::size_t>(i);
}

class Walk {
public:
    Walk(const PieceInput& piece, int pieceIndex, const PieceBoundary& boundary, const BoundaryDivision& division)
        : piece_(piece), pieceIndex_(pieceIndex), boundary_(boundary), division_(division) {}

    BoundaryNodes run() {
        std::size_t most = 0;
        for (int loop = 0; loop < loopCount(piece_); ++loop) most += division_.mostNodes(pieceIndex_, loop);
        nodes_.points.reserve(most);
        nodes_.grid.reserve(most);
        fractions_.reserve(most);
        for (int loop = 0; loop < loopCount(piece_); ++loop) walkLoop(loop);
        return std::move(nodes_);
    }

private:
    void walkLoop(int loop) {
        const BoundaryLoop& edges = loopOf(piece_, loop);
        const Vec2 start = edges.front().curve.start;
        const int first = addNode(start, gridOf(start));
        int current = first;
        ring_.reserve(division_.mostNodes(pieceIndex_, loop));
        spots_.reserve(division_.mostNodes(pieceIndex_, loop));
        ring_.push_back(first);
        auto& lists = nodes_.loops.emplace_back();
        lists.reserve(edges.size());
        std::vector<std::size_t> waiting; // edges of a run whose next node is not reached yet
        for (int e = 0, n = static_cast<int>(edges.size()); e < n; ++e) {
            EdgeNodes& list = lists.emplace_back();
            const int before = current;
            const EdgeArc& arc = boundary_.loops[at(loop)].edges[at(e)];
            if (arc.collapsed) {
                list.assign({{before, 0}, {before, 1}});
            } else if (division_.passesEnd(pieceIndex_, loop, e)) {
                list.assign({{before, 0}});
                waiting.push_back(at(e));
            } else {
                division_.listFractions(pieceIndex_, loop, e, fractions_);
                list.reserve(fractions_.size());
                list.push_back({before, 0});
                for (std::size_t k = 1; k < fractions_.size(); ++k) {
                    const bool last = k + 1 == fractions_.size();
                    const Vec2 point = last ? edges[at(e)].curve.end : arc.arc.pointAt(fractions_[k]);
                    current = last && isLast(loop, e) ? first : nextNode(current, point);
                    step(current, {loop, e, 0.5 * (fractions_[k - 1] + fractions_[k])});
                    list.push_back({current, fractions_[k]});
                    for (const std::size_t edge : waiting) lists[edge].push_back({current, 1});
                    waiting.clear();
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

    void step(int node, const BoundarySpot& spot) {
        if (node == ring_.back()) return;
        ring_.push_back(node);
        spots_.push_back(spot);
    }

    void closeRing(int loop) {
        if (ring_.size() > 1 && ring_.back() == ring_.front()) ring_.pop_back();
        while (spots_.size() < ring_.size())
            spots_.push_back(spots_.empty() ? BoundarySpot{loop, 0, 0.5} : spots_.back());
        if (boundary_.loops[at(loop)].backwards) {
            std::reverse(ring_.begin() + 1, ring_.end());
            std::reverse(spots_.begin(), spots_.end());
        }
        nodes_.rings.push_back(std::exchange(ring_, {}));
        nodes_.spots.push_back(std::exchange(spots_, {}));
    }

    const PieceInput& piece_;
    int pieceIndex_;
    const PieceBoundary& boundary_;
    const BoundaryDivision& division_;
    BoundaryNodes nodes_;
    std::vector<int> ring_;
    std::vector<BoundarySpot> spots_;
    std::vector<double> fractions_;
};

} // namespace

BoundaryNodes boundaryNodes(const PieceInput& piece, int pieceIndex, const PieceBoundary& boundary,
                            const BoundaryDivision& division) {
    return Walk(piece, pieceIndex, boundary, division).run();
}

std::vector<std::vector<GridPoint>> ringPoints(const BoundaryNodes& nodes) {
    std::vector<std::vector<GridPoint>> rings;
    for (const auto& ring : nodes.rings) {
        auto& points = rings.emplace_back();
        points.reserve(ring.size());
        for (const int node : ring) points.push_back(nodes.grid[at(node)]);
    }
    return rings;
}

std::vector<BoundarySpot> spotsTooCoarse(const BoundaryNodes& nodes) {
    std::vector<BoundarySpot> spots;
    const std::vector<std::vector<GridPoint>> rings = ringPoints(nodes);
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
    const std::vector<RingSegment> segments = segmentsOf(rings);
    for (const auto& [i, j] : allCrossings(segments))
        for (const int s : {i, j}) {
            const RingSegment& segment = segments[at(s)];
            spots.push_back(nodes.spots[at(segment.ring)][at(segment.index)]);
        }
    return spots;
}

} // namespace toile::meshing
