// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/Simulation.h"
#include "core/simulation/Speeds.h"

#include <algorithm>

/// How what was sewn or edited settles, and when it rests (docs/decisions/0003-dressing.md).
namespace toile::simulation {
namespace {

constexpr double longEnough = 0.5;  ///< that slow, for a garment to be at rest [s]
constexpr double trembleAfter = 2;  ///< the time in which what was put on settles, it may tremble [s]
constexpr double slowEnough = 0.03; ///< that slow, for what was sewn to be judged by the scene's damping [s]
/// Of cloth that hands hold [1/s]: its taut edges are strings that would go on ringing, by position-based steps for
/// ever.
constexpr double handDamping = 5;

} // namespace

double Simulation::damping() const {
    if (phase_ == Phase::sewing) return dressing.sewingDamping;
    if (phase_ == Phase::shaking && leaps_ && plannedLevels_ > 0 && state_.time < sewnTime_ + dressing.releaseTime)
        return dressing.releaseDamping;
    if (phase_ == Phase::shaking && !goesOnAsItLay_ && state_.time < sewnTime_ + dressing.stiffeningTime)
        return dressing.sewingDamping;
    const bool isLeftAlone = grips_->empty() && !motion_;
    const double held = grips_->empty() ? 0 : handDamping;
    const bool isSlow = restingTime_ >= (goesOnAsItLay_ ? longEnough : slowEnough);
    const bool isSettling = phase_ == Phase::shaking || (isLeftAlone && ((settles_ && !isSlow) || fallsAsleep()));
    return std::max({scene_.settings.damping, held, isSettling ? dressing.settlingDamping : 0});
}

/// Whether what was put on rests is judged by the scene's damping. The swing that is left then is of no use to anybody:
/// the sooner it lies still, the sooner it sleeps. What slides goes on. Accurate methods show how it moves by itself.
bool Simulation::fallsAsleep() const {
    const bool wasPutOn = !seams_.empty() && !scene_.paper;
    return rests() && wasPutOn && !scene_.settings.air && drapingMethod_ == dynamics::Method::xpbd;
}

/// The plan stands. In a new one coarse levels and layers have forgotten what they bore, and cloth that hardly moves is
/// set in motion.
void Simulation::dampAnew() {
    plannedDamping_ = damping();
    stillTime_ = 0;
    xpbd_->setSettings(settingsOfXpbd());
}

double Simulation::shakingTime() const {
    return goesOnAsItLay_ ? dressing.editShakingTime : dressing.shakingTime;
}

/// Fine cloth may go on trembling by levels where it is crumpled; hands move it anyway. What came to rest by them stays
/// as it lies: without them it is stiffer, and would begin to move.
bool Simulation::levelsMayHelp() const {
    return !grips_->empty() || movedLast() <= settledBy();
}

bool Simulation::rests() const {
    return restingTime_ >= longEnough;
}

double Simulation::movedLast() const {
    return state_.time - restingTime_;
}

double Simulation::settledBy() const {
    return sewnTime_ + shakingTime() + (hangsBy_.empty() ? dressing.settlingTime : dressing.hangingTime);
}

/// What should have come to rest long since, and goes nowhere: crumpled layers may tremble for ever by position-based
/// steps. Statics tells whether it lies in equilibrium; the paper has none.
bool Simulation::tremblesInPlace(double duration) {
    if (scene_.paper || state_.time < settledBy() + trembleAfter) return false;
    return inPlace_.note(state_.positions, duration) >= longEnough;
}

/// After a frame step. What air moves may never rest.
void Simulation::noteRest(const Speeds& speeds, double duration) {
    const bool drapes = phase_ == Phase::draping, isLeftAlone = drapes && !motion_;
    const bool tremblesOnly = isLeftAlone && tremblesInPlace(duration);
    restingTime_ = isLeftAlone && (tremblesOnly || speeds.areOfRest()) ? restingTime_ + duration : 0;
    stillTime_ = isLeftAlone && speeds.areStill() ? stillTime_ + duration : 0;
    const bool tookTooLong = drapes && scene_.settings.air && movedLast() > settledBy();
    if (rests() || tookTooLong) settles_ = false;
    if (rests()) goesOnAsItLay_ = false;
}

} // namespace toile::simulation
