// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Progress.h"
#include "core/simulation/Sew.h"
#include "core/study/Deformation.h"
#include "core/study/Repetitions.h"

#include <array>
#include <string>
#include <string_view>
#include <vector>

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

/// A layout that the garment does not have.
struct NotLaidOut {
    LayoutKind kind;
    std::string why;
};

struct RegionsStudy {
    std::vector<LayoutResult> layouts; ///< in the order of layoutKinds; the reference is not among them
    std::vector<NotLaidOut> notRun;
    LayoutResult reference; ///< uniform, run once
    int repetitions = 1;    ///< of the layouts, in turns
    double floor =
        0; ///< rms distance of the reference to itself with lines 4 % closer: nothing below it is told apart [m]
    int points = 0;                     ///< material points at which drapes are compared
    std::vector<PartDeformation> parts; ///< of the uniform fine mesh

    [[nodiscard]] const LayoutResult* find(LayoutKind kind) const; ///< null = not run
};

struct RegionsSettings {
    double referenceSpacing = 0; ///< of the uniform mesh that all are compared with [m]
    int repetitions = 1;         ///< of every layout, in turns
    simulation::SewSettings sewing;
};

/// Whether finer meshes only in regions pay: the garment as it is drawn against uniform meshes at its main spacing, at
/// its finest, and at the spacing that gives as many particles as the regions do; and against the same regions by the
/// paper's rule and in a wrong place.
/// Errors: a pattern without regions, what meshing and sewing refuse, cancelled.
[[nodiscard]] Result<RegionsStudy> studyRegions(const simulation::Scene& scene, const RegionsSettings& settings,
                                                std::stop_token stop = {}, const Progress& progress = {});

/// The finest spacing that the regions of a pattern ask for [m]; nothing where no region is finer than its piece.
[[nodiscard]] std::optional<double> finestSpacing(const pattern::Pattern& pattern);

} // namespace toile::study
