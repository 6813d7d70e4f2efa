// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Progress.h"
#include "core/base/Team.h"
#include "core/base/TeamTrial.h"
#include "core/collision/BodySurface.h"
#include "core/collision/MovingSurface.h"
#include "core/dynamics/BodyContact.h"
#include "core/dynamics/CoarseLevels.h"
#include "core/dynamics/EnergyWatch.h"
#include "core/dynamics/Method.h"
#include "core/dynamics/Statics.h"
#include "core/dynamics/TotalEnergyWatch.h"
#include "core/dynamics/Xpbd.h"
#include "core/simulation/BodyPins.h"
#include "core/simulation/Checkpoint.h"
#include "core/simulation/Frame.h"
#include "core/simulation/Garment.h"
#include "core/simulation/Grips.h"
#include "core/simulation/InPlace.h"
#include "core/simulation/LevelsOf.h"
#include "core/simulation/MeetingPieces.h"
#include "core/simulation/Scene.h"
#include "core/simulation/SceneParts.h"
#include "core/simulation/Sleepers.h"
#include "core/simulation/StepPlan.h"
#include "core/simulation/Tacks.h"

#include <memory>
#include <stop_token>

namespace toile::simulation {

struct Speeds;

/// How far a seam is.
struct SeamState {
    std::string name;
    int pairs = 0;
    int order = 0;
    double initialGap = 0; ///< largest [m]
    double gapAtMerge = 0; ///< largest [m]
    bool merged = false;
};

struct SeamGap {
    double maximum = 0, mean = 0; ///< [m]
};

/// What a phase ran with.
struct PhaseRun {
    Phase phase = Phase::sewing;
    std::string_view method;                ///< as dynamics::nameOf
    double seconds = 0;                     ///< simulated
    dynamics::StepReport steps{.parts = 0}; ///< of all frame steps
    int redoneSteps = 0;   ///< frame steps that did not end in numbers, or by forces that gained energy, made again
    int unsolvedSteps = 0; ///< frame steps with a part that missed its tolerance
    int limitedSteps = 0;  ///< frame steps by positions in which cloth was as fast as speedLimit lets it be
};

/// No particle is faster by positions [m/s].
constexpr double speedLimit = 10;

struct DressingSettings {
    double releaseDamping =
        3000;                  ///< mass-proportional, in the first frame steps after the last seam or on a finer mesh,
                               ///< by coarse levels: cloth that yielded is suddenly stiff, and would leap [1/s]
    double releaseTime = 0.03; ///< for which it acts [s]
    double sewingDamping = 60; ///< mass-proportional, while seams close: cloth that is let go by a bent tube would
                               ///< otherwise fling into folds that differ left and right [1/s]
    double stiffeningTime = 0.5; ///< for which this damping goes on, as the cloth then no longer yields [s]
    double settlingDamping = 8;  ///< mass-proportional, after that while the cloth is not as slow as at rest, until it
                                ///< rests; of what was edited until it rests; and as long as it rests, until it sleeps:
                                ///< what swings in a second hardly swings over [1/s]
    double shakingTime = 2.0;   ///< from the last seam on, at most [s]
    double leastShaking = 0.75; ///< at least, for the cloth to begin to fall; then it ends when it is calm [s]
    double editShakingTime =
        0.2;                 ///< of a garment that lay and was edited: friction would keep what lay where it lay [s]
    double settlingTime = 4; ///< after the longest shaking: of coarse levels, and in air of this damping; what has not
                             ///< come to rest goes on without [s]
    double hangingTime = 8;  ///< the same of what hangs by a waistband that was carried over to a finer mesh: its folds
                             ///< creep longer [s]
    int sewingSubsteps = 20; ///< of a frame step at most, while seams close: yielding cloth sews well
};
inline constexpr DressingSettings dressing;

/// Statics of a garment. Layers that lie folded on each other take the most iterations.
inline constexpr dynamics::StaticSettings finishing{.maximumIterations = 600};

/// When a seam becomes one row of particles (docs/physics/seams.md).
struct MergeRule {
    double gap = 0.5e-3;        ///< largest of all pairs [m]
    double lateGap = 2e-3;      ///< of a seam that layers beside it hold open when it should long have closed [m]
    double late = 1.0;          ///< so long after its ramp ended [s]
    double relativeSpeed = 0.1; ///< largest of all pairs [m/s]
};

/// Which frame steps of cloth that is not too small for it are shared out: the bits are the same.
enum class Sharing {
    whereItPays, ///< as a TeamTrial finds
    always,
};

/// From where an edited garment goes on.
enum class GoesOn {
    asItLies,
    asSewn, ///< from where it lay when its last seam was closed, if nothing but its own weight has moved it since: it
            ///< falls into place as if it were put on anew. Frames show the drape before until it rests
};

/// A scene while time runs. Not shared between threads; others see frames.
class Simulation {
public:
    /// Meshes the pattern, places the pieces and builds the plan of a step.
    [[nodiscard]] static Result<Simulation> create(Scene scene, const MeshOverrides& overrides = {});

