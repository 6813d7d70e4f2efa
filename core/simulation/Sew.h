// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Json.h"
#include "core/simulation/Simulation.h"
#include "core/simulation/Worn.h"

#include <chrono>
#include <functional>

namespace toile::simulation {

struct SewSettings {
    std::optional<double> seconds; ///< simulate just so long, without finish [s]; absent = until rest
    double limit = 20;             ///< simulated time after which rest is no longer waited for [s]
    double hold = 10;              ///< a garment without a neck opening goes on for so long after rest: a band that
                                   ///< slides may do so slowly [s]
    /// When the run ends wherever it is, by the clock on the wall; absent = never.
    std::optional<std::chrono::steady_clock::time_point> deadline = {};
    bool finish = true; ///< statics after rest
    dynamics::StaticSettings statics = finishing;
    WornSettings worn;
};

struct SeamResult {
    SeamState state;
    SeamGap gap; ///< at the end
};

struct TackResult {
    std::string name;
    double initialGap = 0; ///< where the pieces were placed [m]
    double gap = 0;        ///< what the ends are farther apart than the thread is long, at the end [m]
    bool closed = false;   ///< no more than a millimetre
};

struct ContactSummary {
    double bodyPenetrationMaximum = 0;                ///< [m]
    std::optional<double> bodyClearanceMinimum;       ///< [m]; absent without a body
    int selfIntersections = 0, bodyIntersections = 0; ///< pairs of triangles, by the independent exact test
    int nodesInWrongOrder = 0;                        ///< behind a piece of a lower layer within 20 mm
    bool guarantee = false;  ///< self-contact has kept all layers apart since it last found any crossed
    bool outsideBody = true; ///< no intersection, and a clearance of at least a third of the skin offset
    bool layersApart = true; ///< no triangle meets another, or the scene does not ask for self-contact
};

struct StageShare {
    std::string name;
    double seconds = 0;
    std::size_t bytes = 0;
};

/// What was done on a coarser mesh before (Refine.h).
struct CoarseRun {
    int particles = 0, steps = 0;
    double simulatedSeconds = 0, heldSeconds = 0, sleptSeconds = 0, sleptSavedSeconds = 0; ///< as in SewReport [s]
    double sleptApartSteps = 0, sleptApartSavedSeconds = 0;                                ///< as in SewReport
    double cpuSeconds = 0, wallSeconds = 0;                                                ///< [s]
    std::string ending;                                                                    ///< as in SewReport
};

/// What a run did and what became of the garment; written as sew.json (docs/formats/sew.md).
struct SewReport {
    int particles = 0, springsStructural = 0, springsShear = 0, flexion = 0, bending = 0, twist = 0;
    std::vector<SeamResult> seams;
    std::vector<TackResult> tacks;
    std::vector<FoldReport> folds;
    std::optional<WornReport> worn; ///< absent without a body that has limbs
    ContactSummary contact;
    double mass = 0; ///< of the cloth with its interfacing [kg]
    int clampedCells = 0;
    std::optional<cloth::PaperReport> paper;         ///< in a scene of the paper
    std::optional<double> finishDisplacementMaximum; ///< [m]
    std::optional<double> finishSeconds;             ///< CPU time of the finish, with what was simulated between [s]
    StrainSummary strain;
    CurvatureSummary curvature;
    double simulatedSeconds = 0, cpuSeconds = 0, wallSeconds = 0;
    std::optional<double> restWallSeconds; ///< of them until it came to rest, before it was held or finished [s]
    double heldSeconds = 0;                ///< of them after rest, to see whether a waistband stays [s]
    double sleptSeconds = 0;               ///< of them in which nothing moved, so that nothing was computed [s]
    double sleptSavedSeconds = 0;          ///< as Simulation::savedBySleep
    double sleptApartSteps = 0;            ///< as Simulation::stepsSleptApart
    double sleptApartSavedSeconds = 0;     ///< as Simulation::savedBySleepApart
    int steps = 0, substeps = 0;
    std::optional<CoarseRun> coarse; ///< counted in the seconds and steps above
    bool atRest = false;             ///< in a scene of the paper by speed alone: its explicit steps find no equilibrium
    std::optional<double> residual;  ///< largest unbalanced force over the mean particle weight [–]
    double kineticEnergy = 0, gravityEnergy = 0, elasticEnergy = 0; ///< [J]
    std::size_t refusedFactorBytes = 0;                             ///< as Simulation::refusedFactor
    std::size_t peakBytes = 0;                                      ///< most memory the process has held
    std::string resultHash;
    std::vector<PhaseRun> phases; ///< what each ran with
    std::vector<StageShare> stages;
    std::vector<LeftOut> leftOut;
    std::vector<Warning> warnings;
    std::string ending; ///< "at rest", "time is up", "limit reached" or "time limit reached"

    [[nodiscard]] bool allClosed() const; ///< seams
    [[nodiscard]] bool allTacked() const;
    [[nodiscard]] bool ranOutOfTime() const; ///< ended by SewSettings::deadline
    /// Seams and tacks closed, at rest, outside the body, and layers apart where the scene asks for it.
    [[nodiscard]] bool reachedItsGoal(const SewSettings& settings) const;
};

/// Called after every frame step.
using FrameObserver = std::function<void(const Simulation&)>;

/// Runs a simulation until its garment is at rest, finishes it by statics, and looks at the result.
/// Errors: cancelled, or a number that is no longer finite.
[[nodiscard]] Result<SewReport> sew(Simulation& simulation, const SewSettings& settings, std::stop_token stop = {},
                                    const Progress& progress = {}, const FrameObserver& observer = {});

/// The keys that docs/formats/sew.md promises.
[[nodiscard]] Json toJson(const SewReport& report);

} // namespace toile::simulation
