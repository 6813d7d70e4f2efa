// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/cloth/ClothModel.h"
#include "core/geometry/TriangleMesh.h"

#include <span>
#include <vector>

namespace toile::dynamics {

/// Where each particle may be, seen from its start, while every one goes any part of its own straight way: boxes [m].
/// A slave goes where its masters take it, and each of them may go another part.
[[nodiscard]] std::vector<geometry::Box3> waysOf(const cloth::ClothModel& model, std::span<const Vec3> from,
                                                 std::span<const Vec3> to);

} // namespace toile::dynamics
