// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/Vec.h"

#include <algorithm>

namespace toile::dynamics {

/// What body contact and self-contact share: approach by steps that do not jump, and the friction of statics.

[[nodiscard]] inline Vec3 tangential(const Vec3& v, const Vec3& normal) {
    return v - normal * dot(v, normal);
}

/// What contact does in a substep of a given length, the same for all that touches.
class ContactPace {
public:
    /// pushOutTime in which a small overlap falls to 1/e [s], pushOutSpeed at most [m/s], in substeps of the
    /// duration [s].
    ContactPace(double duration, double pushOutTime, double pushOutSpeed);

    /// The distance that a substep must reach when it starts at `before` and `wanted` is to be kept [m]: cloth
    /// that is too near is led out with an easing speed.
    [[nodiscard]] double allowedDistance(double before, double wanted) const {
        const double overlap = wanted - before;
        return overlap <= 0 ? wanted : before + std::min(overlap * eased_, most_);
    }
    /// Of a mean force, what stays of that before and what comes from that of this substep [–].
    [[nodiscard]] double remembered() const { return remembered_; }
    [[nodiscard]] double learnt() const { return learnt_; }

private:
    double eased_; ///< share of an overlap [–]
    double most_;  ///< [m]
    double remembered_, learnt_;
};

/// Smoothed |u| with f'(0) = 0, equal to |u| from give on. Ref: Li et al. 2020, Incremental Potential
/// Contact, §5.
[[nodiscard]] double smoothLength(double u, double give);
/// Its derivative over u.
[[nodiscard]] double smoothSlopeOverLength(double u, double give);

void addOuter(double (&block)[9], const Vec3& a, double factor);

/// ∂²/∂x² of limit·smoothLength(|T x|), positive semi-definite; T projects across the normal, slip = T x.
void addFrictionCurvature(double (&block)[9], const Vec3& slip, const Vec3& normal, double limit, double give);

} // namespace toile::dynamics
