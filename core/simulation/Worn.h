// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/body/Landmarks.h"
#include "core/collision/BodySurface.h"
#include "core/simulation/Openings.h"
#include "core/simulation/StrainSummary.h"

#include <optional>
#include <string>
#include <vector>

namespace toile::simulation {

/// One border of the sewn garment and the limbs that pass through it.
struct OpeningReport {
    std::string name;               ///< "neck", "left arm", "hem"…, by the limb that crosses it
    std::vector<std::string> limbs; ///< limbs whose middle line crosses it
    int crossings = 0;              ///< of all middle lines together
    double perimeter = 0;           ///< [m]
    double height = 0;              ///< mean height over the floor [m]
    double startHeight = 0;         ///< the same where the pieces were placed [m]
};

struct WornSettings {
    double rightSideShare = 0.99; ///< of the area must have its right side out [–]
    double napeDistance = 0.015;  ///< largest distance of the back-neck point from the nape; below it, more by what the
                                  ///< neckline is wider than the neck [m]
    double symmetry = 0.005;      ///< largest difference of a mirror pair of landmarks [m]
    double freeRim = 0.050;   ///< mean distance from the body beyond which an opening hangs in folds of its own: its
                              ///< corners are no landmarks [m]
    double waistDrop = 0.015; ///< how far a waistband may lie from the level it was placed at [m]
    double stretchPercentile99 =
        0.02;                     ///< which 99 % of the area of woven cloth may not exceed, along warp and weft [–]
    double stretchMaximum = 0.05; ///< which no element of woven cloth may exceed [–]
};

/// Whether the garment hangs on the body as it was meant to.
struct WornReport {
    bool worn = false;
    std::vector<std::string> why; ///< a sentence for each condition that fails; empty when worn
    std::vector<OpeningReport> openings;
    double turnedLength = 0;                  ///< of seams that join right side to wrong side [m]
    double rightSideOut = 0;                  ///< share of the area whose right side is the outside of the garment
    std::optional<double> napeDistance;       ///< [m]; of garments with a neck opening
    std::optional<double> necklineWiderBy;    ///< than the neck, on either side [m]; of the same
    std::optional<double> symmetryDifference; ///< [m]; of patterns with mirror pieces
    std::optional<double> waistDrop;          ///< [m]; of garments without a neck opening
    std::optional<StrainSummary> wovenStrain; ///< of garments with woven pieces
};

/// The drape as the verdict needs it, buttoned plackets filled (Plackets.h). Particle indices; `start` are the placed
/// positions.
struct Drape {
    static constexpr int noPiece = -1; ///< of a triangle that only fills a placket
    std::vector<std::array<int, 3>> triangles;
    std::vector<Vec3> positions, start;
    std::vector<std::array<int, 2>> mirrorPairs;   ///< particles at corners of mirror pieces and their sources
    std::vector<int> piece = {};                   ///< of each triangle, or noPiece; empty = all of one
    std::optional<StrainSummary> wovenStrain = {}; ///< of the woven pieces; absent if all are knits
};

/// Of each border, the limbs that pass through it.
[[nodiscard]] std::vector<OpeningReport> openingReports(const std::vector<Opening>& openings, const Drape& drape,
                                                        const body::Body& body);

[[nodiscard]] WornReport wornReport(const Drape& drape, const body::Body& body, const collision::BodySurface& surface,
                                    const WornSettings& settings = {});

/// Whether the garment hangs on the shoulders: else its uppermost opening is a waistband.
[[nodiscard]] bool hasNeckOpening(const Drape& drape, const body::Body& body);

/// How often a polyline passes through the fan from a closed loop's centre to its edges. The fan of a hem that hangs in
/// folds lies over itself: there and back counts only for a line that goes back as often as there.
[[nodiscard]] int crossings(const std::vector<Vec3>& loop, const std::vector<Vec3>& polyline);

} // namespace toile::simulation
