// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/Circumstances.h"

namespace toile {

/// Those of the tests.
inline const study::Circumstances here{"toile-cli 0 (test)", "toile-cli study accuracy", "a processor", 0.004};

inline bool says(const std::string& text, const std::string& what) {
    return text.find(what) != std::string::npos;
}

} // namespace toile
