// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/dynamics/Method.h"
#include "core/study/Regions.h"

#include <string>
#include <vector>

namespace toile::study {

/// What a method takes for the same motion on one layout.
struct MotionCost {
    LayoutKind layout = LayoutKind::coarse;
    dynamics::Method method = dynamics::Method::xpbd;
    int particles = 0;
    RunTime time;        ///< CPU time of one simulated second
    int parts = 0;       ///< steps or substeps of one simulated second
    std::string failure; ///< why there is no cost; else empty
};

/// The interactive method, the accurate one, and two explicit ones: at the step that the finest region allows, and with
/// every region at its own.
inline constexpr std::array motionMethods{dynamics::Method::xpbd, dynamics::Method::trBdf2,
                                          dynamics::Method::symplecticEuler, dynamics::Method::subcycledEuler};

/// The first 0.2 s of a scene without seams, let go as it is placed, on each layout by each method in turns; empty for
/// a scene with seams, whose motion begins with sewing. Errors: what meshing refuses, cancelled.
[[nodiscard]] Result<std::vector<MotionCost>> motionCosts(const simulation::Scene& scene, const RegionsStudy& study,
                                                          std::stop_token stop = {}, const Progress& progress = {});

/// A table of layouts and methods, and what regions save by each method, in Markdown; empty without costs.
[[nodiscard]] std::string motionText(const std::vector<MotionCost>& costs);

} // namespace toile::study
