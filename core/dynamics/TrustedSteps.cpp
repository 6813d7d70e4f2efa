// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/dynamics/NewtonSteps.h"

namespace toile::dynamics {
namespace {

/// A factor serves so many iterations at most …
constexpr int factorServes = 20;
/// … and none after one that took more conjugate gradients than this.
constexpr int manyGradients = 12;
/// What is factored is the projected Hessian and so much inertia [1/s²]: soft directions keep a length.
constexpr double leastInertia = 0.01;

/// Fewer free particles have a factor for every iteration, shifted by inertia: it is cheap there, and where soft
/// directions turn, as of a strap that swings or of a chain of stiff links, an old one leads across them.
constexpr std::size_t fewParticles = 1000;

} // namespace

std::unique_ptr<NewtonSteps> stepsFor(const Potential& potential, BlockSolver& solver, double tolerance,
                                      std::stop_token stop) {
    if (potential.inertia() > 0 || potential.mass().size() < fewParticles)
        return std::make_unique<ShiftedSteps>(potential, solver, std::move(stop));
    return std::make_unique<TrustedSteps>(potential, solver, 0.5 * tolerance * potential.forceScale(), std::move(stop));
}

TrustedSteps::TrustedSteps(const Potential& potential, BlockSolver& solver, double leastForce, std::stop_token stop)
    : potential_(potential), solver_(solver), leastForce_(leastForce), stop_(std::move(stop)),
      exact_(static_cast<int>(potential.mass().size())) {}

std::optional<TrustedStep> TrustedSteps::stepAt(std::span<const Vec3> x, std::span<const Vec3> forces, double tolerance,
                                                MinimiserIteration& log) {
    if (without_) return without_->stepAt(x, forces, tolerance, log);
    if (!factored_ || served_ >= factorServes || gradients_ > manyGradients)
        if (!factoredAt(x)) {
            if (solver_.refused() == 0) return std::nullopt;
            without_.emplace(potential_, solver_, stop_);
            return without_->stepAt(x, forces, tolerance, log);
        }
    ++served_;
    potential_.assemble(x, cloth::HessianForm::exact, exact_);
    exact_.settlePattern();
    TrustedStep step = trustedStep(exact_, preconditioner_, forces, radius_, {.leastForce = leastForce_, .stop = stop_},
                                   potential_.team());
    if (radius_ == 0) radius_ = step.norm;
    gradients_ = step.iterations;
    log.gradientIterations = step.iterations;
    log.indefinite = step.downwards;
    return step;
}

bool TrustedSteps::factoredAt(std::span<const Vec3> x) {
    potential_.assemble(x, cloth::HessianForm::projected, solver_.matrix());
    std::vector<double> shift(potential_.mass().size());
    double inertia = leastInertia;
    for (int attempt = 0; attempt < 12 && !stop_.stop_requested(); ++attempt, inertia *= 10) {
        for (std::size_t u = 0; u < shift.size(); ++u) shift[u] = inertia * potential_.mass()[u];
        if (!solver_.matrix().factorize(shift)) {
            if (solver_.refused() > 0) return false;
            continue;
        }
        preconditioner_.take(solver_.matrix().factor());
        served_ = 0;
        factored_ = true;
        return true;
    }
    return false;
}

void TrustedSteps::judge(const TakenStep& last, double surprise, double gain) {
    if (without_) return without_->judge(last, surprise, gain);
    if (surprise > 2 * last.expected) radius_ = 0.1 * last.norm;
    else if (gain < 0.25) radius_ = 0.4 * last.norm;
    else if (last.cuts > 0) radius_ = last.norm;
    else if (gain > 0.75 && last.bounded) radius_ = 2.5 * last.norm;
}

void TrustedSteps::trustLess() {
    if (without_) return without_->trustLess();
    radius_ *= 1e-2;
    factored_ = false;
}

} // namespace toile::dynamics
