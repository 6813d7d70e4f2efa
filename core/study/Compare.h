// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Json.h"
#include "core/base/Result.h"

#include <string>
#include <vector>

namespace toile::study {

/// One quantity of one record that differs between two reports of a study.
struct Change {
    enum class Kind { worse, better, other };
    Kind kind = Kind::other;
    std::string record;   ///< its names: "flap, 5000, xpbd, 0.0051"
    std::string quantity; ///< "maximumError", "verdict", "CPU time"
    std::string before, after;
};

struct Comparison {
    std::vector<Change> changes;               ///< worse ones first
    std::vector<std::string> onlyOld, onlyNew; ///< names of records without a partner
    std::size_t joined = 0;
    std::size_t timesCompared = 0, timesNoisy = 0; ///< of joined records that have a time
    [[nodiscard]] bool gotWorse() const;
};

/// Joins the records of two reports of one study by what names them (scene, case, method) and says what differs:
///
/// verdicts, and counters (the members of `cost` that are no times), exactly but for instructions; errors exactly, down
/// to the reference's own error; CPU time as a ratio to the calibration of its report, where it changed by more than
/// both records' median over least. Times of a record that was noisy in either report are not compared, nor times whose
/// calibrations differ on one processor, nor times without repetitions. Errors: records of different studies, or
/// without a schema.
[[nodiscard]] Result<Comparison> compared(const std::vector<Json>& before, const std::vector<Json>& after);

/// A line for each change, what is only in one, and the sum of it.
[[nodiscard]] std::string comparisonText(const Comparison& comparison);

} // namespace toile::study
