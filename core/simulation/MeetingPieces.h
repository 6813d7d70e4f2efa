// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/meshing/GarmentMesh.h"
#include "core/pattern/Pattern.h"

#include <array>
#include <span>
#include <vector>

namespace toile::simulation {

/// Two pieces: their indices, the lower first.
using PiecePair = std::array<int, 2>;

/// Pieces that pass through each other or touch where they are placed, as the fronts of trousers do that are drawn
/// beside each other and overlap at the crotch; not those that touch node to node alone. nodes: as the topology numbers
/// them [m].
[[nodiscard]] std::vector<PiecePair> meetingPieces(const meshing::GarmentMesh& mesh, std::span<const Vec3> nodes);

/// The pattern with pieces that meet and lie in one plane 5 mm apart: the later one is moved the way its right side
/// faces. In a plane there is no way that would part them, and nothing could move. Curled pieces stay.
[[nodiscard]] pattern::Pattern offEachOther(const pattern::Pattern& pattern, std::span<const PiecePair> meeting);

} // namespace toile::simulation
