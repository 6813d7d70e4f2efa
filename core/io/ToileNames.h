// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <numbers>

namespace toile::io {

// The words of the file in the order of the enumerations they stand for.
inline constexpr std::array notchKindNames{"slit", "v", "t", "castle"};
inline constexpr std::array lineRuleNames{"regular", "features", "paper"};
inline constexpr std::array regionBorderNames{"snap", "exact"};
inline constexpr std::array fabricKindNames{"woven", "knit"};
inline constexpr std::array edgeShapeNames{"line", "cubic", "arc"};

/// The nearest multiple of 1/steps.
inline double roundedTo(double value, double steps) {
    return std::round(value * steps) / steps;
}

/// [m] → [mm], to 1e-6 mm.
inline double millimetres(double metres) {
    return roundedTo(metres * 1000, 1e6);
}
inline double metres(double millimetres) {
    return millimetres / 1000;
}
/// [rad] → degrees, to 1e-9°.
inline double degrees(double radians) {
    return roundedTo(radians * 180 / std::numbers::pi, 1e9);
}
inline double radians(double degrees) {
    return degrees * std::numbers::pi / 180;
}

} // namespace toile::io