    /// The changed scene with the drape of the one before, carried over piece by piece by material coordinates;
    /// pieces that are new start where they are placed. Time goes on. The mesh is as the document and the overrides
    /// say.
    [[nodiscard]] static Result<Simulation> continued(Scene scene, const Simulation& before,
                                                      const MeshOverrides& overrides = {},
                                                      GoesOn from = GoesOn::asItLies);

    /// The scene from where a simulation of it stood; integrated by XPBD until drapeWith() says otherwise. Error when
    /// the checkpoint belongs to another scene or mesh.
    [[nodiscard]] static Result<Simulation> resumed(Scene scene, const MeshOverrides& overrides,
                                                    const Checkpoint& checkpoint);
    /// The nodes by which a garment on a finer mesh hangs: friction holds them from the first frame step on, and while
    /// it falls into place they have as much more inertia as it takes for few substeps to keep the cloth there as stiff
    /// as it is, however many the scene asks for. Until hands or a body that moves take hold of it. Empty: none, as it
    /// is made.
    void hangBy(std::vector<int> nodes);
    /// Where it stands now, of a body that stands where the scene has it. What is only remembered from step to step
    /// (what friction holds, which layers are near) is let go here as it will be by the simulation that is resumed:
    /// both go on to the same bits, if hands hold the same.
    [[nodiscard]] Checkpoint checkpoint();

    /// Integrates by this method (not in a scene of the paper) while no seam is being closed; sewing itself is
    /// position-based, which alone draws seams together. Absent: there is no motion after sewing, the garment is left
    /// to settle().
    void drapeWith(std::optional<dynamics::Method> method);
    [[nodiscard]] std::optional<dynamics::Method> drapingMethod() const { return drapingMethod_; }

    /// Shares the work of a step out from now on, where it is much enough to gain by it; null = alone. The bits are the
    /// same.
    void workWith(std::shared_ptr<Team> team, Sharing sharing = Sharing::whereItPays);

    /// What hands hold from now on, instead of what they held. Cheap while only targets move.
    void hold(std::vector<Grip> grips);

    /// The body moves so from now on, by position-based steps, and stays as its last pose is; its landmarks and axes
    /// are still those of where it stood. What is pinned to it goes along with what of it is nearest now. Error: the
    /// garment is still being put on, another method drapes it, there is no body, or it cannot move so.
    [[nodiscard]] Result<void> moveBody(std::shared_ptr<const geometry::VertexMotion> motion);
    [[nodiscard]] bool bodyMoves() const { return motion_ != nullptr; }
    /// The farthest that cloth pinned to a body that moves is from where the body has carried its place [m]: 0 unless
    /// other cloth holds it back.
    [[nodiscard]] double farthestOffItsPin() const;
    /// As it stands, with the landmarks of the scene's; absent: as the scene has it.
    [[nodiscard]] const std::optional<Shared<body::Body>>& movedBody() const { return movedBody_; }

    /// Builds stages from now on that the scene has no use for (planOf): by them tests and studies see that leaving
    /// them out changes nothing but the time.
    void force(std::vector<std::string> stages);

    /// One frame step of the scene. Error when a number is no longer finite or the step was stopped: all stands as if
    /// it had not begun, and what is remembered from step to step is let go as by checkpoint().
    [[nodiscard]] Result<void> advance(std::stop_token stop = {});

    /// Goes on to the equilibrium with contact and friction by Newton's method; fine cloth that drapes by
    /// position-based steps is drawn taut first. With no iterations allowed nothing moves, and the report says how far
    /// from equilibrium the cloth is.
    [[nodiscard]] Result<dynamics::StaticReport> settle(const dynamics::StaticSettings& settings,
                                                        std::stop_token stop = {}, const Progress& progress = {});

