// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Json.h"
#include "core/simulation/Sew.h"
#include "core/study/Deformation.h"
#include "core/study/DrapedLattice.h"
#include "core/study/Layouts.h"
#include "core/study/Repetitions.h"

#include <optional>
#include <vector>

namespace toile::study {

/// A layout, draped.
struct LayoutResult {
    LayoutKind kind = LayoutKind::coarse;
    double spacing = 0; ///< the least of it [m]
    int particles = 0, springs = 0;
    std::size_t bytes = 0; ///< of cloth and stages
    RunTime time;          ///< of sewing and draping
    bool atRest = false;
    double energy = 0;                ///< elastic and of gravity [J]
    double rms = 0, maximum = 0;      ///< distance to the reference at common material points [m]
    simulation::StrainSummary strain; ///< of the whole garment
};

/// One drape of a layout, with the shape that others are compared with.
struct LayoutGo {
    LayoutResult result;
    DrapedLattice lattice;
    std::vector<PartDeformation> parts; ///< by the regions as they are drawn
    double seconds = 0;                 ///< CPU time of sewing
};

/// Errors: what meshing and sewing refuse, cancelled.
[[nodiscard]] Result<LayoutGo> drapedBy(const Layout& layout, const pattern::Pattern& drawn,
                                        const simulation::SewSettings& settings, std::stop_token stop);

/// A go as it is kept, and read back to the same bits. Absent: no such record.
[[nodiscard]] Json toJson(const LayoutGo& go);
[[nodiscard]] std::optional<LayoutGo> layoutGoFrom(const Json& json);

} // namespace toile::study
