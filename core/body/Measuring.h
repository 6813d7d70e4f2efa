// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/body/Landmarks.h"
#include "core/body/Mannequin.h"

namespace toile::body {

/// What a tape finds on a body with landmarks and limbs, in the planes of docs/body.md. Error names the girth at whose
/// level the body has no closed section.
[[nodiscard]] Result<Measurements> measurementsOf(const Body& body);

} // namespace toile::body
