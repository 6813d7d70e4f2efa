// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Result.h"
#include "core/cloth/ClothModel.h"
#include "core/dynamics/Stage.h"

#include <span>

namespace toile::dynamics {

/// Bound of the largest angular frequency of a cloth and of what acts on it; explicit steps are measured by
/// it.
class FrequencyBound {
public:
    explicit FrequencyBound(const cloth::ClothModel& model);
    /// ω_max [1/s]; 0 for free particles. positions are read for hinges only.
    [[nodiscard]] double largest(std::span<const Vec3> positions, std::span<Stage* const> stages) const;

private:
    const cloth::ClothModel& model_;
    double ofElementsSquared_ = 0; ///< of a cloth without hinges: it does not depend on where it is [1/s²]
};

/// Number of equal parts of a step, each at most safety·limit; a step within the limit is one part. Refused
/// when it would take more than a million.
[[nodiscard]] Result<int> explicitParts(double duration, double limit, double safety);

} // namespace toile::dynamics
