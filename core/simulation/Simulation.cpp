// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/Simulation.h"

#include "core/base/WallTime.h"
#include "core/simulation/AirOf.h"
#include "core/simulation/BodyContactOf.h"
#include "core/simulation/HangsBy.h"
#include "core/simulation/LayersApart.h"
#include "core/simulation/LevelsOf.h"
#include "core/simulation/PlanOf.h"
#include "core/simulation/SceneMemory.h"
#include "core/simulation/Speeds.h"
#include "core/simulation/Topology.h"

#include <algorithm>
#include <chrono>
#include <fmt/format.h>
#include <utility>

namespace toile::simulation {
namespace {

/// Of the methods that adapt their step: RMS error of a part [m].
constexpr double positionTolerance = 1e-4;
/// Frame steps of backward Euler before a method takes over from XPBD, whose soft state would ring at the true
/// stiffness: twice a factor of 1/ωh. Ref: Rannacher 1984
constexpr int calming = 2;
/// The least of a frame step while they do: in few substeps cloth is soft, and a hand stretches it like rubber.
constexpr int handSubsteps = 40;
void addCosts(std::vector<StepPlan::StageCost>& sum, const std::vector<StepPlan::StageCost>& more) {
    for (const StepPlan::StageCost& cost : more) {
        const auto same = std::ranges::find(sum, cost.name, &StepPlan::StageCost::name);
        if (same == sum.end()) {
            sum.push_back({cost.name, cost.seconds, 0, cost.heldBack});
        } else {
            same->seconds += cost.seconds;
            same->heldBack += cost.heldBack;
        }
    }
}

} // namespace

Simulation::Simulation(Scene scene, SceneParts parts, MeshOverrides overrides)
    : scene_(std::move(scene)), garment_(std::make_unique<const Garment>(std::move(parts.garment))),
      body_(std::move(parts.body)), topology_(topologyOf(scene_.pattern, *garment_->mesh)),
      grips_(std::make_shared<std::vector<Grip>>()), overrides_(std::move(overrides)), tacks_(std::move(parts.tacks)) {
    const meshing::GarmentMesh& mesh = *garment_->mesh;
    std::vector<Vec3> placed = placedNodes(layersApart(scene_.pattern, mesh), mesh);
    if (scene_.settings.selfContact && !scene_.paper) meeting_ = meetingPieces(mesh, placed);
    if (!meeting_.empty()) placed = placedNodes(layersApart(offEachOther(scene_.pattern, meeting_), mesh), mesh);
    state_.positions = particlePositions(garment_->particles, placed);
    state_.velocities.assign(state_.positions.size(), Vec3{});
    for (std::size_t seam = 0; seam < garment_->mesh->seams.size(); ++seam) {
        const pattern::Seam& authored = scene_.pattern.seams[seam];
        seams_.push_back({authored.name.empty() ? authored.id.value : authored.name,
                          static_cast<int>(garment_->mesh->seams[seam].pairs.size()), authored.order,
                          gapOf(seam).maximum, 0, false});
    }
    seamGaps_.resize(seams_.size());
    seamStart_.assign(seams_.size(), -1);
    for (std::size_t tack = 0; tack < tacks_.size(); ++tack) tacks_[tack].initialGap = gapOfTack(tack);
    if (seams_.empty() && tacks_.empty()) phase_ = Phase::draping;
    settles_ = leaps_ = phase_ == Phase::sewing && !scene_.paper;
    startDue();
}

Result<Simulation> Simulation::create(Scene scene, const MeshOverrides& overrides) {
    auto parts = partsOf(scene, overrides);
    if (!parts) return tl::unexpected(parts.error());
    Simulation made(std::move(scene), std::move(*parts), overrides);
    made.rebuildPlan();
    return made;
}

void Simulation::rebuildPlan() {
    if (sleepers_) sleepers_->wake();
    planAnew();
}

void Simulation::planAnew() {
    std::vector<SeamPair> pairs;
    for (const std::size_t seam : closingSeams()) {
        const auto& nodes = garment_->mesh->seams[seam].pairs;
        for (std::size_t k = 0; k < nodes.size(); ++k) {
            const int a = garment_->particles.particle(nodes[k][0]), b = garment_->particles.particle(nodes[k][1]);
            if (a != b) pairs.push_back({a, b, seamGaps_[seam][k], seamStart_[seam]});
        }
    }
    stillTime_ = 0;
    inPlace_.forget();
    const auto former = std::exchange(awake_, awakeNow()); // to its model refers what still stands
    addCosts(formerCosts_, plan_.costs());
    Scene now = scene_;
    if (phase_ != Phase::draping && hangsBy_.empty()) now.settings.bodyFriction = 0;
    const StepPlan before =
        std::exchange(plan_, planOf(now, *garment_, awake(), body_.get(), carriedAlong(),
                                    {phase_, std::move(pairs), tacks_, meeting_}, grips_, state_.positions, forced_));
    const auto* touched = bodyContactIn(before);
    auto* touches = bodyContactIn(plan_);
    if (touches && touched && plannedFor_ == garment_.get()) touches->goOnFrom(*touched, state_.positions);
    plannedFor_ = garment_.get();
    followBody();
    safe_.reset();
    leaveOutSleepers();
    if (!scene_.paper) planSubsteps(); // with coarse levels cloth is damped otherwise
    plannedDamping_ = damping();
    if (scene_.paper) {
        integrator_ = integratorOf(dynamics::Method::subcycledEuler);
        return;
    }
    xpbd_ = std::make_unique<dynamics::Xpbd>(awake().model, settingsOfXpbd(), inertiaIn(substeps_));
    xpbd_->workWith(teamOfStep());
    integrator_.reset();
    calmingFrames_ = 0;
    planEnergyWatch();
    if (phase_ == Phase::sewing || !drapingMethod_ || *drapingMethod_ == dynamics::Method::xpbd) return;
    if (!phases_.empty() && phases_.back().method == dynamics::nameOf(dynamics::Method::xpbd)) calmingFrames_ = calming;
    integrator_ = integratorOf(calmingFrames_ > 0 ? dynamics::Method::backwardEuler : *drapingMethod_);
}

dynamics::XpbdSettings Simulation::settingsOfXpbd() const {
    return {.damping = plannedDamping_, .speedLimit = speedLimit};
}

dynamics::ContactMemory Simulation::contactMemory() const {
    const auto* contact = bodyContactIn(plan_);
    return contact ? contact->memory() : dynamics::ContactMemory{};
}

/// Substeps of position-based steps, and the coarse levels that make them few.
void Simulation::planSubsteps() {
    const bool sewing = phase_ == Phase::sewing;
    substeps_ = askedSubsteps() > 0 ? askedSubsteps() : fullSubsteps();
    const LevelPlan corrected = levelPlan();
    plannedLevels_ = 0;
    areLevelsDue_ = false;
    if (sewing) plan_.leaveOut("coarse levels", "cloth that yields sews well");
    else if (askedSubsteps() > 0) plan_.leaveOut("coarse levels", "the scene says how many substeps");
    else if (drapingMethod_ != dynamics::Method::xpbd) plan_.leaveOut("coarse levels", "no position-based steps");
    else if (corrected.levels == 0) plan_.leaveOut("coarse levels", fmt::format("{} substeps suffice", substeps_));
    else if (!levelsMayHelp()) plan_.leaveOut("coarse levels", "only while a garment falls into its place");
    else planLevels(corrected);
    if (!grips_->empty() && askedSubsteps() == 0) substeps_ = std::max(substeps_, handSubsteps);
    if (sewing) substeps_ = std::min(substeps_, dressing.sewingSubsteps);
    if (const int asked = scene_.settings.substeps; !hangsBy_.empty() && asked > substeps_)
        plan_.leaveOut("substeps",
                       fmt::format("{} of the {} that the scene asks for suffice: inertia keeps stiff what it "
                                   "hangs by",
                                   substeps_, asked));
}

/// How many substeps keep its band stiff is what a scene asks for; inertia does it as well.
int Simulation::askedSubsteps() const {
    return hangsBy_.empty() ? scene_.settings.substeps : 0;
}

/// Of the substeps that are planned. Beside a body that moves levels have no memory, and three would mislead cloth that
/// two help; what came from a coarser mesh trembles by the last level it could have for longer than it saves, and by
/// three its free folds are so soft that statics does not find their equilibrium.
LevelPlan Simulation::levelPlan() const {
    if (hangsBy_.empty()) return levelPlanFor(substeps_, {.oneMore = takesOneMore_ && !motion_});
    LevelRule ofFiner{.bearable = 80, .fewest = 36, .oneMore = false};
    if (hangsInFreeFolds(*this)) ofFiner.most = 2;
    return levelPlanFor(substeps_, ofFiner);
}

std::vector<double> Simulation::inertiaIn(int substeps) const {
    if (hangsBy_.empty() || phase_ == Phase::sewing) return {};
    return inertiaOf(*garment_, hangsBy_, scene_.settings.frameStep / substeps);
}

void Simulation::hangBy(std::vector<int> nodes) {
    hangsBy_ = std::move(nodes);
    rebuildPlan();
}

int Simulation::fullSubsteps() const {
    return dynamics::substepsFor(scene_.settings.frameStep, dynamics::springsOnLongestLine(garment_->model),
                                 loadOf(scene_));
}

void Simulation::planLevels(const LevelPlan& corrected) {
    if (!whyNoLevels_.empty()) return plan_.leaveOut("coarse levels", whyNoLevels_);
    plannedLevels_ = corrected.levels;
    areLevelsDue_ = true;
    substeps_ = corrected.substeps;
}

/// Not before they are used: after an edit the first changed garment need not wait for them.
void Simulation::correctByDueLevels() {
    if (!areLevelsDue_) return;
    areLevelsDue_ = false;
    if (!levels_ || levels_->count() != plannedLevels_) {
        auto made = levelsOf(scene_.pattern, overrides_, *garment_, plannedLevels_, inertiaIn(substeps_));
        if (!made) {
            if (plannedLevels_ > levelPlanFor(fullSubsteps(), {.oneMore = false}).levels) takesOneMore_ = false;
            else whyNoLevels_ = made.error().text;
            planSubsteps();
            return correctByDueLevels();
        }
        levels_ = std::move(*made);
    }
    levels_->forget(); // so does one that is resumed here
    xpbd_->correctBy(levels_.get());
}

std::unique_ptr<dynamics::Integrator> Simulation::integratorOf(dynamics::Method method) const {
    return dynamics::makeIntegrator(method, awake().model,
                                    {.damping = plannedDamping_,
                                     .factorBytes = factorBytesOf(scene_, *garment_->mesh),
                                     .positionTolerance = positionTolerance});
}

void Simulation::drapeWith(std::optional<dynamics::Method> method) {
    if (method != drapingMethod_) lieAsSeen();
    drapingMethod_ = method;
    rebuildPlan();
}

void Simulation::workWith(std::shared_ptr<Team> team, Sharing sharing) {
    team_ = std::move(team);
    sharing_ = sharing;
    if (xpbd_) xpbd_->workWith(teamOfStep());
}

/// Below so many particles the members of a team wait for each other longer than they help (docs/simulation.md).
Team* Simulation::teamWorthWaking() const {
    constexpr int fewest = 4000;
    return garment_->model.particleCount() >= fewest ? team_.get() : nullptr;
}

Team* Simulation::teamOfStep() const {
    return sharing_ == Sharing::always || teamTrial_.shares() ? teamWorthWaking() : nullptr;
}

void Simulation::force(std::vector<std::string> stages) {
    forced_ = std::move(stages);
    rebuildPlan();
}

void Simulation::hold(std::vector<Grip> grips) {
    if (*grips_ == grips) return;
    restingTime_ = stillTime_ = 0;
    lieAsSeen();
    if (std::ranges::equal(*grips_, grips, &Grip::samePlace)) {
        *grips_ = std::move(grips);
        if (holdsSleepers()) rebuildPlan();
        return;
    }
    grips_ = std::make_shared<std::vector<Grip>>(std::move(grips)); // the plan that stands reads the others
    hangsBy_.clear();                                               // what is to move has its own mass
    rebuildPlan();
}

Result<dynamics::StepReport> Simulation::moveCloth(double duration, std::stop_token stop) {
    correctByDueLevels();
    if (integrator_) return moveByForces(duration, stop);
    const auto start = std::chrono::steady_clock::now();
    xpbd_->workWith(teamOfStep());
    auto done = motion_ ? moveBesideBody(duration, stop) : moveByPositions(duration, stop);
    if (done && teamWorthWaking()) teamTrial_.took(secondsSince(start)); // one that was cancelled took no time
    return done;
}

PhaseRun& Simulation::runOfStep() {
    const std::string_view method = integrator_ ? integrator_->name() : dynamics::nameOf(dynamics::Method::xpbd);
    if (phases_.empty() || phases_.back().phase != phase_ || phases_.back().method != method)
        phases_.push_back({.phase = phase_, .method = method});
    return phases_.back();
}

void Simulation::note(double duration, const dynamics::StepReport& step) {
    PhaseRun& run = runOfStep();
    run.seconds += duration;
    run.steps += step;
    run.unsolvedSteps += !step.accurate;
    refusedFactor_ = std::max(refusedFactor_, step.refusedFactor);
}

Result<void> Simulation::advance(std::stop_token stop) {
    const auto start = std::chrono::steady_clock::now();
    const double duration = scene_.settings.frameStep;
    if (isAsleep()) {
        if (stop.stop_requested()) return fail(ErrorCode::cancelled, "The step was stopped.");
        sleepFor(duration);
        return {};
    }
    const dynamics::ParticleState before = state_;
    const dynamics::ContactMemory contactBefore = contactMemory();
    const auto stepped = moveCloth(duration, stop);
    if (!stepped) {
        state_ = before;
        if (motion_) motion_->moveTo(state_.time);
        if (auto* contact = bodyContactIn(plan_)) (void)contact->recall(contactBefore);
        rebuildPlan(); // stages remember of the way that was not gone
        return tl::unexpected(stepped.error());
    }
    note(duration, *stepped);
    if (calmingFrames_ > 0 && --calmingFrames_ == 0) integrator_ = integratorOf(*drapingMethod_);
    ++steps_;
    const Speeds speeds = speedsOf(garment_->model.mass, before.positions, state_.positions, duration);
    largestSpeed_ = speeds.largest;
    constexpr double all = 0.999; // but rounding
    if (!integrator_ && largestSpeed_ > all * speedLimit) ++runOfStep().limitedSteps;
    const auto merged = mergeReadySeams();
    if (!merged) return tl::unexpected(merged.error());
    const bool closed = closeReadyTacks();
    if (!closingSeams().empty() || closingTacks() > 0) goesOnAsItLay_ = false;
    isCalm_ = speeds.areCalm();
    goOnDressing(*merged || closed);
    noteRest(speeds, duration);
    showWhatRests();
    if (motion_) noteBody();
    noteSleepers(before.positions, duration);
    stepSeconds_ = secondsSince(start);
    allSeconds_ += stepSeconds_;
    ++computedSteps_;
    return {};
}

std::vector<StepPlan::StageCost> Simulation::stageCosts() const {
    std::vector<StepPlan::StageCost> costs = formerCosts_;
    addCosts(costs, plan_.costs());
    for (StepPlan::StageCost& cost : costs)
        if (const auto* stage = plan_.find(cost.name)) cost.bytes = stage->bytes();
    double inStages = 0;
    for (const StepPlan::StageCost& cost : costs) inStages += cost.seconds;
    costs.push_back(
        {"cloth", std::max(0.0, allSeconds_ - inStages),
         (xpbd_ ? xpbd_->bytes() : 0) + (levels_ ? levels_->bytes() : 0) + (integrator_ ? integrator_->bytes() : 0)});
    return costs;
}

std::vector<Vec3> Simulation::nodePositions() const {
    std::vector<Vec3> nodes;
    nodes.reserve(garment_->particles.particleOf.size());
    for (const int particle : garment_->particles.particleOf) nodes.push_back(state_.positions[particle]);
    return nodes;
}

Frame Simulation::frame() const {
    Frame frame;
    frame.topology = topology_;
    frame.positions = shownNodes();
    frame.body = movedBody_;
    frame.bodyMoves = bodyMoves();
    frame.phase = phase_;
    frame.time = state_.time;
    frame.framesPerSecond = stepSeconds_ > 0 ? 1 / stepSeconds_ : 0;
    frame.particles = garment_->particles.particleCount;
    for (const std::size_t seam : closingSeams())
        frame.largestSeamGap = std::max(frame.largestSeamGap, gapOf(seam).maximum);
    for (std::size_t tack = 0; tack < tacks_.size(); ++tack)
        if (!tacks_[tack].closed) frame.largestSeamGap = std::max(frame.largestSeamGap, gapOfTack(tack));
    frame.largestSpeed = largestSpeed_;
    frame.atRest = rests();
    return frame;
}

} // namespace toile::simulation
