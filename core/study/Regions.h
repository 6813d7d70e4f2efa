// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Json.h"
#include "core/base/Progress.h"
#include "core/simulation/Sew.h"
#include "core/study/Circumstances.h"
#include "core/study/Deformation.h"
#include "core/study/Repetitions.h"

#include <string>
#include <vector>

namespace toile::study {

/// One garment with its meshes made in another way.
struct Layout {
    std::string name; ///< "uniform coarse", "regions", "uniform, as many particles", "uniform fine", "reference",
                      ///< "reference again"
    simulation::Scene scene;
    double spacing = 0; ///< the least of it [m]
};

/// A layout, draped.
struct LayoutResult {
    std::string name;
    double spacing = 0; ///< the least of it [m]
    int particles = 0, springs = 0;
    std::size_t bytes = 0; ///< of cloth and stages
    RunTime time;          ///< of sewing and draping
    bool atRest = false;
    double energy = 0;                ///< elastic and of gravity [J]
    double rms = 0, maximum = 0;      ///< distance to the reference at common material points [m]
    simulation::StrainSummary strain; ///< of the whole garment
};

struct RegionsStudy {
    std::vector<LayoutResult> layouts; ///< the reference is not among them
    LayoutResult reference;            ///< run once
    int repetitions = 1;               ///< of the layouts, in turns
    double floor =
        0; ///< rms distance of the reference to itself with lines 4 % closer: nothing below it is told apart [m]
    int points = 0;                     ///< material points at which drapes are compared
    std::vector<PartDeformation> parts; ///< of the uniform fine mesh
};

struct RegionsSettings {
    double referenceSpacing = 0; ///< of the uniform mesh that all are compared with [m]
    int repetitions = 1;         ///< of every layout, in turns
    simulation::SewSettings sewing;
};

/// Whether finer meshes only in regions pay: the garment as it is drawn against uniform meshes at its main spacing, at
/// its finest, and at the spacing that gives as many particles as the regions do.
/// Errors: a pattern without regions, what meshing and sewing refuse, cancelled.
[[nodiscard]] Result<RegionsStudy> studyRegions(const simulation::Scene& scene, const RegionsSettings& settings,
                                                std::stop_token stop = {}, const Progress& progress = {});

/// The finest spacing that the regions of a pattern ask for [m]; nothing where no region is finer than its piece.
[[nodiscard]] std::optional<double> finestSpacing(const pattern::Pattern& pattern);

/// Whether the regions paid, in plain words. Differences below the floor are called none, and noisy times are not
/// compared.
[[nodiscard]] std::string verdictOn(const RegionsStudy& study);

/// The table and the verdict, in Markdown.
[[nodiscard]] std::string regionsText(const RegionsStudy& study, const std::string& document,
                                      const Circumstances& circumstances);

/// One record a layout, the reference last.
[[nodiscard]] std::vector<Json> recordsOf(const RegionsStudy& study, const std::string& document,
                                          const Circumstances& circumstances);

} // namespace toile::study
