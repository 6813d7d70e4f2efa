// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/tools/Tool.h"

namespace toile::ui {

/// Takes what is selected out of the pattern, in one step: seams, regions, vertices and pieces. The message
/// names what went with it.
[[nodiscard]] Effect deleteSelection(const Desk& desk);

} // namespace toile::ui
