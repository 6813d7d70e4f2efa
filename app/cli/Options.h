// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/batch/Commands.h"

#include <CLI/CLI.hpp>
#include <functional>

namespace toile::cli {

/// Declares all commands with their options; the one that was given is left in `chosen`.
void declareCommands(CLI::App& app, std::stop_token stop, std::function<int()>& chosen);

} // namespace toile::cli