    [[nodiscard]] const Scene& scene() const { return scene_; }
    [[nodiscard]] const Garment& garment() const { return *garment_; }
    [[nodiscard]] const dynamics::ParticleState& state() const { return state_; }
    [[nodiscard]] const StepPlan& plan() const { return plan_; }
    /// Time of all stages since the start, also of those that are no longer there; "cloth" is the rest of a step.
    [[nodiscard]] std::vector<StepPlan::StageCost> stageCosts() const;
    [[nodiscard]] const Shared<FrameTopology>& topology() const { return topology_; }
    /// As it is now; null without a body.
    [[nodiscard]] const collision::BodySurface* body() const { return body_.get(); }
    [[nodiscard]] const std::vector<SeamState>& seams() const { return seams_; }
    [[nodiscard]] const std::vector<TackState>& tacks() const { return tacks_; } ///< as the pattern has them
    [[nodiscard]] Phase phase() const { return phase_; }
    [[nodiscard]] const std::vector<PhaseRun>& phases() const { return phases_; } ///< so far, in order
    /// Nothing moves any more but settle().
    [[nodiscard]] bool awaitsStatics() const { return !drapingMethod_ && phase_ == Phase::draping; }
    [[nodiscard]] int substeps() const { return substeps_; }
    [[nodiscard]] int fullSubsteps() const; ///< that position-based steps of this cloth need if no level corrects them
    [[nodiscard]] int steps() const { return steps_; }

    /// Pieces that meet where they are placed, and are let through each other while the garment is sewn; none where
    /// layers are not kept apart.
    [[nodiscard]] const std::vector<PiecePair>& meeting() const { return meeting_; }
    [[nodiscard]] bool allSeamsMerged() const;
    /// Gap of an open seam's pairs now; zero when merged.
    [[nodiscard]] SeamGap gapOf(std::size_t seam) const;
    /// How much the ends of a tack are farther apart now than its thread is long [m].
    [[nodiscard]] double gapOfTack(std::size_t tack) const;
    /// Largest displacement of a particle in the last frame step over its duration [m/s].
    [[nodiscard]] double largestSpeed() const { return largestSpeed_; }
    /// How long the cloth has been of rest (Speeds) with no seam closing [s].
    [[nodiscard]] double restingTime() const { return restingTime_; }
    /// Of the clock, in which the cloth slept: nothing drove it and nothing had moved for a second [s].
    [[nodiscard]] double sleptTime() const { return sleptTime_; }
    /// Wall time of the frame steps that were not computed for it, if each had taken as long as the others in the mean
    /// [s].
    [[nodiscard]] double savedBySleep() const { return sleptSteps_ * meanStepSeconds(); }
    /// Frame steps that were made without pieces that slept while others moved, and their wall time, as above; a step
    /// counts by the part of the particles that it was made without.
    [[nodiscard]] double stepsSleptApart() const { return sleptApart_; }
    [[nodiscard]] double savedBySleepApart() const { return sleptApart_ * meanStepSeconds(); }

    /// What a factor would have taken that did not fit in memory, so that conjugate gradients went on alone [B]; 0 =
    /// all did.
    [[nodiscard]] std::size_t refusedFactor() const { return refusedFactor_; }

    /// Positions of all nodes, as the topology numbers them.
    [[nodiscard]] std::vector<Vec3> nodePositions() const;
    [[nodiscard]] std::vector<Vec3> shownNodes() const; ///< as frames show them
    /// It was edited and falls into place anew (GoesOn::asSewn), while frames show the drape carried over.
    [[nodiscard]] bool fallsUnseen() const { return !shown_.empty(); }
    /// From now on frames show it as it falls.
    void beSeen() { shown_.clear(); }
    [[nodiscard]] Frame frame() const;

private:
    Simulation(Scene scene, SceneParts parts, MeshOverrides overrides);

