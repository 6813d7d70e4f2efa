// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/Chosen.h"

#include <CLI/CLI.hpp>

namespace toile::cli {

/// Declares `study` with all its commands; the one that was given is left in `chosen`.
void declareStudy(CLI::App& app, Chosen& chosen);

} // namespace toile::cli
