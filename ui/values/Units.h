// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace toile::ui {

/// What a number of the core means, so that it is shown in the trade's unit. Core counts in SI.
enum class Quantity {
    length,       ///< m, shown in mm
    area,         ///< m², shown in cm²
    angle,        ///< rad, shown in degrees
    foldAngle,    ///< rad from flat, shown in degrees with 180° = flat
    arealDensity, ///< kg/m², shown in g/m²
    tension,      ///< N/m
    force,        ///< N
    bending,      ///< N·m, shown in µN·m
    acceleration, ///< m/s²
    damping,      ///< 1/s
    time,         ///< s
    shortTime,    ///< ms
    speed,        ///< m/s, shown in mm/s
    wind,         ///< m/s
    pressure,     ///< Pa
    factor,       ///< a plain number
    count,        ///< a whole number
};

/// shown = offset + perUnit · value
struct UnitFormat {
    double perUnit = 1;
    double offset = 0;
    int decimals = 0;
    QString suffix; ///< with its leading space, e.g. " mm"
};

[[nodiscard]] UnitFormat formatOf(Quantity quantity);
[[nodiscard]] double shown(Quantity quantity, double value);
[[nodiscard]] double fromShown(Quantity quantity, double number);
/// The number with its unit, e.g. "12.5 mm".
[[nodiscard]] QString textOf(Quantity quantity, double value);
/// The same with a sign even when positive: differences.
[[nodiscard]] QString differenceTextOf(Quantity quantity, double value);

} // namespace toile::ui
