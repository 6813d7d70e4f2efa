// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/meshing/GridPoint.h"
#include "core/meshing/KeyedNodes.h"
#include "core/meshing/TriangleSides.h"

#include <span>

namespace toile::meshing {

/// A side of the strip's border, from → to; the strip lies to its left.
struct Wall {
    int from = 0, to = 0;
};

/// Triangulates what lies between walls. These are the whole border of it: closed, meeting at common end points only;
/// points without walls lie inside. A fold is two walls on one segment, one each way. Points are swept over once, each
/// joined to what is visible of those before it (Hertel & Mehlhorn 1983): some fifty instructions for each, and as good
/// a start as any for Delaunay flips. Buffers are kept between calls.
class StripSweep {
public:
    void run(std::span<const GridPoint> points, std::span<const Wall> walls, TriangleSides& sides);

private:
    /// A node of a chain: the right border of what is triangulated between two walls, from the lower to the upper.
    struct ChainNode {
        int vertex = 0, previous = -1, next = -1;
        int owner = -1; ///< of the link to the next node: see `glue`
    };
    /// A wall that the sweep line crosses.
    struct Crossed {
        int left = 0, right = 0;
        bool insideAbove = false;
        int newest = -1; ///< last node of the chain above it
    };

    void sortPoints();
    void listWalls(std::span<const Wall> walls);
    void visit(int vertex);
    void collectStarts(int vertex);
    int newNode(int vertex);
    void dropNode(int node);
    void moveLink(int from, int to);
    void glue(int side, int node);
    int join(int newest, int vertex);
    void closeLower(int node);
    void closeUpper(int node);
    void endLink(int node);
    int splitAt(int node);
    int addTriangle(int a, int b, int c);
    [[nodiscard]] GridPoint at(int vertex) const { return points_[static_cast<std::size_t>(vertex)]; }
    [[nodiscard]] GridPoint placeOf(int node) const { return at(chain(node).vertex); }
    [[nodiscard]] ChainNode& chain(int node) { return nodes_[static_cast<std::size_t>(node)]; }
    [[nodiscard]] const ChainNode& chain(int node) const { return nodes_[static_cast<std::size_t>(node)]; }

    std::span<const GridPoint> points_;
    TriangleSides* sides_ = nullptr;
    std::vector<KeyedNode> order_, orderBuffer_;
    std::vector<int> rank_;              ///< of each point in `order_`
    std::vector<int> firstWall_, after_; ///< the walls that start at each point: list heads and links
    std::vector<Crossed> walls_;         ///< each from its left to its right end
    std::vector<Crossed> crossed_;       ///< from the lowest to the highest
    std::vector<Crossed> starts_;        ///< those that start at the point in hand, in the same order
    std::vector<ChainNode> nodes_;
    std::vector<int> unusedNodes_;
};

} // namespace toile::meshing
