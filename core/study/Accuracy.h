// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Progress.h"
#include "core/study/Trajectory.h"

#include <string>
#include <vector>

namespace toile::study {

/// One scene and all the ways it is run.
struct AccuracyCase {
    std::string scene; ///< a name of sceneNames()
    SceneSettings settings;
    std::vector<Setup> setups;
};

struct AccuracyPlan {
    std::vector<AccuracyCase> cases;
    int repetitions = 5; ///< of every run, interleaved: all once, then all again
};

/// Every method at steps of 1/20 of the scene down to 1/320; explicit methods at half their limit and below. quick:
/// three stiffnesses on a sheet of 16 cells and three repetitions; full: four on 32 cells and five. Names are of
/// sceneNames(); none = all.
[[nodiscard]] AccuracyPlan accuracyPlan(const std::vector<std::string>& scenes, bool quick);

/// With what the runs of a case are compared: fourth-order steps so small that halving them changes nothing that
/// counts.
struct Reference {
    Setup setup;
    Trajectory trajectory;
    double selfError = 0; ///< largest rms distance to the same at twice the step [m]
};

/// Three times the reference's own error: no run is told to be nearer than this [m].
[[nodiscard]] double bandOf(const Reference& reference);

struct RunResult {
    Setup setup;
    double step = 0; ///< what the method advances by, substeps counted [s]
    bool solved = true;
    std::string failure; ///< empty when it ran to the end
    TimeError error;     ///< against the reference
    double energyChange = 0;
    dynamics::StepReport report;
    double secondsLeast = 0, secondsMedian = 0; ///< CPU time of one simulated second [s/s]
    bool noisy = false;                         ///< median over 1.3 of the least: no time is concluded from it
    bool inBand = false;                        ///< nearer to the reference than three times its own error
};

struct CaseResult {
    Scene scene;
    int cells = 0;
    double stiffnessFactor = 1;
    Reference reference;
    std::vector<RunResult> runs;
};

/// Runs one case. Errors: cancelled, a reference that does not hold.
[[nodiscard]] Result<CaseResult> studied(const AccuracyCase& which, int repetitions, std::stop_token stop = {},
                                         const Progress& progress = {});

} // namespace toile::study
