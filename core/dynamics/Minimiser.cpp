// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/dynamics/Minimiser.h"

#include "core/base/Contracts.h"
#include "core/cloth/Forces.h"
#include "core/dynamics/BlockSolver.h"
#include "core/dynamics/BlockVectors.h"
#include "core/dynamics/Eliminated.h"
#include "core/dynamics/TrustedStep.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace toile::dynamics {
namespace {

constexpr double standardGravity = 9.81; ///< [m/s²]; scale of residuals where there is no gravity

/// Friction is fixed anew when the residual has fallen to this part of what it was then [–].
constexpr double frictionEvery = 0.1;

/// A factor of statics serves so many iterations at most …
constexpr int factorServes = 20;
/// … and none after one that took more conjugate gradients than this.
constexpr int manyGradients = 12;
/// Fewer free particles have one for every iteration, shifted by inertia: it is cheap there, and where soft directions
/// turn, as of a strap that swings or of a chain of stiff links, an old one leads across them.
constexpr std::size_t fewParticles = 4000;
/// Their first Levenberg weight μ of ½μ|Δx|²_M [1/s²]; it falls towards 0.
constexpr double firstInertia = 100;
/// The smallest that is tried before none, over the scale [–].
constexpr double leastShift = 1e-4;
/// What it factors is the projected Hessian and so much inertia [1/s²]: soft directions keep a length.
constexpr double leastInertia = 0.01;

/// Hands blocks of particles to the unknowns that move them.
class EliminatingSink : public HessianSink {
public:
    EliminatingSink(const Eliminated& eliminated, HessianSink& target) : eliminated_(eliminated), target_(target) {}

    void add(int i, int j, const double (&block)[9]) override {
        for (const auto& [row, rowWeight] : eliminated_.termsOf(i))
            for (const auto& [column, columnWeight] : eliminated_.termsOf(j)) {
                if (row < column) continue; // the matrix keeps the other half
                const double weight = rowWeight * columnWeight;
                if (weight == 1) {
                    target_.add(row, column, block);
                    continue;
                }
                double scaled[9];
                for (int k = 0; k < 9; ++k) scaled[k] = weight * block[k];
                target_.add(row, column, scaled);
            }
    }

private:
    const Eliminated& eliminated_;
    HessianSink& target_;
};

bool allFinite(std::span<const Vec3> values) {
    return std::ranges::all_of(values, [](const Vec3& v) { return isFinite(v); });
}

} // namespace

struct Minimiser::Data {
    Data(const cloth::ClothModel& m, MinimiserSettings s)
        : model(m), settings(s), eliminated(m), solver(eliminated.count(), s.gradientIterations) {
        for (int particle : eliminated.free()) mass.push_back(m.mass[particle]);
    }

    /// What can be said before any work; remembers the counts of the solver.
    Result<void> begin(std::span<Vec3> positions, const MinimiserProblem& problem) {
        expects(positions.size() == model.mass.size(), "one position per particle");
        expects(problem.inertia == 0 || problem.target.size() == positions.size(), "inertia needs a target");
        if (eliminated.massless() >= 0)
            return fail(ErrorCode::invalidInput, fmt::format("Particle {} has no mass.", eliminated.massless()));
        eliminated.place(positions);
        analyses = solver.analyses();
        factorizations = solver.factorizations();
        gradientIterations = solver.gradientIterations();
        return {};
    }
    void count(MinimiserReport& report) const {
        report.analyses = solver.analyses() - analyses;
        report.factorizations = solver.factorizations() - factorizations;
        report.gradientIterations += solver.gradientIterations() - gradientIterations;
    }

    const cloth::ClothModel& model;
    MinimiserSettings settings;
    Eliminated eliminated;
    BlockSolver solver;
    std::vector<double> mass;                                     ///< of the unknowns [kg]
    int analyses = 0, factorizations = 0, gradientIterations = 0; ///< of the solver before this run
};

Minimiser::Minimiser(const cloth::ClothModel& model, MinimiserSettings settings)
    : data_(std::make_unique<Data>(model, settings)) {}
Minimiser::Minimiser(Minimiser&&) noexcept = default;
Minimiser& Minimiser::operator=(Minimiser&&) noexcept = default;
Minimiser::~Minimiser() = default;

