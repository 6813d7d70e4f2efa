// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>

namespace toile::simulation {

/// How a garment is put on: first sewn without weight, then shaken down without friction, then left to itself
/// (docs/decisions/0003-dressing.md).
enum class Phase { sewing, shaking, draping };

inline constexpr std::array<const char*, 3> phaseNames{"sewing", "shaking", "draping"};
[[nodiscard]] inline std::string nameOf(Phase phase) {
    return phaseNames[static_cast<std::size_t>(phase)];
}

} // namespace toile::simulation
