// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/Scene.h"

#include <array>
#include <optional>
#include <string_view>

namespace toile::study {

/// The meshes of one garment that are compared.
enum class LayoutKind {
    coarse,       ///< uniform, at the main spacing
    regions,      ///< as drawn: finer in regions, cells graded 2 : 1 at their borders
    paper,        ///< the same regions by the paper's rule: two levels, snapped to its main lines
    elsewhere,    ///< the regions as drawn, each moved along its piece to the farther end: a wrong place
    asManyPoints, ///< uniform, with as many particles as the regions have
    fine          ///< uniform, at the finest spacing of the regions
};
inline constexpr std::array layoutKinds{LayoutKind::coarse,    LayoutKind::regions,      LayoutKind::paper,
                                        LayoutKind::elsewhere, LayoutKind::asManyPoints, LayoutKind::fine};
[[nodiscard]] std::string_view nameOf(LayoutKind kind);
[[nodiscard]] bool isUniform(LayoutKind kind);

/// A garment with its meshes made in one of these ways.
struct Layout {
    LayoutKind kind = LayoutKind::coarse;
    simulation::Scene scene;
    double spacing = 0; ///< the least of it [m]
};

/// All but asManyPoints, whose spacing is known once particles were counted. The scene has regions that are finer.
[[nodiscard]] Layout layoutOf(const simulation::Scene& scene, LayoutKind kind);
/// The uniform one that has as many particles, of how many the coarse one and the regions have.
[[nodiscard]] Layout asManyPoints(const simulation::Scene& scene, int coarse, int regions);

/// The garment with one mesh of this spacing everywhere, but for pieces that are drawn coarser in proportion.
[[nodiscard]] Layout uniformLayout(const simulation::Scene& scene, LayoutKind kind, double spacing);

/// The finest spacing that the regions of a pattern ask for [m]; nothing where no region is finer than its piece.
[[nodiscard]] std::optional<double> finestSpacing(const pattern::Pattern& pattern);

} // namespace toile::study
