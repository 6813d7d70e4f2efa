// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/batch/Commands.h"
#include "app/batch/Console.h"
#include "app/batch/StudyFolder.h"
#include "core/study/Compare.h"

#include <fmt/format.h>

namespace toile::batch {

int studyCompare(const std::string& before, const std::string& after) {
    const auto old = recordsIn(before), now = recordsIn(after);
    const auto comparison = !old   ? Result<study::Comparison>(tl::unexpected(old.error()))
                            : !now ? Result<study::Comparison>(tl::unexpected(now.error()))
                                   : study::compared(*old, *now);
    if (!comparison) {
        printError(comparison.error());
        return inputWrong;
    }
    fmt::print("{}", study::comparisonText(*comparison));
    return comparison->gotWorse() ? goalMissed : done;
}

} // namespace toile::batch