std::size_t Minimiser::bytes() const {
    return sizeof(Data) + data_->solver.bytes() + data_->mass.capacity() * sizeof(double);
}

namespace {

/// One run: the function Φ, and the state of the iteration.
class Run {
public:
    Run(const cloth::ClothModel& model, const Eliminated& eliminated, std::span<const double> mass, BlockSolver& solver,
        const MinimiserSettings& settings, const MinimiserProblem& problem)
        : model_(model), eliminated_(eliminated), mass_(mass), solver_(solver), settings_(settings),
          gravity_(problem.gravity), stages_(problem.stages), inertia_(problem.inertia), target_(problem.target),
          sharesFactors_(inertia_ == 0 && mass.size() >= fewParticles),
          levenberg_(inertia_ > 0 ? inertia_ : firstInertia), shift_(inertia_ > 0 ? 0 : firstInertia),
          exact_(sharesFactors_ ? static_cast<int>(mass.size()) : 0) {}

    Result<MinimiserReport> minimise(std::span<Vec3> x, std::stop_token stop, const Progress& progress);
    Result<void> iterateOnce(std::span<Vec3> x);
    [[nodiscard]] double energyAt(std::span<const Vec3> x) const;

private:
    struct Measured {
        double energy = 0;
        std::vector<Vec3> forces; ///< of the unknowns
        double largest = 0;       ///< force [N]
        int worst = -1;           ///< particle
    };

    [[nodiscard]] Measured measuredAt(std::span<const Vec3> x) const;
    [[nodiscard]] double forceScale() const;
    [[nodiscard]] double roundingFloor(std::span<const Vec3> x) const;
    void assemble(std::span<const Vec3> x, cloth::HessianForm form, BlockMatrix& into);
    using Solution = std::optional<std::vector<Vec3>>; ///< absent: not positive definite
    [[nodiscard]] Solution solved(std::span<const Vec3> forces, double tolerance);
    [[nodiscard]] std::optional<TrustedStep> stepAt(std::span<const Vec3> x, const Measured& now, double tolerance,
                                                    MinimiserIteration& log);
    [[nodiscard]] Solution shiftedAt(std::span<const Vec3> x, std::span<const Vec3> forces, double tolerance,
                                     MinimiserIteration& log);
    [[nodiscard]] std::optional<TrustedStep> trustedAt(std::span<const Vec3> x, std::span<const Vec3> forces,
                                                       MinimiserIteration& log);
    [[nodiscard]] bool factoredAt(std::span<const Vec3> x);
    [[nodiscard]] bool advance(std::span<Vec3> x, const Measured& now, const TrustedStep& step,
                               MinimiserIteration& log);
    void moveTo(std::span<Vec3> x, std::span<const Vec3> from, std::span<const Vec3> step, double fraction) const;
    void judgeLast(double energyNow);
    void adaptShift(double surprise, double gain);
    void adaptRadius(double surprise, double gain);
    void trustLess();

