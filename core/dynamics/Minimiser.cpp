// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/dynamics/Minimiser.h"

#include "core/base/Contracts.h"
#include "core/dynamics/BlockVectors.h"
#include "core/dynamics/NewtonSteps.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace toile::dynamics {
namespace {

constexpr const char* nothingHolds = "The stiffness matrix is singular: nothing holds the cloth.";

/// Why there is no step.
tl::unexpected<Error> stepless(const BlockSolver& solver) {
    if (solver.refused() == 0) return fail(ErrorCode::notConverged, nothingHolds);
    return fail(ErrorCode::tooLarge,
                fmt::format("The factor of the linear system would take {:.3g} MB, which is more than can be had, and "
                            "conjugate gradients do not solve it without: choose a larger spacing, or allow more "
                            "memory.",
                            1e-6 * static_cast<double>(solver.refused())));
}

/// Friction is fixed anew when the residual has fallen to this part of what it was then [–].
constexpr double frictionEvery = 0.1;
/// Where that leaves more than this part of the force of the time before, the two do not come nearer to each other, as
/// where cloth slides to and fro; from then on friction goes half as far, and this far at least [–].
constexpr double hardlyNearer = 0.7, leastEase = 0.1;

bool allFinite(std::span<const Vec3> values) {
    return std::ranges::all_of(values, [](const Vec3& v) { return isFinite(v); });
}

/// One run: Φ, how it comes to its steps, and the state of the iteration.
class Run {
public:
    Run(const Potential& potential, BlockSolver& solver, const MinimiserSettings& settings, std::stop_token stop)
        : potential_(potential), solver_(solver), settings_(settings), stop_(stop),
          steps_(stepsFor(potential, solver, settings.tolerance, std::move(stop))) {}

    Result<MinimiserReport> minimise(std::span<Vec3> x, const Progress& progress);

private:
    [[nodiscard]] tl::unexpected<Error> stopped() const {
        return fail(ErrorCode::cancelled,
                    potential_.inertia() > 0 ? "The step was stopped." : "The static solution was stopped.");
    }
    [[nodiscard]] bool advance(std::span<Vec3> x, const Potential::Measured& now, const TrustedStep& step,
                               MinimiserIteration& log);
    void judgeLast(double energyNow);
    [[nodiscard]] Potential::Measured measuredWithFrictionAnew(std::span<const Vec3> x, double enough);

