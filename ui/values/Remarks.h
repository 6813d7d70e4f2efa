// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Result.h"

#include <QString>

#include <vector>

namespace toile::ui {

/// What an edit took along, for the status line: each thing by its name, then what became of it.
[[nodiscard]] QString remarksOf(const std::vector<Warning>& warnings);

} // namespace toile::ui