    const cloth::ClothModel& model_;
    const Eliminated& eliminated_;
    std::span<const double> mass_;
    BlockSolver& solver_;
    const MinimiserSettings& settings_;
    Vec3 gravity_;
    std::span<Stage* const> stages_;
    double inertia_;
    std::span<const Vec3> target_;
    bool sharesFactors_;                        ///< statics of many particles: trusted steps; else shifted ones
    double levenberg_;                          ///< scale of μ [1/s²]
    double shift_;                              ///< Levenberg weight μ [1/s²]: factors H + (c + μ)·M
    double radius_ = 0;                         ///< as far as a model is trusted, √(sᵀPs); 0 before the first step
    BlockMatrix exact_;                         ///< of trusted steps: H, whose projected form the solver's factor is of
    int served_ = factorServes, gradients_ = 0; ///< iterations of this factor, conjugate gradients of the last
    struct {
        bool taken = false;
        double energy = 0, gain = 0, expected = 0; ///< Φ after the last step, its fall, and that of the model
        double norm = 0;                           ///< √(sᵀPs)
        bool bounded = false;                      ///< by the radius
        int cuts = 0;
    } last_;
    int projectedLeft_ = 0; ///< iterations for which the exact Hessian is not tried again
    int projectedRun_ = 0;
    std::vector<double> climbed_{0}; ///< sums of the changes of Φ up to the last iterations, each step by its
                                     ///< own Φ: stages change their part of it in between
};

double Run::energyAt(std::span<const Vec3> x) const {
    double energy = cloth::energy(model_, x);
    for (std::size_t u = 0; u < mass_.size(); ++u) {
        const int p = eliminated_.free()[u];
        energy -= mass_[u] * dot(gravity_, x[p]);
        if (inertia_ > 0) energy += 0.5 * inertia_ * mass_[u] * squaredLength(x[p] - target_[p]);
    }
    for (const Stage* stage : stages_) energy += stage->energy(x);
    return energy;
}

Run::Measured Run::measuredAt(std::span<const Vec3> x) const {
    std::vector<Vec3> perParticle(x.size());
    cloth::addForces(model_, x, perParticle);
    for (const Stage* stage : stages_) stage->addForces(x, perParticle);
    Measured m{energyAt(x), eliminated_.gathered(perParticle), 0, -1};
    for (std::size_t u = 0; u < mass_.size(); ++u) {
        const int p = eliminated_.free()[u];
        m.forces[u] += mass_[u] * gravity_;
        if (inertia_ > 0) m.forces[u] -= (inertia_ * mass_[u]) * (x[p] - target_[p]);
        const double size = length(m.forces[u]);
        if (size > m.largest || m.worst < 0) {
            m.largest = size;
            m.worst = p;
        }
    }
    return m;
}

/// Mean particle weight [N].
double Run::forceScale() const {
    double total = 0;
    for (double m : mass_) total += m;
    const double g = length(gravity_);
    return total / std::max<std::size_t>(1, mass_.size()) * (g > 0 ? g : standardGravity);
}

double Run::roundingFloor(std::span<const Vec3> x) const {
    double extent = 0;
    for (const Vec3& p : x) extent = std::max({extent, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
    const double heaviest = mass_.empty() ? 0 : std::ranges::max(mass_);
    const double stiffness = cloth::largestStiffness(model_, x) + inertia_ * heaviest;
    return 8 * std::numeric_limits<double>::epsilon() * stiffness * extent / forceScale();
}

void Run::assemble(std::span<const Vec3> x, cloth::HessianForm form, BlockMatrix& into) {
    into.clear();
    EliminatingSink sink(eliminated_, into);
    cloth::addHessian(model_, x, form, sink);
    for (const Stage* stage : stages_) stage->addHessian(x, sink);
}

Run::Solution Run::solved(std::span<const Vec3> forces, double tolerance) {
    std::vector<double> shift(mass_.size());
    for (std::size_t u = 0; u < shift.size(); ++u) shift[u] = (inertia_ + shift_) * mass_[u];
    return solver_.solve(shift, forces, tolerance);
}

/// Absent: nothing holds the cloth.
std::optional<TrustedStep> Run::stepAt(std::span<const Vec3> x, const Measured& now, double tolerance,
                                       MinimiserIteration& log) {
    if (sharesFactors_) return trustedAt(x, now.forces, log);
    auto move = shiftedAt(x, now.forces, tolerance, log);
    if (!move) return std::nullopt;
    double momentum = 0;
    for (std::size_t u = 0; u < move->size(); ++u) momentum += mass_[u] * squaredLength((*move)[u]);
    const double slope = dotOf(now.forces, *move);
    return TrustedStep{.move = std::move(*move), .expected = 0.5 * (slope + shift_ * momentum)};
}

/// By the exact Hessian where it, or in statics a small shift of it, is positive definite, else by the projected one.
/// After failures in a row the exact one rests for a while: trying costs a solution.
Run::Solution Run::shiftedAt(std::span<const Vec3> x, std::span<const Vec3> forces, double tolerance,
                             MinimiserIteration& log) {
    if (projectedLeft_ == 0) {
        const double before = shift_;
        assemble(x, cloth::HessianForm::exact, solver_.matrix());
        for (;;) {
            if (Solution step = solved(forces, tolerance)) {
                projectedRun_ = 0;
                return step;
            }
            if (shift_ >= levenberg_ || inertia_ > 0) break;
            shift_ = std::max(10 * shift_, leastShift * levenberg_);
        }
        shift_ = before;
        projectedRun_ = std::min(projectedRun_ + 1, 3);
        projectedLeft_ = (1 << projectedRun_) - 1;
    } else {
        --projectedLeft_;
    }
    log.indefinite = true;
    assemble(x, cloth::HessianForm::projected, solver_.matrix());
    for (int attempt = 0; attempt < 12; ++attempt) {
        if (Solution step = solved(forces, tolerance)) return step;
        shift_ = std::max(10 * shift_, 10 * leastShift * levenberg_);
    }
    return std::nullopt;
}

/// Of many particles' statics: by the exact Hessian as far as it is trusted. It is only multiplied by; what is factored
/// is the projected one, seldom.
std::optional<TrustedStep> Run::trustedAt(std::span<const Vec3> x, std::span<const Vec3> forces,
                                          MinimiserIteration& log) {
    if (served_ >= factorServes || gradients_ > manyGradients)
        if (!factoredAt(x)) return std::nullopt;
    ++served_;
    assemble(x, cloth::HessianForm::exact, exact_);
    exact_.settlePattern();
    TrustedStep step = trustedStep(exact_, solver_.matrix(), forces, radius_,
                                   {.leastForce = 0.5 * settings_.tolerance * forceScale()});
    if (radius_ == 0) radius_ = step.norm;
    gradients_ = step.iterations;
    log.gradientIterations = step.iterations;
    log.indefinite = step.downwards;
    return step;
}

bool Run::factoredAt(std::span<const Vec3> x) {
    assemble(x, cloth::HessianForm::projected, solver_.matrix());
    std::vector<double> shift(mass_.size());
    double inertia = leastInertia;
    for (int attempt = 0; attempt < 12; ++attempt, inertia *= 10) {
        for (std::size_t u = 0; u < shift.size(); ++u) shift[u] = inertia * mass_[u];
        if (!solver_.matrix().factorize(shift)) continue;
        served_ = 0;
        return true;
    }
    return false;
}

void Run::moveTo(std::span<Vec3> x, std::span<const Vec3> from, std::span<const Vec3> step, double fraction) const {
    for (std::size_t u = 0; u < step.size(); ++u) {
        const int p = eliminated_.free()[u];
        x[p] = from[p] + fraction * step[u];
    }
    eliminated_.place(x);
}

/// Judges the last step by what it truly brought: stages that look again, at contact planes and friction, may
/// find more energy than the step was promised. Then steps are to be shorter, else longer.
void Run::judgeLast(double energyNow) {
    if (!last_.taken) return;
    last_.taken = false;
    const double surprise = energyNow - last_.energy, gain = (last_.gain - surprise) / last_.expected;
    if (sharesFactors_) adaptRadius(surprise, gain);
    else adaptShift(surprise, gain);
}

void Run::adaptShift(double surprise, double gain) {
    const double least = leastShift * levenberg_;
    if (surprise > 2 * last_.expected) shift_ = std::max(16 * shift_, least);
    else if (gain < 0.25 || last_.cuts > 1) shift_ = std::max(4 * shift_, least);
    else if (gain > 0.75 && last_.cuts == 0) shift_ = shift_ > 1e-2 * least ? shift_ / 8 : 0;
}

void Run::adaptRadius(double surprise, double gain) {
    if (surprise > 2 * last_.expected) radius_ = 0.1 * last_.norm;
    else if (gain < 0.25) radius_ = 0.4 * last_.norm;
    else if (last_.cuts > 0) radius_ = last_.norm;
    else if (gain > 0.75 && last_.bounded) radius_ = 2.5 * last_.norm;
}

/// No point on the last step was better.
void Run::trustLess() {
    shift_ = std::max(16 * shift_, 10 * leastShift * levenberg_);
    radius_ *= 1e-2;
    served_ = factorServes;
}

/// Armijo line search along the step, against the worst Φ of the last iterations: stiff cloth turns on curved
/// valleys, where a step that must always descend stays short. False if no point on the step is better. Ref:
/// Grippo, Lampariello, Lucidi 1986
bool Run::advance(std::span<Vec3> x, const Measured& now, const TrustedStep& step, MinimiserIteration& log) {
    double largest = 0;
    for (const Vec3& s : step.move) largest = std::max(largest, length(s));
    const double slope = -dotOf(now.forces, step.move); // of Φ along the step
    if (!(slope < 0) || !std::isfinite(largest)) return false;
    const double curvature = 2 * (-slope - step.expected); // of the model
    const std::vector<Vec3> from(x.begin(), x.end());
    const double slack = std::ranges::max(climbed_) - climbed_.back();
    const bool bounded = inertia_ == 0 || !stages_.empty();
    double fraction = bounded && largest > settings_.maximumMove ? settings_.maximumMove / largest : 1;
    // Close to the end the gain is below what rounding leaves of Φ: there the force decides.
    const double rounding = 1e-14 * (std::abs(now.energy) + forceScale() * static_cast<double>(x.size()));
    for (int cut = 0; cut < 25; ++cut, fraction /= 2) {
        moveTo(x, from, step.move, fraction);
        const double energy = energyAt(x), gain = now.energy - energy;
        const bool better = gain + slack >= -1e-4 * fraction * slope;
        const bool equal = std::isfinite(energy) && std::abs(gain) <= rounding && measuredAt(x).largest < now.largest;
        if (!better && !equal) continue;
        climbed_.push_back(climbed_.back() - gain);
        if (static_cast<int>(climbed_.size()) > settings_.memory) climbed_.erase(climbed_.begin());
        log.cuts = cut;
        log.largestMove = fraction * largest;
        const double expected = fraction * -slope - 0.5 * fraction * fraction * curvature;
        last_ = {true, energy, equal ? expected : gain, expected, fraction * step.norm, step.bounded, cut};
        return true;
    }
    std::ranges::copy(from, x.begin());
    return false;
}

Result<MinimiserReport> Run::minimise(std::span<Vec3> x, std::stop_token stop, const Progress& progress) {
    MinimiserReport out;
    const double scale = forceScale();
    out.residualFloor = roundingFloor(x);
    const double goal = std::max(settings_.tolerance, out.residualFloor);
    std::vector<Vec3> best;
    double bestResidual = std::numeric_limits<double>::infinity(), firstResidual = 0;
    double lastResidual = 0;
    int failures = 0;
    for (Stage* stage : stages_) stage->fixFriction(x);
    bool fresh = true;        // friction rests on the forces of here
    double freshResidual = 0; // where it last did
    for (;; ++out.iterations) {
        if (stop.stop_requested())
            return fail(ErrorCode::cancelled,
                        inertia_ > 0 ? "The step was stopped." : "The static solution was stopped.");
        for (Stage* stage : stages_) stage->beginIteration(x);
        Measured now = measuredAt(x);
        judgeLast(now.energy);
        if (!fresh && now.largest / scale <= std::max(goal, frictionEvery * freshResidual)) {
            for (Stage* stage : stages_) stage->fixFriction(x);
            now = measuredAt(x);
            fresh = true;
        }
        if (!allFinite(now.forces) || !std::isfinite(now.energy))
            return fail(ErrorCode::notConverged, fmt::format("The force on particle {} is no number in iteration {}.",
                                                             now.worst, out.iterations));
        const double residual = now.largest / scale;
        if (fresh) freshResidual = residual;
        if (residual < bestResidual) {
            bestResidual = residual;
            best.assign(x.begin(), x.end());
            out.worstParticle = now.worst;
        }
        if (fresh && residual <= goal) break;
        if (out.iterations == settings_.maximumIterations || failures > 10) break;
        if (out.iterations == 0) firstResidual = residual;
        if (inertia_ == 0)
            report(progress,
                   std::clamp(std::log(firstResidual / bestResidual) / std::log(firstResidual / goal), 0.0, 1.0),
                   "Finding the equilibrium");
        MinimiserIteration log{.energy = now.energy, .residual = residual};
        // Conjugate gradients need not know the step better than the step knows the minimum.
        const double forcing = std::clamp(residual * residual / (lastResidual * lastResidual), 1e-4, 0.03);
        const double tolerance = std::max(forcing * now.largest, 0.1 * goal * scale);
        lastResidual = residual;
        const std::optional<TrustedStep> step = stepAt(x, now, tolerance, log);
        if (!step) return fail(ErrorCode::notConverged, "The stiffness matrix is singular: nothing holds the cloth.");
        out.gradientIterations += log.gradientIterations;
        if (advance(x, now, *step, log)) {
            failures = 0;
            fresh = false;
        } else {
            ++failures;
            trustLess();
        }
        out.log.push_back(log);
    }
    if (!best.empty()) std::ranges::copy(best, x.begin());
    out.residual = bestResidual;
    out.converged = bestResidual <= goal;
    return out;
}

Result<void> Run::iterateOnce(std::span<Vec3> x) {
    for (Stage* stage : stages_) stage->fixFriction(x);
    for (Stage* stage : stages_) stage->beginIteration(x);
    const Measured now = measuredAt(x);
    if (!allFinite(now.forces))
        return fail(ErrorCode::notConverged, fmt::format("The force on particle {} is no number.", now.worst));
    assemble(x, cloth::HessianForm::projected, solver_.matrix());
    const Solution step = solved(now.forces, std::min(1e-6 * now.largest, settings_.tolerance * forceScale()));
    if (!step) return fail(ErrorCode::notConverged, "The stiffness matrix is singular: nothing holds the cloth.");
    moveTo(x, std::vector<Vec3>(x.begin(), x.end()), *step, 1);
    return {};
}

} // namespace

Result<MinimiserReport> Minimiser::minimise(std::span<Vec3> positions, const MinimiserProblem& problem,
                                            std::stop_token stop, const Progress& progress) {
    Data& d = *data_;
    if (auto ready = d.begin(positions, problem); !ready) return tl::unexpected(ready.error());
    if (d.eliminated.count() == 0) return MinimiserReport{.converged = true};
    Run run(d.model, d.eliminated, d.mass, d.solver, d.settings, problem);
    auto report = run.minimise(positions, stop, progress);
    if (!report) return report;
    d.count(*report);
    return report;
}

Result<MinimiserReport> Minimiser::iterateOnce(std::span<Vec3> positions, const MinimiserProblem& problem) {
    Data& d = *data_;
    if (auto ready = d.begin(positions, problem); !ready) return tl::unexpected(ready.error());
    if (d.eliminated.count() == 0) return MinimiserReport{};
    Run run(d.model, d.eliminated, d.mass, d.solver, d.settings, problem);
    if (auto moved = run.iterateOnce(positions); !moved) return tl::unexpected(moved.error());
    MinimiserReport report{.iterations = 1};
    d.count(report);
    return report;
}

void Minimiser::takeBetter(std::span<Vec3> positions, std::span<const Vec3> others,
                           const MinimiserProblem& problem) const {
    const Data& d = *data_;
    std::vector<Vec3> tried(positions.begin(), positions.end());
    for (const int p : d.eliminated.free()) tried[p] = others[p];
    d.eliminated.place(tried);
    d.eliminated.place(positions);
    BlockSolver none(0, 0);
    const Run run(d.model, d.eliminated, d.mass, none, d.settings, problem);
    if (run.energyAt(tried) < run.energyAt(positions)) std::ranges::copy(tried, positions.begin());
}

std::vector<Vec3> Minimiser::resisted(std::span<const Vec3> change, double inertia) {
    Data& d = *data_;
    std::vector<Vec3> result(change.begin(), change.end());
    if (!d.solver.matrix().pattern().empty()) {
        std::vector<double> shift;
        std::vector<Vec3> right;
        for (const int p : d.eliminated.free()) {
            shift.push_back(inertia * d.model.mass[p]);
            right.push_back(shift.back() * change[p]);
        }
        double largest = 0;
        for (const Vec3& r : right) largest = std::max(largest, length(r));
        if (const auto x = d.solver.solve(shift, right, 0.05 * largest))
            for (int u = 0; u < d.eliminated.count(); ++u) result[d.eliminated.free()[u]] = (*x)[u];
    }
    d.eliminated.place(result);
    for (const int p : d.model.pinned) result[p] = {};
    return result;
}

} // namespace toile::dynamics
