// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace toile::cli {

/// For the values of an option. CLI::Range would let through "nan", which is neither below nor above anything.
[[nodiscard]] inline CLI::Validator numberFrom(double low, double high) {
    return {[low, high](const std::string& text) {
                double value = 0;
                const bool isInside = CLI::detail::lexical_cast(text, value) && value >= low && value <= high;
                return isInside ? "" : fmt::format("\"{}\" is not a number from {:g} to {:g}", text, low, high);
            },
            fmt::format("FLOAT in [{:g} - {:g}]", low, high)};
}

} // namespace toile::cli
