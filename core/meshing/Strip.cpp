// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/meshing/Strip.h"

namespace toile::meshing {

NodePlaces::NodePlaces(const PieceFrame& frame, const BoundaryNodes& boundary, const Lattice& lattice,
                       const GridFill& fill, std::vector<Vec2>& borderPlaces)
    : boundary_(boundary), lattice_(lattice), fill_(fill), count_(static_cast<int>(boundary.points.size())),
      border_(borderPlaces) {
    border_.clear();
    for (const Vec2 point : boundary.points) border_.push_back(frame.frameOf(point));
    for (const auto& [node, latticeNode] : fill.aligned)
        border_[static_cast<std::size_t>(node)] = fill.placeAt(lattice, latticeNode);
}

} // namespace toile::meshing
