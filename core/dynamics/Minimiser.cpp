// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/dynamics/Minimiser.h"

#include "core/base/Contracts.h"
#include "core/cloth/Forces.h"
#include "core/dynamics/BlockSolver.h"
#include "core/dynamics/Eliminated.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace toile::dynamics {
namespace {

constexpr double standardGravity = 9.81; ///< [m/s²]; scale of residuals where there is no gravity

/// Friction is fixed anew when the residual has fallen to this part of what it was then [–].
constexpr double frictionEvery = 0.1;

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

double dotOf(std::span<const Vec3> a, std::span<const Vec3> b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += dot(a[i], b[i]);
    return sum;
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
        report.gradientIterations = solver.gradientIterations() - gradientIterations;
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
          levenberg_(inertia_ > 0 ? inertia_ : settings.initialInertia),
          shift_(inertia_ > 0 ? 0 : settings.initialInertia) {}

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
    void assemble(std::span<const Vec3> x, cloth::HessianForm form);
    using Step = std::optional<std::vector<Vec3>>; ///< absent: not positive definite
    [[nodiscard]] Step stepAt(std::span<const Vec3> x, std::span<const Vec3> forces, double tolerance,
                              MinimiserIteration& log);
    [[nodiscard]] Step solved(std::span<const Vec3> forces, double tolerance);
    [[nodiscard]] bool advance(std::span<Vec3> x, const Measured& now, std::vector<Vec3> step, MinimiserIteration& log);
    void moveTo(std::span<Vec3> x, std::span<const Vec3> from, std::span<const Vec3> step, double fraction) const;
    void adaptShift(double energyNow);

    const cloth::ClothModel& model_;
    const Eliminated& eliminated_;
    std::span<const double> mass_;
    BlockSolver& solver_;
    const MinimiserSettings& settings_;
    Vec3 gravity_;
    std::span<Stage* const> stages_;
    double inertia_;
    std::span<const Vec3> target_;
    double levenberg_; ///< scale of μ [1/s²]
    double shift_;     ///< Levenberg weight μ [1/s²]: factors H + (c + μ)·M
    struct {
        bool taken = false;
        double energy = 0, gain = 0, expected = 0; ///< Φ after the last step, its fall, and that of the model
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

void Run::assemble(std::span<const Vec3> x, cloth::HessianForm form) {
    solver_.matrix().clear();
    EliminatingSink sink(eliminated_, solver_.matrix());
    cloth::addHessian(model_, x, form, sink);
    for (const Stage* stage : stages_) stage->addHessian(x, sink);
}

Run::Step Run::solved(std::span<const Vec3> forces, double tolerance) {
    std::vector<double> shift(mass_.size());
    for (std::size_t u = 0; u < shift.size(); ++u) shift[u] = (inertia_ + shift_) * mass_[u];
    return solver_.solve(shift, forces, tolerance);
}

/// The exact Hessian where it, or in statics a small shift of it, is positive definite, else the projected
/// one. Near a shallow saddle the first strides along the soft direction where the second would crawl; in
/// compressed cloth it is the other way round. After failures in a row the exact one rests for a while:
/// trying costs factorisations.
Run::Step Run::stepAt(std::span<const Vec3> x, std::span<const Vec3> forces, double tolerance,
                      MinimiserIteration& log) {
    const double leastShift = 1e-4 * levenberg_;
    if (projectedLeft_ == 0) {
        const double before = shift_;
        assemble(x, cloth::HessianForm::exact);
        for (;;) {
            if (Step step = solved(forces, tolerance)) {
                projectedRun_ = 0;
                return step;
            }
            if (shift_ >= levenberg_ || inertia_ > 0) break;
            shift_ = std::max(10 * shift_, leastShift);
        }
        shift_ = before;
        projectedRun_ = std::min(projectedRun_ + 1, 3);
        projectedLeft_ = (1 << projectedRun_) - 1;
    } else {
        --projectedLeft_;
    }
    log.projected = true;
    assemble(x, cloth::HessianForm::projected);
    for (int attempt = 0; attempt < 12; ++attempt) {
        if (Step step = solved(forces, tolerance)) return step;
        shift_ = std::max(10 * shift_, 10 * leastShift);
    }
    return std::nullopt;
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
void Run::adaptShift(double energyNow) {
    if (!last_.taken) return;
    last_.taken = false;
    const double surprise = energyNow - last_.energy, gain = (last_.gain - surprise) / last_.expected;
    const double least = 1e-4 * levenberg_;
    if (surprise > 2 * last_.expected) shift_ = std::max(16 * shift_, least);
    else if (gain < 0.25 || last_.cuts > 1) shift_ = std::max(4 * shift_, least);
    else if (gain > 0.75 && last_.cuts == 0) shift_ = shift_ > 1e-2 * least ? shift_ / 8 : 0;
}

/// Armijo line search along the step, against the worst Φ of the last iterations: stiff cloth turns on curved
/// valleys, where a step that must always descend stays short. False if no point on the step is better. Ref:
/// Grippo, Lampariello, Lucidi 1986
bool Run::advance(std::span<Vec3> x, const Measured& now, std::vector<Vec3> step, MinimiserIteration& log) {
    double largest = 0;
    for (const Vec3& s : step) largest = std::max(largest, length(s));
    const double slope = -dotOf(now.forces, step); // of Φ along the step
    if (!(slope < 0)) return false;
    double momentum = 0;
    for (std::size_t u = 0; u < step.size(); ++u) momentum += mass_[u] * squaredLength(step[u]);
    const double curvature = -slope - shift_ * momentum; // pᵀ(H + cM)p
    const std::vector<Vec3> from(x.begin(), x.end());
    const double slack = std::ranges::max(climbed_) - climbed_.back();
    const bool bounded = inertia_ == 0 || !stages_.empty();
    double fraction = bounded && largest > settings_.maximumMove ? settings_.maximumMove / largest : 1;
    // Close to the end the gain is below what rounding leaves of Φ: there the force decides.
    const double rounding = 1e-14 * (std::abs(now.energy) + forceScale() * static_cast<double>(x.size()));
    for (int cut = 0; cut < 25; ++cut, fraction /= 2) {
        moveTo(x, from, step, fraction);
        const double energy = energyAt(x), gain = now.energy - energy;
        const bool better = gain + slack >= -1e-4 * fraction * slope;
        const bool equal = std::isfinite(energy) && std::abs(gain) <= rounding && measuredAt(x).largest < now.largest;
        if (!better && !equal) continue;
        climbed_.push_back(climbed_.back() - gain);
        if (static_cast<int>(climbed_.size()) > settings_.memory) climbed_.erase(climbed_.begin());
        log.cuts = cut;
        log.largestMove = fraction * largest;
        const double expected = fraction * -slope - 0.5 * fraction * fraction * curvature;
        last_ = {true, energy, equal ? expected : gain, expected, cut};
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
        adaptShift(now.energy);
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
        Step step = stepAt(x, now.forces, tolerance, log);
        if (!step) return fail(ErrorCode::notConverged, "The stiffness matrix is singular: nothing holds the cloth.");
        log.inertia = inertia_ + shift_;
        if (allFinite(*step) && advance(x, now, std::move(*step), log)) {
            failures = 0;
            fresh = false;
        } else {
            ++failures;
            shift_ = std::max(16 * shift_, 1e-3 * levenberg_);
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
    assemble(x, cloth::HessianForm::projected);
    const Step step = solved(now.forces, std::min(1e-6 * now.largest, settings_.tolerance * forceScale()));
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
