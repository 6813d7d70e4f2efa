// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/meshing/CellLayer.h"
#include "core/meshing/TriangleSides.h"

namespace toile::meshing {

/// The triangles between the cells and the border. Nodes are those of CellLayer::stripNodes, by their place in it.
struct Strip {
    std::vector<GridPoint> points;
    std::vector<Vec2> places; ///< in the frame [m]
    TriangleSides sides;
    std::vector<int> region;     ///< of each triangle
    std::vector<int> mergedWith; ///< the other triangle of its quadrilateral, −1 = none
};

/// Where a node that no improvement has moved lies.
class NodePlaces {
public:
    NodePlaces(const PieceFrame& frame, const BoundaryNodes& boundary, const Lattice& lattice, const GridFill& fill,
               std::vector<Vec2>& borderPlaces);

    [[nodiscard]] Vec2 operator()(int node) const {
        return node < count_ ? border_[static_cast<std::size_t>(node)] : fill_.placeAt(lattice_, latticeNode(node));
    }
    [[nodiscard]] GridPoint grid(int node) const {
        return node < count_ ? boundary_.grid[static_cast<std::size_t>(node)]
                             : fill_.gridAt(lattice_, latticeNode(node));
    }
    [[nodiscard]] int latticeNode(int node) const { return node - count_; }
    [[nodiscard]] int borderCount() const { return count_; }

private:
    const BoundaryNodes& boundary_;
    const Lattice& lattice_;
    const GridFill& fill_;
    int count_;
    std::vector<Vec2>& border_;
};

} // namespace toile::meshing
