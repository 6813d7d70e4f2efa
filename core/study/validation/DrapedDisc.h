// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/Vec.h"
#include "core/material/Fabric.h"
#include "core/study/validation/Findings.h"

#include <complex>
#include <vector>

namespace toile::study::validation {

/// A disc of cloth that hangs over a smaller round support: Cusick's test.
struct Disc {
    material::Fabric fabric;
    double spacing = 0.01; ///< [m]
    double grain = 0;      ///< warp from the disc's own y [rad]
    bool ring = false;     ///< only what hangs, hinged to the edge of the support: no step of the grid holds it
    unsigned seed = 7;     ///< of the noise it starts with
    double noise = 1e-4;   ///< how uneven it is laid [m]
    double inner = 0.09, outer = 0.15; ///< radii of support and specimen, those of BS 5058 [m]
};

/// A draped disc.
struct Drape {
    double inner = 0, outer = 0; ///< radii before [m]
    std::vector<Vec3> rim;       ///< in order round the axis of the support, which is level at y = 0 [m]
    std::vector<Vec2> flat;      ///< where each particle was before [m]
    std::vector<Vec3> positions;

    /// Drape coefficient: shadow of the hanging ring over the area of the ring [%].
    [[nodiscard]] double coefficient() const;
    /// Of the part of the rim's height that goes round so many times [–].
    [[nodiscard]] std::complex<double> wave(int times) const;
    [[nodiscard]] double meanHeight() const;
    /// Along the cloth from the support to the rim, by the particles that lay in this direction [m]: the sum of arcs,
    /// as curved as three particles in a row say. Chords would be too short by more than the weight of the cloth
    /// stretches.
    [[nodiscard]] double lengthTowards(double angle) const;
    /// How often the rim passes its mean height on its way up.
    [[nodiscard]] int folds() const;
};

/// A weave of 0.2 kg/m² with a bending length of 20 mm, the median of measured fabrics: 10 mm shows its folds.
[[nodiscard]] material::Fabric drapingWeave();

/// Empty, with the reason in `found`, if it does not come to rest.
[[nodiscard]] Drape drapeOf(Findings& found, const Disc& disc);

} // namespace toile::study::validation
