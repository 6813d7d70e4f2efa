// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace toile::simulation {

/// How far cloth is strained, over the elements of a garment or of some of its pieces.
struct StrainSummary {
    double warpMaximum = 0, weftMaximum = 0, shearMaximum = 0; ///< largest stretch [–]; shear angle [rad]
    double warpPercentile99 = 0, weftPercentile99 = 0;         ///< of the area [–]
    double warpPercentile95 = 0, weftPercentile95 = 0;         ///< of the area [–]
    double shearPercentile95 = 0;                              ///< of the area, without sign [rad]
    double rms = 0;                                            ///< of warp and weft strain over the area [–]
};

/// How far the cloth of a garment is curved along its mesh lines, over the area and both directions.
struct CurvatureSummary {
    double rms = 0;         ///< [1/m]
    double alternating = 0; ///< rms of what of it alternates from node to node: waves too short for the mesh [1/m]
};

} // namespace toile::simulation
