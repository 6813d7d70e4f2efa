// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>

namespace toile {

/// Long work tells how far it is. Called on the working thread; an empty function is fine.
/// fraction in [0, 1], what in the user's words.
using Progress = std::function<void(double fraction, const std::string& what)>;

inline void report(const Progress& progress, double fraction, const std::string& what) {
    if (progress) progress(fraction, what);
}

} // namespace toile
