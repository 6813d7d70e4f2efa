// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/Vec.h"

#include <array>
#include <vector>

namespace toile::body {

/// One cross-section of a limb: four quarters of superellipses round a centre, in the frame of its tube [m].
struct Section {
    double at = 0;              ///< along the tube's y
    Vec2 centre;                ///< where the quarters meet, in the tube's x and z
    double right = 0, left = 0; ///< half-axes toward −x and +x
    double front = 0, back = 0; ///< half-axes toward +z and −z
    double power = 2;           ///< 2 ellipse, larger squarer [–]
};

/// A limb as sections along a straight line, joined by clamped cubic splines, closed by elliptic caps.
class SectionTube {
public:
    /// At least two sections with rising `at`; lowCap and highCap are how far the caps bulge past the ends
    /// [m].
    SectionTube(const Transform& frame, const std::vector<Section>& sections, double lowCap, double highCap);

    /// Negative inside, zero on the surface, near it about the distance (measured from the tube's middle
    /// line) [m].
    [[nodiscard]] double distance(const Vec3& point) const;
    /// The middle of the section at a place along the tube, in space.
    [[nodiscard]] Vec3 middle(double at) const;
    [[nodiscard]] Section sectionAt(double at) const;

private:
    using Values = std::array<double, 7>; ///< centre x, centre z, right, left, front, back, power
    [[nodiscard]] Values valuesAt(double at) const;

    Transform frame_;
    double lowCap_, highCap_;
    std::vector<double> at_;
    std::vector<Values> values_, curvatures_;
    double reach_ = 0; ///< no surface lies farther from the tube's line [m]
};

/// The smaller of two distances, with the edge between them rounded over a width k [m].
[[nodiscard]] double smoothMin(double a, double b, double k);

} // namespace toile::body
