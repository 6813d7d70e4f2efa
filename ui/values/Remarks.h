// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Result.h"

#include <QString>

#include <vector>

namespace toile::ui {

/// What an edit took along, or an import had to assume: each thing by its name, then what became of it.
[[nodiscard]] QString remarksOf(const std::vector<Warning>& warnings, QChar between = QLatin1Char(' '));

} // namespace toile::ui
