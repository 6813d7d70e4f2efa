// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <stop_token>

namespace toile::cli {

/// Declares `study` with all its commands; the one that was given is left in `chosen`.
void declareStudy(CLI::App& app, std::stop_token stop, std::function<int()>& chosen);

} // namespace toile::cli
