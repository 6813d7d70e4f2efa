// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/dynamics/FrequencyBound.h"

#include "core/cloth/Forces.h"

#include <cmath>
#include <fmt/format.h>

namespace toile::dynamics {

FrequencyBound::FrequencyBound(const cloth::ClothModel& model) : model_(model) {
    if (model.hinges.empty()) ofElementsSquared_ = cloth::largestFrequencySquared(model);
}

double FrequencyBound::largest(std::span<const Vec3> positions, std::span<Stage* const> stages) const {
    double squared = model_.hinges.empty() ? ofElementsSquared_ : cloth::largestFrequencySquared(model_, positions);
    for (const Stage* stage : stages) squared += stage->largestFrequencySquared();
    return std::sqrt(squared);
}

Result<int> explicitParts(double duration, double limit, double safety) {
    constexpr double most = 1e6;
    if (duration <= limit) return 1;
    const double parts = std::ceil(duration / (safety * limit));
    if (!(parts <= most))
        return fail(ErrorCode::tooLarge,
                    fmt::format("A step of {:.3g} s would take {:.3g} explicit steps of at most {:.3g} s: use an "
                                "implicit method.",
                                duration, parts, limit));
    return static_cast<int>(parts);
}

} // namespace toile::dynamics
