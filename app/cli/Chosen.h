// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <stop_token>
#include <variant>

namespace toile::cli {

/// The command that was given, to be called for an exit status. One that can be told to stop leaves what it has;
/// another has nothing to leave.
using Chosen = std::variant<std::function<int()>, std::function<int(std::stop_token)>>;

} // namespace toile::cli
