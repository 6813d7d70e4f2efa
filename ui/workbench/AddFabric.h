// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/material/Fabric.h"
#include "ui/tools/Tool.h"

namespace toile::ui {

/// The document with one fabric more, with an id of its own; it is selected.
[[nodiscard]] Effect fabricAdded(const Desk& desk, material::Fabric fabric);

} // namespace toile::ui
