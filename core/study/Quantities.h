// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/Simulation.h"
#include "core/simulation/StrainSummary.h"
#include "core/simulation/Worn.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace toile::study {

enum class Measure { length, strain, area, count };

/// One number by which drapes of a garment are compared. Where folds are, and every point with them, is chance; these
/// are not.
struct Quantity {
    std::string_view name; ///< "hem at the centre front"
    std::string_view key;  ///< "hemFront", in records
    Measure measure = Measure::length;
    std::optional<double> value; ///< [m], [–] or [rad] for shear, [m²], [–]
    std::string whyAbsent;       ///< a sentence; empty where there is a value
};

/// Half of what a tape, or the eye, tells apart: a smaller difference is none. [m], [–], [m²], [–]
[[nodiscard]] double resolutionOf(Measure measure);
/// As it is written in tables: mm, %, cm², folds.
[[nodiscard]] double shown(Measure measure, double value);
[[nodiscard]] std::string_view unitOf(Measure measure);

/// A garment on a body, as it is measured.
struct WornDrape {
    const simulation::Drape& drape;
    const body::Body* body = nullptr; ///< null = none
    const collision::BodySurface* surface = nullptr;
    std::vector<double> touching; ///< at what distance from the body each particle lies on it [m]
    simulation::StrainSummary strain;
};

/// Always the same quantities in the same order; those that the garment does not have say why:
/// hem above the floor at the centre front, centre back and sides; its folds; wearing ease at bust, waist and hip;
/// distance of the back-neck point from the nape; shoulder points' height and distance (WornQuantities.h); of cloth
/// that is not worn its lowest point, mean height, area seen from above, folds at the border (HangingQuantities.h);
/// area that lies on the body; strain that 95 % of the area does not exceed.
[[nodiscard]] std::vector<Quantity> quantitiesOf(const WornDrape& worn);
[[nodiscard]] std::vector<Quantity> quantitiesOf(const simulation::Simulation& simulation);
/// The same without values.
[[nodiscard]] std::vector<Quantity> noQuantities();

/// Valleys of a closed line, seen from above, that are deeper than 5 mm under a tape drawn taut round it.
[[nodiscard]] int foldsOf(const std::vector<Vec3>& line);

} // namespace toile::study
