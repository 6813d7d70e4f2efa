// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace toile::study {

/// What the numbers were measured with.
struct Circumstances {
    std::string program;    ///< version and commit
    std::string command;    ///< that makes the report again
    std::string processor;  ///< its name
    double calibration = 0; ///< calibrationSeconds() of the same minute [s]
};

} // namespace toile::study