    const Potential& potential_;
    const BlockSolver& solver_;
    const MinimiserSettings& settings_;
    std::stop_token stop_;
    std::unique_ptr<NewtonSteps> steps_;
    std::optional<TakenStep> last_;  ///< not judged yet
    std::vector<double> climbed_{0}; ///< sums of the changes of Φ up to the last iterations, each step by its
                                     ///< own Φ: stages change their part of it in between
    double ease_ = 1;                ///< how far friction goes from what it was to what it rests on [–]
    bool fresh_ = true;              ///< it rests on the forces of here
    double unbalanced_ = std::numeric_limits<double>::infinity(); ///< largest force when it was fixed last [N]
};

/// Judges the last step by what it truly brought: stages that look again, at contact planes and friction, may
/// find more energy than the step was promised.
void Run::judgeLast(double energyNow) {
    if (!last_) return;
    const double surprise = energyNow - last_->energy;
    steps_->judge(*last_, surprise, (last_->gain - surprise) / last_->expected);
    last_.reset();
}

/// With friction of here, or a part of the way to it where the forces are more than enough.
Potential::Measured Run::measuredWithFrictionAnew(std::span<const Vec3> x, double enough) {
    for (Stage* stage : potential_.stages()) stage->fixFriction(x);
    const Potential::Measured now = potential_.measuredAt(x);
    if (now.largest > enough && now.largest > hardlyNearer * unbalanced_) ease_ = std::max(0.5 * ease_, leastEase);
    unbalanced_ = now.largest;
    fresh_ = now.largest <= enough || ease_ == 1;
    if (fresh_) return now;
    for (Stage* stage : potential_.stages()) stage->easeFriction(ease_);
    return potential_.measuredAt(x);
}

/// Armijo line search along the step, against the worst Φ of the last iterations: stiff cloth turns on curved
/// valleys, where a step that must always descend stays short. False if no point on the step is better. Ref:
/// Grippo, Lampariello, Lucidi 1986
bool Run::advance(std::span<Vec3> x, const Potential::Measured& now, const TrustedStep& step, MinimiserIteration& log) {
    double largest = 0;
    for (const Vec3& s : step.move) largest = std::max(largest, length(s));
    const double slope = -dotOf(now.forces, step.move); // of Φ along the step
    if (!(slope < 0) || !std::isfinite(largest)) return false;
    const double curvature = 2 * (-slope - step.expected); // of the model
    const std::vector<Vec3> from(x.begin(), x.end());
    const double slack = std::ranges::max(climbed_) - climbed_.back();
    const bool bounded = potential_.inertia() == 0 || !potential_.stages().empty();
    double fraction = bounded && largest > settings_.maximumMove ? settings_.maximumMove / largest : 1;
    // Close to the end the gain is below what rounding leaves of Φ: there the force decides.
    const double rounding = 1e-14 * (std::abs(now.energy) + potential_.forceScale() * static_cast<double>(x.size()));
    for (int cut = 0; cut < 25 && !stop_.stop_requested(); ++cut, fraction /= 2) {
        potential_.moveTo(x, from, step.move, fraction);
        const double energy = potential_.energyAt(x), gain = now.energy - energy;
        const bool better = gain + slack >= -1e-4 * fraction * slope;
        const bool equal =
            std::isfinite(energy) && std::abs(gain) <= rounding && potential_.measuredAt(x).largest < now.largest;
        if (!better && !equal) continue;
        climbed_.push_back(climbed_.back() - gain);
        if (static_cast<int>(climbed_.size()) > settings_.memory) climbed_.erase(climbed_.begin());
        log.cuts = cut;
        log.largestMove = fraction * largest;
        const double expected = fraction * -slope - 0.5 * fraction * fraction * curvature;
        last_ = TakenStep{energy, equal ? expected : gain, expected, fraction * step.norm, step.bounded, cut};
        return true;
    }
    std::ranges::copy(from, x.begin());
    return false;
}

Result<MinimiserReport> Run::minimise(std::span<Vec3> x, const Progress& progress) {
    MinimiserReport out;
    const double scale = potential_.forceScale();
    out.residualFloor = potential_.roundingFloor(x);
    const double goal = std::max(settings_.tolerance, out.residualFloor);
    std::vector<Vec3> best;
    double bestResidual = std::numeric_limits<double>::infinity(), firstResidual = 0;
    double lastResidual = 0;
    int failures = 0;
    for (Stage* stage : potential_.stages()) stage->fixFriction(x);
    double fixedResidual = 0; // when friction was fixed last
    for (bool fixed = true;; ++out.iterations, fixed = false) {
        for (Stage* stage : potential_.stages()) stage->beginIteration(x);
        Potential::Measured now = potential_.measuredAt(x);
        judgeLast(now.energy);
        if (!fresh_ && now.largest / scale <= std::max(goal, frictionEvery * fixedResidual)) {
            now = measuredWithFrictionAnew(x, goal * scale);
            fixed = true;
        }
        if (stop_.stop_requested()) return stopped();
        if (!allFinite(now.forces) || !std::isfinite(now.energy))
            return fail(ErrorCode::notConverged, fmt::format("The force on particle {} is no number in iteration {}.",
                                                             now.worst, out.iterations));
        const double residual = now.largest / scale;
        if (fixed) fixedResidual = residual;
        if (residual < bestResidual && (fresh_ || !fixed)) {
            bestResidual = residual;
            best.assign(x.begin(), x.end());
            out.worstParticle = now.worst;
        }
        if (fresh_ && residual <= goal) break;
        if (out.iterations == settings_.maximumIterations || failures > 10) break;
        if (out.iterations == 0) firstResidual = residual;
        if (potential_.inertia() == 0)
            report(progress,
                   std::clamp(std::log(firstResidual / bestResidual) / std::log(firstResidual / goal), 0.0, 1.0),
                   "Finding the equilibrium");
        MinimiserIteration log{.energy = now.energy, .residual = residual};
        // Conjugate gradients need not know the step better than the step knows the minimum.
        const double forcing = std::clamp(residual * residual / (lastResidual * lastResidual), 1e-4, 0.03);
        const double tolerance = std::max(forcing * now.largest, 0.1 * goal * scale);
        lastResidual = residual;
        const std::optional<TrustedStep> step = steps_->stepAt(x, now.forces, tolerance, log);
        if (stop_.stop_requested()) return stopped(); // the step is of no use
        if (!step) return stepless(solver_);
        out.gradientIterations += log.gradientIterations;
        if (advance(x, now, *step, log)) {
            failures = 0;
            fresh_ = false;
        } else {
            ++failures;
            steps_->trustLess();
        }
        out.log.push_back(log);
    }
    if (!best.empty()) std::ranges::copy(best, x.begin());
    out.residual = bestResidual;
    out.converged = bestResidual <= goal;
    return out;
}

} // namespace

