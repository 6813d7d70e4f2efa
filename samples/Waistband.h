// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/Document.h"
#include "samples/Placing.h"
#include "samples/Sewing.h"

namespace toile::samples {

struct WaistbandSettings {
    double length = 0.73;  ///< of its lower edge, closed [m]
    double width = 0.035;  ///< [m]
    double spacing = 0.02; ///< ε_m [m]
};

/// Substeps of a frame step with which a ring of interlined cloth carries a garment that hangs on nothing else: fewer
/// let it stretch and slip, at a spacing of 20 mm by 25 mm with 90 and by 10 mm with these.
inline constexpr int waistbandSubsteps = 250;

/// ε_m of a skirt's waistband at most: longer cells find no hold on the curve of the waist [m].
inline constexpr double waistbandSpacing = 0.02;

/// The scene of a skirt that hangs on a waistband: on the usual mannequin, damped, its folds kept apart.
void hangOnWaistband(document::Document& skirt);

/// A fabric with a fusible interlining: what keeps a waistband's length and lets it stay at the waist.
[[nodiscard]] pattern::Fabric interlined(pattern::Fabric fabric);

/// A straight band, x = 0 at the centre front, its wearer's left on +x, closed behind; it starts as a ring round the
/// waist with its lower edge at y = 0 of the piece, `lowered` beneath the waist. Edges: bottom-right (x < 0),
/// bottom-left, end-left, top, end-right.
[[nodiscard]] pattern::Piece draftWaistband(const pattern::Fabric& fabric, const body::Body& body,
                                            const WaistbandSettings& settings, double lowered);

/// The seam that closes the band.
[[nodiscard]] pattern::Seam waistbandSeam(const pattern::Piece& band);

/// Centre and least radius of a level ring round the trunk between two heights [m].
struct Ring {
    Vec3 centre;
    double radius = 0;
};
[[nodiscard]] Ring ringRound(const body::Body& body, double low, double high, double clearance);

} // namespace toile::samples
