// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/scenes/Case.h"

#include <span>
#include <string_view>

namespace toile::batch {

/// "flap", "hanging", …: the names that `study scenes` knows, each of one scene in several forms.
[[nodiscard]] std::span<const std::string_view> sceneGroups();

/// The cases of a group; full: also those that take minutes. Errors: a sample that cannot be drafted.
[[nodiscard]] Result<std::vector<study::scenes::Case>> sceneCases(std::string_view group, bool full);

} // namespace toile::batch