    void rebuildPlan(); ///< all are awake
    void planAnew();
    [[nodiscard]] std::unique_ptr<const Garment> awakeNow() const;
    [[nodiscard]] const Garment& awake() const { return awake_ ? *awake_ : *garment_; }
    void noteSleepers(std::span<const Vec3> before, double duration);
    [[nodiscard]] bool holdsSleepers() const; ///< a hand does
    void leaveOutSleepers();
    [[nodiscard]] double meanStepSeconds() const {
        return computedSteps_ > 0 ? allSeconds_ / (computedSteps_ - sleptApart_) : 0;
    }
    void pinToBody();
    [[nodiscard]] std::unique_ptr<BodyPins> carriedAlong() const;
    void followBody();
    [[nodiscard]] dynamics::ContactMemory contactMemory() const;
    void standStill();
    void noteBody();
    [[nodiscard]] Result<dynamics::StepReport> moveBesideBody(double duration, std::stop_token stop);
    void planEnergyWatch();
    [[nodiscard]] Result<dynamics::StepReport> moveByPositions(double duration, std::stop_token stop);
    [[nodiscard]] Result<dynamics::StepReport> moveInSubsteps(double duration, int substeps, std::stop_token stop);
    [[nodiscard]] Result<dynamics::StepReport> moveByForces(double duration, std::stop_token stop);
    [[nodiscard]] bool isAsleep() const;
    void sleepFor(double duration);
    void planSubsteps();
    [[nodiscard]] Team* teamWorthWaking() const; ///< null: the cloth is too small to share
    [[nodiscard]] Team* teamOfStep() const;      ///< also null where sharing does not pay
    [[nodiscard]] Result<void> drawTaut(std::stop_token stop);
    [[nodiscard]] int askedSubsteps() const; ///< by the scene; 0 = from the mesh
    [[nodiscard]] LevelPlan levelPlan() const;
    [[nodiscard]] std::vector<double> inertiaIn(int substeps) const; ///< mass scaling; empty = none
    void planLevels(const LevelPlan& corrected);
    void correctByDueLevels();
    [[nodiscard]] bool levelsMayHelp() const;
    [[nodiscard]] bool tremblesInPlace(double duration);
    void noteRest(const Speeds& speeds, double duration);
    [[nodiscard]] bool rests() const;
    [[nodiscard]] bool fallsAsleep() const;
    [[nodiscard]] double movedLast() const; ///< when it did not rest [s]
    [[nodiscard]] double settledBy() const; ///< when what was sewn should rest [s]
    [[nodiscard]] Result<dynamics::StepReport> moveCloth(double duration, std::stop_token stop);
    [[nodiscard]] std::unique_ptr<dynamics::Integrator> integratorOf(dynamics::Method method) const;
    [[nodiscard]] double damping() const; ///< of the phase [1/s]
    void dampAnew();
    [[nodiscard]] dynamics::XpbdSettings settingsOfXpbd() const;
    [[nodiscard]] double shakingTime() const; ///< how long the garment is shaken at most [s]
    [[nodiscard]] PhaseRun& runOfStep();      ///< of this phase by this method
    void note(double duration, const dynamics::StepReport& step);
    [[nodiscard]] Phase duePhase() const;
    [[nodiscard]] Vec3 gravity() const { return phase_ == Phase::sewing ? Vec3{} : scene_.settings.gravity; }
    [[nodiscard]] bool givenUp(std::size_t seam) const;
    [[nodiscard]] bool givenUp(const TackState& tack) const;
    /// Whether the ramp of what began to close then, over such a gap, ended so long ago [s, m, s].
    [[nodiscard]] bool isOver(double start, double startGap, double since) const;
    [[nodiscard]] double startGapOf(std::size_t seam) const; ///< the largest of its pairs, when it began to close [m]
    [[nodiscard]] std::size_t closingTacks() const;
    [[nodiscard]] bool hasClosed(const TackState& tack) const;
    [[nodiscard]] bool closeReadyTacks();
    [[nodiscard]] std::vector<std::size_t> closingSeams() const;
    [[nodiscard]] bool mayMerge(std::size_t seam) const;
    [[nodiscard]] Result<bool> mergeReadySeams();
    void startDue();
    void startTack(std::size_t tack);
    void startSeam(std::size_t seam);
    void goOnDressing(bool closedSome);
    [[nodiscard]] std::vector<std::vector<Vec3>> carriedFrom(const Simulation& before,
                                                             std::vector<std::vector<Vec3>> drapes) const;
    [[nodiscard]] bool mayFallAnew(const Simulation& before) const;
    void beginToSew();
    [[nodiscard]] Result<void> keepSewn(const Simulation& before);
    void noteSewn();
    void lieAsSeen();
    void showWhatRests();

