// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/body/Landmarks.h"
#include "core/body/Mannequin.h"
#include "core/body/MeshSection.h"

namespace toile::body {

/// The level plane in which a tape goes round the trunk at this height [m], about the trunk's line. None without one.
[[nodiscard]] std::optional<Plane> acrossTrunk(const Body& body, double height);

/// What a tape finds on a body with landmarks and limbs, in the planes of docs/body.md. Error names the girth at whose
/// level the body has no closed section.
[[nodiscard]] Result<Measurements> measurementsOf(const Body& body);

} // namespace toile::body