struct Minimiser::Data {
    Data(const cloth::ClothModel& m, MinimiserSettings s)
        : model(m), settings(s), eliminated(m), solver(eliminated.count(), s.gradientIterations, s.factorBytes) {
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
        unsolved = solver.unsolved();
        return {};
    }
    void count(MinimiserReport& report) const {
        report.analyses = solver.analyses() - analyses;
        report.factorizations = solver.factorizations() - factorizations;
        report.gradientIterations += solver.gradientIterations() - gradientIterations;
        report.refusedFactor = solver.refused();
    }

    const cloth::ClothModel& model;
    MinimiserSettings settings;
    Eliminated eliminated;
    BlockSolver solver;
    std::vector<double> mass;                                                   ///< of the unknowns [kg]
    int analyses = 0, factorizations = 0, gradientIterations = 0, unsolved = 0; ///< of the solver before this run
};

Minimiser::Minimiser(const cloth::ClothModel& model, MinimiserSettings settings)
    : data_(std::make_unique<Data>(model, settings)) {}
Minimiser::Minimiser(Minimiser&&) noexcept = default;
Minimiser& Minimiser::operator=(Minimiser&&) noexcept = default;
Minimiser::~Minimiser() = default;

std::size_t Minimiser::bytes() const {
    return sizeof(Data) + data_->solver.bytes() + data_->mass.capacity() * sizeof(double);
}

Result<MinimiserReport> Minimiser::minimise(std::span<Vec3> positions, const MinimiserProblem& problem,
                                            std::stop_token stop, const Progress& progress) {
    Data& d = *data_;
    if (auto ready = d.begin(positions, problem); !ready) return tl::unexpected(ready.error());
    if (d.eliminated.count() == 0) return MinimiserReport{.converged = true};
    const Potential potential(d.model, d.eliminated, d.mass, problem);
    auto report = Run(potential, d.solver, d.settings, std::move(stop)).minimise(positions, progress);
    if (!report) return report;
    d.count(*report);
    return report;
}

Result<MinimiserReport> Minimiser::iterateOnce(std::span<Vec3> positions, const MinimiserProblem& problem) {
    Data& d = *data_;
    if (auto ready = d.begin(positions, problem); !ready) return tl::unexpected(ready.error());
    if (d.eliminated.count() == 0) return MinimiserReport{.converged = true};
    const Potential potential(d.model, d.eliminated, d.mass, problem);
    for (Stage* stage : problem.stages) stage->fixFriction(positions);
    for (Stage* stage : problem.stages) stage->beginIteration(positions);
    const Potential::Measured now = potential.measuredAt(positions);
    if (!allFinite(now.forces))
        return fail(ErrorCode::notConverged, fmt::format("The force on particle {} is no number.", now.worst));
    const double tolerance = std::min(1e-6 * now.largest, d.settings.tolerance * potential.forceScale());
    const auto step = ShiftedSteps(potential, d.solver).projectedAt(positions, now.forces, tolerance);
    if (!step) return stepless(d.solver);
    potential.moveTo(positions, std::vector<Vec3>(positions.begin(), positions.end()), *step, 1);
    MinimiserReport report{.converged = d.solver.unsolved() == d.unsolved, .iterations = 1};
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
    const Potential potential(d.model, d.eliminated, d.mass, problem);
    if (potential.energyAt(tried) < potential.energyAt(positions)) std::ranges::copy(tried, positions.begin());
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
