// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Progress.h"
#include "core/study/LayoutDrape.h"

#include <functional>
#include <string>
#include <vector>

namespace toile::study {

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

/// Gives the go that is kept by this key, or runs it now and keeps it. The key tells "scene" (layout, spacing, which
/// repetition) and "method", not what the garment looks like.
using LayoutKeeper = std::function<Result<LayoutGo>(const Json& key, const std::function<Result<LayoutGo>()>& run)>;

/// Whether finer meshes only in regions pay: the garment as it is drawn against uniform meshes at its main spacing, at
/// its finest, and at the spacing that gives as many particles as the regions do; and against the same regions by the
/// paper's rule and in a wrong place. Without a keeper all is run.
/// Errors: a pattern without regions, what meshing and sewing refuse, cancelled, what the keeper cannot write.
[[nodiscard]] Result<RegionsStudy> studyRegions(const simulation::Scene& scene, const RegionsSettings& settings,
                                                std::stop_token stop = {}, const Progress& progress = {},
                                                const LayoutKeeper& keeper = {});

} // namespace toile::study
