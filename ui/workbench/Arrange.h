// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/body/Landmarks.h"
#include "ui/tools/Tool.h"

namespace toile::ui {

enum class BodySide { front, back, left, right };

/// The placement beside a body, facing away from it, at the height it had. Without a body: beside where one would
/// stand.
[[nodiscard]] pattern::Placement placedBeside(const body::Body* body, BodySide side, const pattern::Placement& before);

/// The selected pieces beside the body.
[[nodiscard]] Effect arranged(const Desk& desk, const body::Body* body, BodySide side);

} // namespace toile::ui
