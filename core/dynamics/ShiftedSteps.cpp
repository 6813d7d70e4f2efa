// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/dynamics/BlockVectors.h"
#include "core/dynamics/NewtonSteps.h"

#include <algorithm>

namespace toile::dynamics {
namespace {

/// The first Levenberg weight μ of ½μ|Δx|²_M in statics [1/s²]; it falls towards 0.
constexpr double firstInertia = 100;
/// The smallest that is tried before none, over the scale [–].
constexpr double leastShift = 1e-4;

} // namespace

ShiftedSteps::ShiftedSteps(const Potential& potential, BlockSolver& solver, std::stop_token stop)
    : potential_(potential), solver_(solver), stop_(std::move(stop)),
      levenberg_(potential.inertia() > 0 ? potential.inertia() : firstInertia),
      shift_(potential.inertia() > 0 ? 0 : firstInertia) {}

std::optional<TrustedStep> ShiftedSteps::stepAt(std::span<const Vec3> x, std::span<const Vec3> forces, double tolerance,
                                                MinimiserIteration& log) {
    auto move = moveAt(x, forces, tolerance, log);
    if (!move) return std::nullopt;
    double momentum = 0;
    for (std::size_t u = 0; u < move->size(); ++u) momentum += potential_.mass()[u] * squaredLength((*move)[u]);
    const double slope = dotOf(forces, *move);
    return TrustedStep{.move = std::move(*move), .expected = 0.5 * (slope + shift_ * momentum)};
}

/// After failures in a row the exact one rests for a while: trying costs a solution.
ShiftedSteps::Solution ShiftedSteps::moveAt(std::span<const Vec3> x, std::span<const Vec3> forces, double tolerance,
                                            MinimiserIteration& log) {
    if (projectedLeft_ == 0) {
        const double before = shift_;
        potential_.assemble(x, cloth::HessianForm::exact, solver_.matrix());
        for (;;) {
            if (Solution step = solved(forces, tolerance)) {
                projectedRun_ = 0;
                return step;
            }
            if (stop_.stop_requested()) return std::nullopt;
            if (shift_ >= levenberg_ || potential_.inertia() > 0) break;
            shift_ = std::max(10 * shift_, leastShift * levenberg_);
        }
        shift_ = before;
        projectedRun_ = std::min(projectedRun_ + 1, 3);
        projectedLeft_ = (1 << projectedRun_) - 1;
    } else {
        --projectedLeft_;
    }
    log.indefinite = true;
    potential_.assemble(x, cloth::HessianForm::projected, solver_.matrix());
    for (int attempt = 0; attempt < 12 && !stop_.stop_requested(); ++attempt) {
        if (Solution step = solved(forces, tolerance)) return step;
        shift_ = std::max(10 * shift_, 10 * leastShift * levenberg_);
    }
    return std::nullopt;
}

ShiftedSteps::Solution ShiftedSteps::projectedAt(std::span<const Vec3> x, std::span<const Vec3> forces,
                                                 double tolerance) {
    potential_.assemble(x, cloth::HessianForm::projected, solver_.matrix());
    return solved(forces, tolerance);
}

ShiftedSteps::Solution ShiftedSteps::solved(std::span<const Vec3> forces, double tolerance) {
    std::vector<double> shift(potential_.mass().size());
    for (std::size_t u = 0; u < shift.size(); ++u) shift[u] = (potential_.inertia() + shift_) * potential_.mass()[u];
    return solver_.solve(shift, forces, tolerance, stop_);
}

void ShiftedSteps::judge(const TakenStep& last, double surprise, double gain) {
    const double least = leastShift * levenberg_;
    if (surprise > 2 * last.expected) shift_ = std::max(16 * shift_, least);
    else if (gain < 0.25 || last.cuts > 1) shift_ = std::max(4 * shift_, least);
    else if (gain > 0.75 && last.cuts == 0) shift_ = shift_ > 1e-2 * least ? shift_ / 8 : 0;
}

void ShiftedSteps::trustLess() {
    shift_ = std::max(16 * shift_, 10 * leastShift * levenberg_);
}

} // namespace toile::dynamics
