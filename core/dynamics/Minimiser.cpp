// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/dynamics/Minimiser.h"

#include "core/base/Contracts.h"
#include "core/cloth/Forces.h"
#include "core/dynamics/BlockCholesky.h"
#include "core/dynamics/Eliminated.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace toile::dynamics {
namespace {

constexpr double standardGravity = 9.81; ///< [m/s²]; scale of residuals where there is no gravity

/// Hands blocks of particles to the unknowns that move them.
class EliminatingSink : public HessianSink {
public:
    EliminatingSink(const Eliminated& eliminated, HessianSink& target) : eliminated_(eliminated), target_(target) {}

    void add(int i, int j, const double (&block)[9]) override {
        for (const auto& [row, rowWeight] : eliminated_.termsOf(i))
            for (const auto& [column, columnWeight] : eliminated_.termsOf(j)) {
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
        : model(m), settings(s), eliminated(m), matrix(eliminated.count()) {
        for (int particle : eliminated.free()) mass.push_back(m.mass[particle]);
    }

    const cloth::ClothModel& model;
    MinimiserSettings settings;
    Eliminated eliminated;
    BlockCholesky matrix;
    std::vector<double> mass; ///< of the unknowns [kg]
};

Minimiser::Minimiser(const cloth::ClothModel& model, MinimiserSettings settings)
    : data_(std::make_unique<Data>(model, settings)) {}
Minimiser::Minimiser(Minimiser&&) noexcept = default;
Minimiser& Minimiser::operator=(Minimiser&&) noexcept = default;
Minimiser::~Minimiser() = default;

std::size_t Minimiser::bytes() const {
    return sizeof(Data) + data_->matrix.bytes() + data_->mass.capacity() * sizeof(double);
}

namespace {

/// One run: the function Φ, and the state of the iteration.
class Run {
public:
    Run(const cloth::ClothModel& model, const Eliminated& eliminated, std::span<const double> mass,
        BlockCholesky& matrix, const MinimiserSettings& settings, const Vec3& gravity, std::span<Stage* const> stages,
        double inertia, std::span<const Vec3> target)
        : model_(model), eliminated_(eliminated), mass_(mass), matrix_(matrix), settings_(settings), gravity_(gravity),
          stages_(stages), inertia_(inertia), target_(target), shift_(inertia > 0 ? 0 : settings.initialInertia) {}

    Result<MinimiserReport> minimise(std::span<Vec3> x, std::stop_token stop, const Progress& progress);

private:
    struct Measured {
        double energy = 0;
        std::vector<Vec3> forces; ///< of the unknowns
        double largest = 0;       ///< force [N]
        int worst = -1;           ///< particle
    };

    [[nodiscard]] double energyAt(std::span<const Vec3> x) const;
    [[nodiscard]] Measured measuredAt(std::span<const Vec3> x) const;
    [[nodiscard]] double forceScale() const;
    [[nodiscard]] double roundingFloor(std::span<const Vec3> x) const;
    void assemble(std::span<const Vec3> x, cloth::HessianForm form);
    [[nodiscard]] bool factorAt(std::span<const Vec3> x, MinimiserIteration& log);
    [[nodiscard]] bool factorWithShift();
    [[nodiscard]] bool advance(std::span<Vec3> x, const Measured& now, std::vector<Vec3> step, MinimiserIteration& log);
    void moveTo(std::span<Vec3> x, std::span<const Vec3> from, std::span<const Vec3> step, double fraction) const;
    void adaptShift(double energyNow);

    const cloth::ClothModel& model_;
    const Eliminated& eliminated_;
    std::span<const double> mass_;
    BlockCholesky& matrix_;
    const MinimiserSettings& settings_;
    Vec3 gravity_;
    std::span<Stage* const> stages_;
    double inertia_;
    std::span<const Vec3> target_;
    double shift_;          ///< Levenberg weight μ [1/s²]: factors H + (c + μ)·M
    struct {
        bool taken = false;
        double energy = 0, gain = 0, expected = 0; ///< Φ after the last step, its fall, and that of the model
        int cuts = 0;
    } last_;
    int projectedLeft_ = 0; ///< iterations for which the exact Hessian is not tried again
    int projectedRun_ = 0;
    std::vector<double> climbed_{0}; ///< sums of the changes of Φ up to the last iterations, each step by its own Φ:
                                     ///< stages change their part of it in between
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
    return 8 * std::numeric_limits<double>::epsilon() * cloth::largestStiffness(model_, x) * extent / forceScale();
}

void Run::assemble(std::span<const Vec3> x, cloth::HessianForm form) {
    matrix_.clear();
    EliminatingSink sink(eliminated_, matrix_);
    cloth::addHessian(model_, x, form, sink);
    for (const Stage* stage : stages_) stage->addHessian(x, sink);
}

bool Run::factorWithShift() {
    std::vector<double> shift(mass_.size());
    for (std::size_t u = 0; u < shift.size(); ++u) shift[u] = (inertia_ + shift_) * mass_[u];
    return matrix_.factorize(shift);
}

/// The exact Hessian where a small shift makes it positive definite, else the projected one. Near a shallow saddle the
/// first strides along the soft direction where the second would crawl; in compressed cloth it is the other way
/// round. After failures in a row the exact one rests for a while: trying costs factorisations.
bool Run::factorAt(std::span<const Vec3> x, MinimiserIteration& log) {
    const double leastShift = 1e-4 * settings_.initialInertia;
    if (projectedLeft_ == 0) {
        const double before = shift_;
        assemble(x, cloth::HessianForm::exact);
        for (;;) {
            if (factorWithShift()) {
                projectedRun_ = 0;
                return true;
            }
            if (shift_ >= settings_.initialInertia) break;
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
        if (factorWithShift()) return true;
        shift_ = std::max(10 * shift_, 10 * leastShift);
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

/// Judges the last step by what it truly brought: stages that look again, at contact planes and friction, may find
/// more energy than the step was promised. Then steps are to be shorter, else longer.
void Run::adaptShift(double energyNow) {
    if (!last_.taken) return;
    last_.taken = false;
    const double surprise = energyNow - last_.energy, gain = (last_.gain - surprise) / last_.expected;
    const double least = 1e-4 * settings_.initialInertia;
    if (surprise > 2 * last_.expected)
        shift_ = std::max(16 * shift_, least);
    else if (gain < 0.25 || last_.cuts > 1)
        shift_ = std::max(4 * shift_, least);
    else if (gain > 0.75 && last_.cuts == 0)
        shift_ = shift_ > 1e-2 * least ? shift_ / 8 : 0;
}

/// Armijo line search along the step, against the worst Φ of the last iterations: stiff cloth turns on curved valleys,
/// where a step that must always descend stays short. False if no point on the step is better.
/// Ref: Grippo, Lampariello, Lucidi 1986
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
    double fraction = largest > settings_.maximumMove ? settings_.maximumMove / largest : 1;
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
    int failures = 0;
    for (;; ++out.iterations) {
        if (stop.stop_requested()) return fail(ErrorCode::cancelled, "The static solution was stopped.");
        for (Stage* stage : stages_) stage->beginIteration(x);
        const Measured now = measuredAt(x);
        if (!allFinite(now.forces) || !std::isfinite(now.energy))
            return fail(ErrorCode::notConverged,
                        fmt::format("The force on particle {} is no number in iteration {}.", now.worst, out.iterations));
        adaptShift(now.energy);
        const double residual = now.largest / scale;
        if (residual < bestResidual) {
            bestResidual = residual;
            best.assign(x.begin(), x.end());
            out.worstParticle = now.worst;
        }
        if (residual <= goal) break;
        if (out.iterations == settings_.maximumIterations || failures > 10) break;
        if (out.iterations == 0) firstResidual = residual;
        report(progress, std::clamp(std::log(firstResidual / residual) / std::log(firstResidual / goal), 0.0, 1.0),
               "Finding the equilibrium");
        MinimiserIteration log{.energy = now.energy, .residual = residual};
        if (!factorAt(x, log))
            return fail(ErrorCode::notConverged, "The stiffness matrix is singular: nothing holds the cloth.");
        log.inertia = inertia_ + shift_;
        std::vector<Vec3> step = matrix_.solve(now.forces);
        if (allFinite(step) && advance(x, now, std::move(step), log)) {
            failures = 0;
        } else {
            ++failures;
            shift_ = std::max(16 * shift_, 1e-3 * settings_.initialInertia);
        }
        out.log.push_back(log);
    }
    if (!best.empty()) std::ranges::copy(best, x.begin());
    out.residual = bestResidual;
    out.converged = bestResidual <= goal;
    return out;
}

} // namespace

Result<MinimiserReport> Minimiser::minimise(std::span<Vec3> positions, const Vec3& gravity,
                                            std::span<Stage* const> stages, double inertia,
                                            std::span<const Vec3> target, std::stop_token stop,
                                            const Progress& progress) {
    Data& d = *data_;
    expects(positions.size() == d.model.mass.size(), "one position per particle");
    expects(inertia == 0 || target.size() == positions.size(), "inertia needs a target");
    if (d.eliminated.massless() >= 0)
        return fail(ErrorCode::invalidInput, fmt::format("Particle {} has no mass.", d.eliminated.massless()));
    d.eliminated.place(positions);
    if (d.eliminated.count() == 0) return MinimiserReport{.converged = true};
    const int analyses = d.matrix.analyses(), factorizations = d.matrix.factorizations();
    Run run(d.model, d.eliminated, d.mass, d.matrix, d.settings, gravity, stages, inertia, target);
    auto report = run.minimise(positions, stop, progress);
    if (!report) return report;
    report->analyses = d.matrix.analyses() - analyses;
    report->factorizations = d.matrix.factorizations() - factorizations;
    return report;
}

} // namespace toile::dynamics
