// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/Simulation.h"

#include "core/simulation/CarryOver.h"
#include "core/simulation/LayersApart.h"
#include "core/simulation/LevelsOf.h"
#include "core/simulation/PlanOf.h"
#include "core/simulation/SceneCheck.h"
#include "core/simulation/SeamClosing.h"
#include "core/simulation/Topology.h"

#include <algorithm>
#include <chrono>
#include <fmt/format.h>
#include <limits>

namespace toile::simulation {
namespace {

constexpr double restingSpeed = 0.005; // [m/s]
constexpr double longEnough = 0.5;     ///< that slow, for a garment to be at rest [s]
constexpr MergeRule mergeRule;
constexpr TackSettings tackSettings;
constexpr DressingSettings dressing;
/// Of the methods that adapt their step: RMS error of a part [m].
constexpr double positionTolerance = 1e-4;
/// Frame steps of backward Euler before a method takes over from XPBD, whose soft state would ring at the true
/// stiffness: twice a factor of 1/ωh. Ref: Rannacher 1984
constexpr int calming = 2;
/// Of cloth that hands hold [1/s]: its taut edges are strings that would go on ringing, by position-based steps for
/// ever.
constexpr double handDamping = 5;
/// The least of a frame step while they do: in few substeps cloth is soft, and a hand stretches it like rubber.
constexpr int handSubsteps = 40;
/// Of a garment that lay and goes on after an edit, until it lies again [1/s].
constexpr double editDamping = 12;
/// Before statics of fine cloth: so many times the substeps, for so many frame steps, with so much damping [1/s].
constexpr int tautSubsteps = 4, tautFrames = 12;
constexpr double tautDamping = 10;
/// A seam that is still open this long after its ramp ended is given up, so that the next order may begin [s].
constexpr double patience = 2.0;

Result<void> checkedSettings(const SceneSettings& settings) {
    const auto problems = checkScene(settings);
    if (problems.empty()) return {};
    return fail(ErrorCode::invalidInput, problems.front().text, problems.front().place);
}

Result<std::shared_ptr<const collision::BodySurface>> surfaceOf(const Scene& scene) {
    if (!scene.body) return nullptr;
    auto surface = collision::BodySurface::create((*scene.body)->mesh);
    if (!surface) return tl::unexpected(surface.error());
    return std::make_shared<const collision::BodySurface>(std::move(*surface));
}

Result<Garment> flatGarment(const Scene& scene, const MeshOverrides& overrides) {
    MeshOverrides asked = overrides;
    if (scene.paper && !asked.rule) asked.rule = pattern::LineRule::paper;
    const auto input = meshInputOf(scene.pattern, asked);
    if (!input) return tl::unexpected(input.error());
    auto mesh = meshing::meshGarment(*input);
    if (!mesh) return tl::unexpected(mesh.error());
    std::vector<bool> merged(mesh->seams.size(), false);
    return makeGarment(scene.pattern, Shared<meshing::GarmentMesh>(std::move(*mesh)), std::move(merged), scene.paper);
}

/// The paper's way knows seams alone.
Result<std::vector<TackState>> threadsOf(const Scene& scene, const Garment& garment) {
    if (scene.paper) return std::vector<TackState>{};
    return tacksOf(scene.pattern, *garment.mesh, tackSettings);
}

/// Particles where nodes are; nodes of one particle are taken at their mean.
std::vector<Vec3> particlePositions(const ParticleMap& map, const std::vector<Vec3>& nodes) {
    std::vector<Vec3> sum(map.particleCount);
    std::vector<int> count(map.particleCount, 0);
    for (std::size_t node = 0; node < nodes.size(); ++node) {
        sum[map.particleOf[node]] += nodes[node];
        ++count[map.particleOf[node]];
    }
    for (int particle = 0; particle < map.particleCount; ++particle) sum[particle] = sum[particle] / count[particle];
    return sum;
}

/// Particles that become one take their common centre of mass and momentum.
dynamics::ParticleState merged(const dynamics::ParticleState& before, const Garment& from, const Garment& to) {
    constexpr double massOfSlaves = 1e-12; // a slave has no mass of its own and never merges; any weight will do
    const int count = to.particles.particleCount;
    dynamics::ParticleState after{std::vector<Vec3>(count), std::vector<Vec3>(count), before.time};
    std::vector<double> mass(count, 0);
    std::vector<char> counted(from.particles.particleCount, 0);
    for (std::size_t node = 0; node < from.particles.particleOf.size(); ++node) {
        const int old = from.particles.particleOf[node], now = to.particles.particleOf[node];
        if (counted[old]++) continue;
        const double m = std::max(from.model.mass[old], massOfSlaves);
        after.positions[now] += before.positions[old] * m;
        after.velocities[now] += before.velocities[old] * m;
        mass[now] += m;
    }
    for (int particle = 0; particle < count; ++particle) {
        after.positions[particle] = after.positions[particle] / mass[particle];
        after.velocities[particle] = after.velocities[particle] / mass[particle];
    }
    return after;
}

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

/// When a garment was sewn that has been dressed, and left by its coarse levels, by now.
double longSewn(double now) {
    return now - 1 - dressing.shakingTime - dressing.levelsTime;
}

} // namespace

Simulation::Simulation(Scene scene, Garment garment, std::shared_ptr<const collision::BodySurface> body,
                       MeshOverrides overrides, std::vector<TackState> tacks)
    : scene_(std::move(scene)), garment_(std::make_unique<const Garment>(std::move(garment))), body_(std::move(body)),
      topology_(topologyOf(scene_.pattern, *garment_->mesh)), grips_(std::make_shared<std::vector<Grip>>()),
      overrides_(std::move(overrides)), tacks_(std::move(tacks)) {
    state_.positions = particlePositions(garment_->particles,
                                         placedNodes(layersApart(scene_.pattern, *garment_->mesh), *garment_->mesh));
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
    startDue();
    rebuildPlan();
}

Result<Simulation> Simulation::create(Scene scene, const MeshOverrides& overrides) {
    if (auto sound = checkedSettings(scene.settings); !sound) return tl::unexpected(sound.error());
    auto body = surfaceOf(scene);
    if (!body) return tl::unexpected(body.error());
    auto garment = flatGarment(scene, overrides);
    if (!garment) return tl::unexpected(garment.error());
    auto tacks = threadsOf(scene, *garment);
    if (!tacks) return tl::unexpected(tacks.error());
    return Simulation(std::move(scene), std::move(*garment), std::move(*body), overrides, std::move(*tacks));
}

Result<Simulation> Simulation::continued(Scene scene, const Simulation& before) {
    if (auto sound = checkedSettings(scene.settings); !sound) return tl::unexpected(sound.error());
    const bool sameBody = scene.body.has_value() == before.scene_.body.has_value() &&
                          (!scene.body || scene.body->sameAs(*before.scene_.body));
    auto body = sameBody ? Result<std::shared_ptr<const collision::BodySurface>>(before.body_) : surfaceOf(scene);
    if (!body) return tl::unexpected(body.error());
    auto garment = flatGarment(scene, {});
    if (!garment) return tl::unexpected(garment.error());
    auto tacks = threadsOf(scene, *garment);
    if (!tacks) return tl::unexpected(tacks.error());
    Simulation after(std::move(scene), std::move(*garment), std::move(*body), {}, std::move(*tacks));

    const std::vector<Vec3> draped = before.nodePositions();
    std::vector<Vec3> nodes = after.nodePositions();
    for (std::size_t piece = 0; piece < after.scene_.pattern.pieces.size(); ++piece) {
        const auto& old = before.scene_.pattern.pieces;
        const auto found = std::ranges::find_if(
            old, [&](const auto& candidate) { return candidate->id == after.scene_.pattern.pieces[piece]->id; });
        if (found == old.end()) continue;
        const auto from = static_cast<std::size_t>(found - old.begin());
        const meshing::PieceMesh& oldMesh = before.garment_->mesh->pieces[from];
        const DrapedPiece drape(
            oldMesh, std::span(draped).subspan(before.garment_->particles.firstNode[from], oldMesh.nodes.size()));
        const meshing::PieceMesh& mesh = after.garment_->mesh->pieces[piece];
        for (std::size_t node = 0; node < mesh.nodes.size(); ++node)
            nodes[after.garment_->particles.firstNode[piece] + node] = drape.at(mesh.nodes[node]);
    }
    after.state_.positions = particlePositions(after.garment_->particles, nodes);
    after.state_.time = before.state_.time;
    after.steps_ = before.steps_;
    after.grips_ = before.grips_;
    after.goesOnAsItLay_ = before.phase_ == Phase::draping || before.goesOnAsItLay_;
    after.seamStart_.assign(after.seams_.size(), -1);
    for (TackState& tack : after.tacks_) tack.start = -1;
    after.startDue();
    after.rebuildPlan();
    return after;
}

void Simulation::rebuildPlan() {
    std::vector<SeamPair> pairs;
    for (const std::size_t seam : closingSeams()) {
        const auto& nodes = garment_->mesh->seams[seam].pairs;
        for (std::size_t k = 0; k < nodes.size(); ++k) {
            const int a = garment_->particles.particle(nodes[k][0]), b = garment_->particles.particle(nodes[k][1]);
            if (a != b) pairs.push_back({a, b, seamGaps_[seam][k], seamStart_[seam]});
        }
    }
    addCosts(formerCosts_, plan_.costs());
    Scene now = scene_;
    if (phase_ != Phase::draping) now.settings.bodyFriction = 0;
    plan_ = planOf(now, *garment_, body_.get(), std::move(pairs), tacks_, grips_, state_.positions, forced_);
    plannedDamping_ = damping();
    if (scene_.paper) {
        integrator_ = integratorOf(dynamics::Method::subcycledEuler);
        return;
    }
    xpbd_ = std::make_unique<dynamics::Xpbd>(garment_->model,
                                             dynamics::XpbdSettings{.damping = plannedDamping_, .speedLimit = 10});
    planSubsteps();
    integrator_.reset();
    calmingFrames_ = 0;
    if (phase_ == Phase::sewing || !drapingMethod_ || *drapingMethod_ == dynamics::Method::xpbd) return;
    if (!phases_.empty() && phases_.back().method == dynamics::nameOf(dynamics::Method::xpbd)) calmingFrames_ = calming;
    integrator_ = integratorOf(calmingFrames_ > 0 ? dynamics::Method::backwardEuler : *drapingMethod_);
}

/// Substeps of position-based steps, and the coarse levels that make them few.
void Simulation::planSubsteps() {
    const bool sewing = phase_ == Phase::sewing;
    substeps_ = scene_.settings.substeps > 0
                    ? scene_.settings.substeps
                    : dynamics::substepsFor(scene_.settings.frameStep, dynamics::springsOnLongestLine(garment_->model),
                                            length(scene_.settings.gravity));
    const int levels = coarseLevelsFor(substeps_);
    plannedLevels_ = levelsMayHelp();
    if (sewing) plan_.leaveOut("coarse levels", "cloth that yields sews well");
    else if (scene_.settings.substeps > 0) plan_.leaveOut("coarse levels", "the scene says how many substeps");
    else if (drapingMethod_ != dynamics::Method::xpbd) plan_.leaveOut("coarse levels", "no position-based steps");
    else if (levels == 0) plan_.leaveOut("coarse levels", fmt::format("{} substeps suffice", substeps_));
    else if (!plannedLevels_) plan_.leaveOut("coarse levels", "only while a garment falls into its place");
    else correctByLevels(levels);
    if (!grips_->empty() && scene_.settings.substeps == 0) substeps_ = std::max(substeps_, handSubsteps);
    if (sewing) substeps_ = std::min(substeps_, dressing.sewingSubsteps);
}

/// Fine cloth may go on trembling by levels where it is crumpled; hands move it anyway.
bool Simulation::levelsMayHelp() const {
    return !grips_->empty() || state_.time <= sewnTime_ + dressing.shakingTime + dressing.levelsTime;
}

void Simulation::correctByLevels(int levels) {
    if (whyNoLevels_.empty() && (!levels_ || levels_->count() != levels)) {
        auto made = levelsOf(scene_.pattern, overrides_, *garment_, levels);
        if (made) levels_ = std::move(*made);
        else whyNoLevels_ = made.error().text;
    }
    if (!whyNoLevels_.empty()) return plan_.leaveOut("coarse levels", whyNoLevels_);
    levels_->forget(); // so does one that is resumed here
    xpbd_->correctBy(levels_.get());
    substeps_ = (substeps_ + (1 << levels) - 1) >> levels;
}

std::unique_ptr<dynamics::Integrator> Simulation::integratorOf(dynamics::Method method) const {
    return dynamics::makeIntegrator(method, garment_->model,
                                    {.damping = plannedDamping_, .positionTolerance = positionTolerance});
}

double Simulation::damping() const {
    if (phase_ == Phase::draping) {
        const double least = goesOnAsItLay_ ? editDamping : grips_->empty() ? 0 : handDamping;
        return std::max(scene_.settings.damping, least);
    }
    const bool stiffening = phase_ == Phase::shaking && state_.time < sewnTime_ + dressing.stiffeningTime;
    return phase_ == Phase::sewing || stiffening ? dressing.sewingDamping : dressing.shakingDamping;
}

void Simulation::drapeWith(std::optional<dynamics::Method> method) {
    drapingMethod_ = method;
    rebuildPlan();
}

void Simulation::force(std::vector<std::string> stages) {
    forced_ = std::move(stages);
    rebuildPlan();
}

void Simulation::hold(std::vector<Grip> grips) {
    if (*grips_ == grips) return;
    restingTime_ = 0;
    if (std::ranges::equal(*grips_, grips, &Grip::samePlace)) {
        *grips_ = std::move(grips);
        return;
    }
    grips_ = std::make_shared<std::vector<Grip>>(std::move(grips)); // the plan that stands reads the others
    rebuildPlan();
}

Result<dynamics::StepReport> Simulation::moveCloth(double duration, std::stop_token stop) {
    if (integrator_) return integrator_->step(state_, duration, gravity(), plan_.stages(), stop);
    if (auto done = xpbd_->step(state_, duration, substeps_, gravity(), plan_.stages(), stop); !done)
        return tl::unexpected(done.error());
    return dynamics::StepReport{.parts = substeps_};
}

void Simulation::note(double duration, const dynamics::StepReport& step) {
    const std::string_view method = integrator_ ? integrator_->name() : dynamics::nameOf(dynamics::Method::xpbd);
    if (phases_.empty() || phases_.back().phase != phase_ || phases_.back().method != method)
        phases_.push_back({.phase = phase_, .method = method});
    phases_.back().seconds += duration;
    phases_.back().steps += step;
    phases_.back().unsolvedSteps += !step.accurate;
}

std::vector<std::size_t> Simulation::closingSeams() const {
    std::vector<std::size_t> closing;
    for (std::size_t seam = 0; seam < seams_.size(); ++seam)
        if (!seams_[seam].merged && seamStart_[seam] >= 0) closing.push_back(seam);
    return closing;
}

bool Simulation::isOver(double start) const {
    return start >= 0 && state_.time > start + scene_.settings.seamTime + patience;
}

std::size_t Simulation::closingTacks() const {
    return std::ranges::count_if(tacks_, [&](const TackState& tack) { return tack.start >= 0 && !tack.closed; });
}

Phase Simulation::duePhase() const {
    for (std::size_t seam = 0; seam < seams_.size(); ++seam)
        if (!seams_[seam].merged && !givenUp(seam)) return Phase::sewing;
    for (const TackState& tack : tacks_)
        if (!tack.closed && !isOver(tack.start)) return Phase::sewing;
    if (phase_ == Phase::sewing) return drapingMethod_ && !goesOnAsItLay_ ? Phase::shaking : Phase::draping;
    return state_.time > sewnTime_ + dressing.shakingTime ? Phase::draping : phase_;
}

void Simulation::startDue() {
    // The smallest order that is not done yet begins; one that cannot close does not hold up the next for ever.
    int due = std::numeric_limits<int>::max();
    for (std::size_t seam = 0; seam < seams_.size(); ++seam)
        if (!seams_[seam].merged && !givenUp(seam)) due = std::min(due, seams_[seam].order);
    for (const TackState& tack : tacks_)
        if (!tack.closed && !isOver(tack.start)) due = std::min(due, tack.order);
    for (std::size_t tack = 0; tack < tacks_.size(); ++tack) {
        if (tacks_[tack].start >= 0 || tacks_[tack].order > due) continue;
        tacks_[tack].start = state_.time;
        tacks_[tack].startGap = gapOfTack(tack);
    }
    for (std::size_t seam = 0; seam < seams_.size(); ++seam) {
        if (seams_[seam].merged || seamStart_[seam] >= 0 || seams_[seam].order > due) continue;
        seamStart_[seam] = state_.time;
        seamGaps_[seam].clear();
        for (const auto& [a, b] : garment_->mesh->seams[seam].pairs)
            seamGaps_[seam].push_back(geometry::distance(state_.positions[garment_->particles.particle(a)],
                                                         state_.positions[garment_->particles.particle(b)]));
    }
}

bool Simulation::mayMerge(std::size_t seam) const {
    return std::ranges::all_of(garment_->mesh->seams[seam].pairs, [&](const auto& pair) {
        const int a = garment_->particles.particle(pair[0]), b = garment_->particles.particle(pair[1]);
        return geometry::distance(state_.positions[a], state_.positions[b]) <= mergeRule.gap &&
               geometry::distance(state_.velocities[a], state_.velocities[b]) <= mergeRule.relativeSpeed;
    });
}

Result<void> Simulation::mergeReadySeams() {
    std::vector<bool> mergedSeams = garment_->mergedSeams;
    bool changed = false;
    for (const std::size_t seam : closingSeams()) {
        if (!mayMerge(seam)) continue;
        seams_[seam].gapAtMerge = gapOf(seam).maximum;
        mergedSeams[seam] = changed = true;
    }
    if (!changed) return {};
    auto sewn = makeGarment(scene_.pattern, garment_->mesh, std::move(mergedSeams), scene_.paper);
    if (!sewn) return tl::unexpected(sewn.error());
    state_ = merged(state_, *garment_, *sewn);
    garment_ = std::make_unique<const Garment>(std::move(*sewn));
    levels_.reset();
    whyNoLevels_.clear();
    for (std::size_t seam = 0; seam < seams_.size(); ++seam) seams_[seam].merged = garment_->mergedSeams[seam];
    rebuildPlan();
    return {};
}

bool Simulation::hasClosed(const TackState& tack) const {
    const ParticleMap& particles = garment_->particles;
    return gapBetween(tack, particles, state_.positions) <= tackSettings.closedGap &&
           length(wayBetween(tack, particles, state_.velocities)) <= tackSettings.closedSpeed;
}

/// From now on their threads hold with their whole strength, also where forces are solved for.
void Simulation::holdClosedTacks() {
    bool changed = false;
    for (TackState& tack : tacks_)
        if (tack.start >= 0 && !tack.closed && hasClosed(tack)) tack.closed = changed = true;
    if (changed) rebuildPlan();
}

void Simulation::goOnDressing() {
    const std::size_t closing = closingSeams().size() + closingTacks();
    startDue();
    const Phase due = duePhase();
    if (due != phase_ && phase_ == Phase::sewing)
        sewnTime_ = goesOnAsItLay_ ? longSewn(state_.time) : state_.time; // what lay needs no levels to fall
    if (due == phase_ && closingSeams().size() + closingTacks() == closing && damping() == plannedDamping_ &&
        levelsMayHelp() == plannedLevels_)
        return;
    phase_ = due;
    rebuildPlan();
}

Result<void> Simulation::advance(std::stop_token stop) {
    const auto start = std::chrono::steady_clock::now();
    const double duration = scene_.settings.frameStep;
    const dynamics::ParticleState before = state_;
    const auto stepped = moveCloth(duration, stop);
    if (!stepped) {
        state_ = before;
        return tl::unexpected(stepped.error());
    }
    note(duration, *stepped);
    if (calmingFrames_ > 0 && --calmingFrames_ == 0) integrator_ = integratorOf(*drapingMethod_);
    ++steps_;
    largestSpeed_ = 0;
    for (std::size_t i = 0; i < state_.positions.size(); ++i)
        largestSpeed_ =
            std::max(largestSpeed_, geometry::distance(before.positions[i], state_.positions[i]) / duration);
    if (const auto sewn = mergeReadySeams(); !sewn) return sewn;
    holdClosedTacks();
    if (!closingSeams().empty() || closingTacks() > 0 || restingTime_ >= longEnough) goesOnAsItLay_ = false;
    goOnDressing();
    restingTime_ = largestSpeed_ < restingSpeed && phase_ == Phase::draping ? restingTime_ + duration : 0;
    stepSeconds_ = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    allSeconds_ += stepSeconds_;
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

/// Cloth is as soft as its substeps are long: statics would have to draw it taut first, which many short ones do for a
/// tenth of the time where the mesh is fine. The clock stands still.
Result<void> Simulation::drawTaut(std::stop_token stop) {
    const double time = state_.time, duration = scene_.settings.frameStep;
    const int substeps = dynamics::substepsFor(duration, dynamics::springsOnLongestLine(garment_->model),
                                               length(scene_.settings.gravity));
    if (drapingMethod_ != dynamics::Method::xpbd || scene_.paper || coarseLevelsFor(substeps) == 0) return {};
    dynamics::Xpbd xpbd(garment_->model, {.damping = tautDamping, .speedLimit = 10});
    for (int frame = 0; frame < tautFrames; ++frame)
        if (auto done = xpbd.step(state_, duration, tautSubsteps * substeps, gravity(), plan_.stages(), stop); !done)
            return done;
    state_.time = time;
    return {};
}

Result<dynamics::StaticReport> Simulation::settle(const dynamics::StaticSettings& settings, std::stop_token stop,
                                                  const Progress& progress) {
    const dynamics::ParticleState before = state_;
    if (const auto taut = drawTaut(stop); !taut) {
        state_ = before;
        return tl::unexpected(taut.error());
    }
    auto report = dynamics::solveStatic(garment_->model, state_, scene_.settings.gravity, plan_.stages(), settings,
                                        stop, progress);
    if (!report) {
        state_ = before;
        return report;
    }
    report->displacementMaximum = 0;
    for (std::size_t p = 0; p < state_.positions.size(); ++p)
        report->displacementMaximum =
            std::max(report->displacementMaximum, geometry::distance(before.positions[p], state_.positions[p]));
    return report;
}

bool Simulation::allSeamsMerged() const {
    return std::ranges::all_of(seams_, [](const SeamState& seam) { return seam.merged; });
}

SeamGap Simulation::gapOf(std::size_t seam) const {
    SeamGap gap;
    const auto& pairs = garment_->mesh->seams[seam].pairs;
    for (const auto& [a, b] : pairs) {
        const double d = geometry::distance(state_.positions[garment_->particles.particle(a)],
                                            state_.positions[garment_->particles.particle(b)]);
        gap.maximum = std::max(gap.maximum, d);
        gap.mean += d / static_cast<double>(pairs.size());
    }
    return gap;
}

double Simulation::gapOfTack(std::size_t tack) const {
    return gapBetween(tacks_[tack], garment_->particles, state_.positions);
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
    frame.positions = nodePositions();
    frame.time = state_.time;
    frame.framesPerSecond = stepSeconds_ > 0 ? 1 / stepSeconds_ : 0;
    frame.particles = garment_->particles.particleCount;
    for (const std::size_t seam : closingSeams())
        frame.largestSeamGap = std::max(frame.largestSeamGap, gapOf(seam).maximum);
    for (std::size_t tack = 0; tack < tacks_.size(); ++tack)
        if (!tacks_[tack].closed) frame.largestSeamGap = std::max(frame.largestSeamGap, gapOfTack(tack));
    frame.largestSpeed = largestSpeed_;
    frame.atRest = restingTime_ >= longEnough;
    return frame;
}

} // namespace toile::simulation
