// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/cloth/ClothModel.h"

#include <span>

namespace toile::cloth {

/// The elements of a cloth parted into levels 0 … levels − 1: each goes to the highest level of its particles. Masses
/// and tension curves are those of the cloth in every part, pins and slaves in none; forces of all parts add up to the
/// cloth's.
[[nodiscard]] std::vector<ClothModel> elementsByLevel(const ClothModel& model, std::span<const int> levelOfParticle,
                                                      int levels);

/// Particles that the elements of a cloth join, rising.
[[nodiscard]] std::vector<int> joinedParticles(const ClothModel& model);

} // namespace toile::cloth