    Scene scene_;
    std::unique_ptr<const Garment> garment_; ///< the integrator keeps a reference to its model
    std::unique_ptr<Sleepers> sleepers_;     ///< of this garment; null before it drapes
    std::unique_ptr<const Garment> awake_;   ///< what of it the plan moves; null = all
    std::shared_ptr<const collision::BodySurface> body_;
    std::shared_ptr<collision::MovingSurface> motion_; ///< of a body that moves; then the surface is its
    std::vector<BodyPin> bodyPins_;                    ///< of a body that moves
    std::optional<Shared<body::Body>> movedBody_;
    Shared<FrameTopology> topology_;
    dynamics::ParticleState state_;
    std::shared_ptr<Team> team_; ///< null = alone
    Sharing sharing_ = Sharing::whereItPays;
    TeamTrial teamTrial_;                      ///< of position-based frame steps
    std::shared_ptr<std::vector<Grip>> grips_; ///< never null; the plan's stage reads it
    std::vector<std::string> forced_;          ///< stages that are built without need
    StepPlan plan_;
    const Garment* plannedFor_ = nullptr; ///< the garment that the plan is of
    MeshOverrides overrides_;
    std::unique_ptr<dynamics::CoarseLevels> levels_; ///< of this garment; null until they are needed
    std::string whyNoLevels_;                        ///< it has none; empty = it has, or none were asked for
    std::unique_ptr<dynamics::Xpbd> xpbd_;
    std::unique_ptr<dynamics::EnergyWatch> energyWatch_; ///< null where something drives the cloth, or other methods do
    std::unique_ptr<dynamics::TotalEnergyWatch> totalEnergyWatch_; ///< the same of the other methods
    std::optional<dynamics::Method> drapingMethod_ = dynamics::Method::xpbd;
    std::unique_ptr<dynamics::Integrator> integrator_; ///< while another method than XPBD is at work
    std::unique_ptr<dynamics::Integrator> safe_;       ///< makes steps of it again; null before the first
    int calmingFrames_ = 0;                            ///< left
    std::vector<PhaseRun> phases_;
    std::vector<SeamState> seams_;
    std::vector<std::vector<double>> seamGaps_; ///< of each pair when its seam began to close [m]
    std::vector<double> seamStart_;             ///< when it began [s]; negative = not yet
    std::vector<TackState> tacks_;
    std::vector<PiecePair> meeting_; ///< as they are placed; none where layers are not kept apart
    Phase phase_ = Phase::sewing;
    std::vector<Vec3> sewnNodes_;   ///< when the last seam was closed; empty: more than weight moved it since
    std::vector<int> hangsBy_;      ///< nodes, of a garment that has been made finer
    std::vector<Vec3> shown_;       ///< nodes in frames, while it falls unseen
    bool goesOnAsItLay_ = false;    ///< after an edit of a garment that lay: dressed as long as its seams close at once
    bool settles_ = false;          ///< it was sewn or edited, and has not rested since
    bool leaps_ = false;            ///< it yields now, or folds as a coarser mesh did: suddenly stiff, it would leap
    bool isCalm_ = false;           ///< after the last frame step
    double sewnTime_ = 0;           ///< when the last seam was closed or given up [s]
    double plannedDamping_ = 0;     ///< that of the plan [1/s]
    int plannedLevels_ = 0;         ///< coarse levels of the plan
    bool takesOneMore_ = true;      ///< one level more than leave 24 substeps, as far as it was tried
    bool areLevelsDue_ = false;     ///< they are to be made, or to forget, before the next step
    std::size_t refusedFactor_ = 0; ///< [B]
    int substeps_ = 0, steps_ = 0;
    double largestSpeed_ = 0, restingTime_ = 0;
    InPlace inPlace_;                              ///< of what trembles long after it was put on
    double stillTime_ = 0, sleptTime_ = 0;         ///< since when nothing moves; how long nothing was computed [s]
    int sleptSteps_ = 0, computedSteps_ = 0;       ///< frame steps
    double sleptApart_ = 0;                        ///< of those that were computed
    double stepSeconds_ = 0, allSeconds_ = 0;      ///< wall time of the last frame step that was computed, of all
    std::vector<StepPlan::StageCost> formerCosts_; ///< of plans that were replaced
};

} // namespace toile::simulation
