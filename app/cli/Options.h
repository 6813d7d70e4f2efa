// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/batch/Commands.h"
#include "app/cli/Chosen.h"

#include <CLI/CLI.hpp>

namespace toile::cli {

/// Declares all commands with their options; the one that was given is left in `chosen`.
void declareCommands(CLI::App& app, Chosen& chosen);

} // namespace toile::cli
