// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/GarmentAccuracy.h"

#include <functional>

namespace toile::study {

/// What can be said to who asks for every length right within so much.
enum class Counsel {
    meets,      ///< the run is the cheapest that is
    noneMeets,  ///< the run is the nearest
    belowFloor, ///< the quantity differs by more from one drape of the same garment to the next
    noLengths,  ///< there is none that could be compared
    noRun,      ///< none came to rest
    tooNoisy,   ///< no time is concluded from such runs
};

struct Advice {
    Counsel counsel = Counsel::noRun;
    const GarmentRun* run = nullptr; ///< of the study; of the first two only
    std::size_t quantity = 0;        ///< of the reference's mean, for belowFloor
};

/// The cheapest setting all of whose lengths are right within so much [m], among the runs that are asked for; or why
/// there is none.
[[nodiscard]] Advice adviceOn(const GarmentAccuracy& study, double within,
                              const std::function<bool(const GarmentRun&)>& which = {});

/// Runs that came to rest as they should.
[[nodiscard]] std::vector<const GarmentRun*> countedRuns(const GarmentAccuracy& study);
/// Those of them whose time says nothing.
[[nodiscard]] std::size_t noisyRuns(const GarmentAccuracy& study);

} // namespace toile::study
