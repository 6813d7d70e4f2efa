// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/lean/Features.h"

namespace toile::study::lean {

// The chapters of allFeatures(), one per file of this folder. spacing: of the meshes [m].

[[nodiscard]] std::vector<Feature> stageFeatures(double spacing);      ///< stages of the plan
[[nodiscard]] std::vector<Feature> elementFeatures(double spacing);    ///< elements of the cloth
[[nodiscard]] std::vector<Feature> integratorFeatures(double spacing); ///< settings of the integrator

} // namespace toile::study::lean
