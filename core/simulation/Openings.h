// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <vector>

namespace toile::simulation {

/// A closed chain of particles along the border of the sewn cloth: a neckline, a hem, a cuff.
using Opening = std::vector<int>;

/// The borders of the cloth, each walked with the cloth on its left seen from the right side. Triangles name
/// particles; those that merging made degenerate do not count.
[[nodiscard]] std::vector<Opening> openingsOf(std::span<const std::array<int, 3>> triangles);

/// Edges that two triangles run through in the same direction: across them the right side of one goes on as the wrong
/// side of the other, as where a seam was sewn the wrong way round.
[[nodiscard]] std::vector<std::array<int, 2>> turnedEdgesOf(std::span<const std::array<int, 3>> triangles);

} // namespace toile::simulation
