// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Result.h"
#include "core/body/Landmarks.h"
#include "core/geometry/VertexMotion.h"

namespace toile::body {

/// How far each vertex of a body goes along when its arms are lifted: 1 on the arms, 0 on the trunk, and between them
/// something that changes smoothly over the shoulder. Left is positive, right negative.
/// Error: the body has no arms that stand off from the trunk.
[[nodiscard]] Result<std::vector<double>> armShares(const Body& body);

/// Both arms are lifted sideways by an angle [rad], beginning and ending softly, in so many seconds; a negative angle
/// lowers them. Errors: as armShares(), an angle beyond a half turn, no time.
[[nodiscard]] Result<geometry::VertexMotion> armLift(const Body& body, double angle, double seconds);

} // namespace toile::body
