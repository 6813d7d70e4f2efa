// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/body/MannequinShape.h"

namespace toile::body {

/// The girths, in the order of the table of a mannequin.
enum class GirthName { bust, underBust, waist, hip, neck, biceps, wrist, thigh };
inline constexpr int girthCount = 8;

/// One number per girth [m].
using Girths = std::array<double, girthCount>;

[[nodiscard]] Girths askedGirths(const Measurements& measurements);

/// Where a girth is measured: the tape's plane, whose origin lies inside the limb.
/// Bust, under-bust, waist, hip and thigh are horizontal; neck, biceps and wrist lie square to the limb's
/// line.
struct TapePlane {
    Vec3 origin, normal,
        across; ///< across: a direction in the plane in which the section is mirror-symmetric or nearly
};
[[nodiscard]] TapePlane tapePlane(const MannequinShape& shape, GirthName name);

/// Girth of the field's zero in a plane, as a tape lies [m].
[[nodiscard]] double tapeGirth(const MannequinShape& shape, const TapePlane& plane);

/// The landmarks of the field.
[[nodiscard]] Landmarks landmarksOf(const MannequinShape& shape, const Measurements& measurements);

/// The factors with which the field has the aimed girths and the measured lengths.
[[nodiscard]] ShapeFactors fitted(const Measurements& measurements, const Girths& aims, ShapeFactors start);

} // namespace toile::body
