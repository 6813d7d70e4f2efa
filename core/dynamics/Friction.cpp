// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/dynamics/Friction.h"

#include <cmath>

namespace toile::dynamics {
namespace {

/// Within which normal forces are averaged [s].
constexpr double forceMemory = 1.0 / 60;

/// Second derivative of smoothLength.
double smoothCurvature(double u, double give) {
    return u >= give ? 0 : 2 / give - 2 * u / (give * give);
}

} // namespace

ContactPace::ContactPace(double duration, double pushOutTime, double pushOutSpeed)
    : eased_(-std::expm1(-duration / pushOutTime)), most_(pushOutSpeed * duration),
      remembered_(std::exp(-duration / forceMemory)), learnt_(-std::expm1(-duration / forceMemory)) {}

double smoothLength(double u, double give) {
    return u >= give ? u : u * u / give - u * u * u / (3 * give * give) + give / 3;
}

double smoothSlopeOverLength(double u, double give) {
    return u >= give ? 1 / u : 2 / give - u / (give * give);
}

void addOuter(double (&block)[9], const Vec3& a, double factor) {
    for (int r = 0; r < 3; ++r)
        for (int c = 0; c < 3; ++c) block[3 * r + c] += factor * a[r] * a[c];
}

void addFrictionCurvature(double (&block)[9], const Vec3& slip, const Vec3& normal, double limit, double give) {
    const double u = length(slip);
    const double across = limit * smoothSlopeOverLength(u, give);
    for (int axis = 0; axis < 3; ++axis) block[4 * axis] += across;
    addOuter(block, normal, -across);
    if (u > 0) addOuter(block, slip / u, limit * smoothCurvature(u, give) - across);
}

} // namespace toile::dynamics
