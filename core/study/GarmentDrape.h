// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Json.h"
#include "core/dynamics/Method.h"
#include "core/simulation/Scene.h"
#include "core/study/Quantities.h"

#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

namespace toile::study {

/// A mesh and a method by which a garment is draped.
struct GarmentSetup {
    bool regions = true;                                             ///< finer where the document asks for it
    double factor = 1;                                               ///< of every spacing that is drawn [–]
    std::optional<dynamics::Method> method = dynamics::Method::xpbd; ///< absent: straight to the equilibrium
};

[[nodiscard]] std::string_view methodOf(const GarmentSetup& setup); ///< "xpbd", "static"
[[nodiscard]] std::string_view layoutOf(const GarmentSetup& setup); ///< "as drawn", "uniform"

/// What is measured of one drape.
struct GarmentDrape {
    std::string status; ///< why it does not count; empty = it does
    std::vector<Quantity> quantities;
    double seconds = 0; ///< CPU time, from the pattern to the drape
    int particles = 0;
    double simulatedSeconds = 0;
    Json facts; ///< more for records: "scene", "method", "result", "cost" and "leftOut" of them
};

/// One go from the pattern: the garment as it came to rest, where there was motion, and after statics.
struct GarmentGo {
    std::optional<GarmentDrape> atRest;
    std::optional<GarmentDrape> finished; ///< absent: the go failed
    std::string failure;                  ///< as "it was given up …"
};

/// Sews and drapes a garment, its seams closing in so much of their time – without seams it starts to the side, a tenth
/// of a millimetre for a thousandth more; the look that sew() takes at its result is
/// part of the time, what is measured here is not. A go that takes more than its budget [CPU s] is given up.
/// Errors: what meshing and sewing refuse, cancelled.
[[nodiscard]] Result<GarmentGo> drapedBy(const simulation::Scene& scene, const GarmentSetup& setup, double seamTime,
                                         double budget, std::stop_token stop);

/// A go as it is kept, and read back to the same bits. Absent: no such record.
[[nodiscard]] Json toJson(const GarmentGo& go);
[[nodiscard]] std::optional<GarmentGo> goFrom(const Json& json);

} // namespace toile::study
