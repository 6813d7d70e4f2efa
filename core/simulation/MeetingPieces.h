// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/meshing/GarmentMesh.h"

#include <array>
#include <span>
#include <vector>

namespace toile::simulation {

/// Two pieces: their indices, the lower first.
using PiecePair = std::array<int, 2>;

/// Pieces that pass through each other or touch where they are placed, as the fronts of trousers do that are drawn beside
/// each other and overlap at the crotch; not those that touch node to node alone. nodes: as the topology numbers them
/// [m].
[[nodiscard]] std::vector<PiecePair> meetingPieces(const meshing::GarmentMesh& mesh, std::span<const Vec3> nodes);

} // namespace toile::simulation
