// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Progress.h"
#include "core/study/GarmentDrape.h"
#include "core/study/Repetitions.h"

#include <functional>
#include <string>
#include <vector>

namespace toile::study {

struct GarmentPlan {
    std::vector<GarmentSetup> setups; ///< coarse ones first
    double referenceFactor = 0.8;     ///< the reference is uniform at so much of the main spacing [–]
    int referenceRuns = 5;            ///< with seams that close a little slower or faster
    int repetitions = 2;              ///< of every run, interleaved
    double longRun = 30;              ///< a run that takes longer is timed once [s]
    double budget = 90;               ///< of CPU time, after which a run is given up [s]
};

/// At 1.4, 1.2 and 1 times the spacings that are drawn, as drawn and uniform: position-based, straight to the
/// equilibrium, and by the accurate method – that, when quick, only on the coarsest mesh as drawn. full: 1.4, 1 and 0.7
/// times, against 16 references at half.
[[nodiscard]] GarmentPlan garmentPlan(const pattern::Pattern& pattern, bool quick);

/// What the runs are compared with: the mean of the same drape, dressed a little slower or faster each time.
struct GarmentReference {
    double spacing = 0; ///< main [m]
    int particles = 0, runs = 0;
    std::vector<Quantity> mean;
    std::vector<double> floor; ///< of each quantity: within it of the mean lie 19 of 20 such runs, or what a tape tells
                               ///< apart if that is more
    double band = 0; ///< largest score of a reference run against the others: nothing below is told apart [–]
};

/// A drape by one setup, as it came to rest or finished by statics, compared with the reference.
struct GarmentRun {
    GarmentSetup setup;
    bool finished = false;
    double spacing = 0; ///< main [m]
    GarmentDrape drape;
    std::vector<std::optional<double>> errors; ///< of each quantity against the reference
    double score = 0;                          ///< rms of the errors over their floors [–]
    double lengthError = 0;                    ///< largest of those lengths, each at least its floor [m]
    RunTime time;                              ///< CPU, from the pattern to the drape
    int repetitions = 0;
};

struct NotRunSetup {
    GarmentSetup setup;
    std::string why;
};

struct GarmentAccuracy {
    std::string name;
    double mainSpacing = 0; ///< as drawn [m]
    GarmentReference reference;
    std::vector<GarmentRun> runs;
    std::vector<NotRunSetup> notRun;
};

/// Gives the go that is kept by this key, or runs it now and keeps it. The key tells "scene" (name, mesh, which
/// reference or repetition) and "method", not what the garment looks like.
using GoKeeper = std::function<Result<GarmentGo>(const Json& key, const std::function<Result<GarmentGo>()>& run)>;

/// Sews and drapes the garment in all ways of the plan; without a keeper all is run. Errors: what meshing and sewing
/// refuse, a reference that does not come to rest, cancelled, what the keeper cannot write.
[[nodiscard]] Result<GarmentAccuracy> studyGarment(const std::string& name, const simulation::Scene& scene,
                                                   const GarmentPlan& plan, std::stop_token stop = {},
                                                   const Progress& progress = {}, const GoKeeper& keeper = {});

/// Mean and floors of perturbed runs, and how far these lie from each other.
[[nodiscard]] GarmentReference referenceOf(const std::vector<std::vector<Quantity>>& runs);
/// Compares a run's quantities with the reference.
void judge(GarmentRun& run, const GarmentReference& reference);

} // namespace toile::study
