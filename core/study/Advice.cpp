// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/Advice.h"

#include <algorithm>

namespace toile::study {
namespace {

bool isLength(const Quantity& quantity) {
    return quantity.value && quantity.measure == Measure::length;
}

} // namespace

std::vector<const GarmentRun*> countedRuns(const GarmentAccuracy& study) {
    std::vector<const GarmentRun*> runs;
    for (const GarmentRun& run : study.runs)
        if (run.drape.status.empty()) runs.push_back(&run);
    return runs;
}

std::size_t noisyRuns(const GarmentAccuracy& study) {
    return static_cast<std::size_t>(
        std::ranges::count_if(countedRuns(study), [](const GarmentRun* run) { return run->time.noisy; }));
}

Advice adviceOn(const GarmentAccuracy& study, double within, const std::function<bool(const GarmentRun&)>& which) {
    if (noisyRuns(study) > 0) return {Counsel::tooNoisy};
    const GarmentReference& reference = study.reference;
    if (std::ranges::none_of(reference.mean, isLength)) return {Counsel::noLengths};
    auto runs = countedRuns(study);
    if (which) std::erase_if(runs, [&](const GarmentRun* run) { return !which(*run); });
    std::vector<const GarmentRun*> meeting;
    std::ranges::copy_if(runs, std::back_inserter(meeting),
                         [&](const GarmentRun* run) { return run->lengthError <= within; });
    if (!meeting.empty())
        return {Counsel::meets,
                *std::ranges::min_element(meeting, {}, [](const GarmentRun* run) { return run->time.least; })};
    for (std::size_t q = 0; q < reference.mean.size(); ++q)
        if (isLength(reference.mean[q]) && reference.floor[q] > within) return {Counsel::belowFloor, nullptr, q};
    if (runs.empty()) return {Counsel::noRun};
    return {Counsel::noneMeets, *std::ranges::min_element(runs, {}, &GarmentRun::lengthError)};
}

} // namespace toile::study
