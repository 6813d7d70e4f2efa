// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Json.h"

#include <string>

namespace toile::study {

/// What the numbers were measured with.
struct Circumstances {
    std::string program;    ///< version and commit
    std::string command;    ///< that makes the report again
    std::string processor;  ///< its name
    double calibration = 0; ///< calibrationSeconds() of the same minute [s]
};

/// What every record of a study says of its making.
inline void note(Json& record, const char* schema, const Circumstances& circumstances) {
    Json machine;
    machine.set("processor", circumstances.processor).set("calibrationSeconds", circumstances.calibration);
    record.set("schema", schema).set("program", circumstances.program).set("machine", std::move(machine));
}

} // namespace toile::study
