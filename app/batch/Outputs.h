// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Result.h"

#include <initializer_list>
#include <string>

namespace toile::batch {

/// Whether a result can be written there, asked before the work begins: the folder must exist, and the name must end in
/// one of these (any, if none is given). An empty name is no output.
[[nodiscard]] Result<void> checkedOutput(const std::string& file, std::initializer_list<std::string> extensions);

} // namespace toile::batch
