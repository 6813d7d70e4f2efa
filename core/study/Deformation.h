// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/Simulation.h"

#include <string>
#include <vector>

namespace toile::study {

/// How much a part of a garment is deformed: a region, or what the regions leave of a piece.
struct PartDeformation {
    std::string piece, region; ///< region empty = the rest of the piece
    bool finer = false;        ///< its mesh is to be finer than the piece's
    double area = 0;           ///< [m²]
    double strainRms = 0;      ///< of warp and weft strain [–]
    double shearRms = 0;       ///< [rad]
    double curvatureRms = 0;   ///< along warp and weft lines [1/m]
    double stretchEnergy = 0;  ///< per area, of the fabric's uniaxial and shear moduli [J/m²]
    double bendingEnergy = 0;  ///< per area, along warp and weft lines [J/m²]
    [[nodiscard]] double energy() const { return stretchEnergy + bendingEnergy; }
};

/// Of all parts, in the order of the pattern, by the regions that `drawn` has: the simulation's own mesh should be
/// uniform, to be fair to all, for a finer one bends more.
[[nodiscard]] std::vector<PartDeformation> deformationOf(const simulation::Simulation& simulation,
                                                         const pattern::Pattern& drawn);

/// Whether the parts that are to be finer deform more than the others, with the table, in Markdown.
[[nodiscard]] std::string deformationText(const std::vector<PartDeformation>& parts);

} // namespace toile::study
