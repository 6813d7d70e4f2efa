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
    int cores = 0;          ///< that the machine has
    double load = 0;        ///< mean number of busy threads in the minute before
};

/// Mean number of busy threads on this machine in the last minute; 0 where the system does not tell.
[[nodiscard]] double machineLoad();

/// The machine as records name it; loadAfter is that of now.
[[nodiscard]] inline Json machineOf(const Circumstances& circumstances) {
    Json machine;
    machine.set("processor", circumstances.processor).set("cores", circumstances.cores);
    machine.set("calibrationSeconds", circumstances.calibration);
    return machine.set("loadBefore", circumstances.load).set("loadAfter", machineLoad());
}

/// What every record of a study says of its making.
inline void note(Json& record, const char* schema, const Circumstances& circumstances) {
    record.set("schema", schema).set("program", circumstances.program).set("machine", machineOf(circumstances));
}

} // namespace toile::study
