// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>

#include <cstddef>

namespace toile::ui::colours {

inline const QColor canvas{247, 248, 249};
inline const QColor gridFine{233, 236, 239};
inline const QColor gridCoarse{216, 221, 226};
inline const QColor gridAxis{178, 188, 198};
inline const QColor ruler{255, 255, 255};
inline const QColor rulerText{110, 120, 130};
inline const QColor allowance{255, 255, 255}; ///< between stitching line and cut line
inline const QColor outline{44, 54, 66};
inline const QColor quiet{140, 150, 160};
inline const QColor text{44, 54, 66};
inline const QColor accent{20, 115, 200};
inline const QColor hover{255, 150, 40};
inline const QColor handle{205, 90, 30};
inline const QColor draft{20, 115, 200};
inline const QColor sideA{210, 60, 60};
inline const QColor sideB{30, 120, 210};
inline const QColor warning{200, 40, 40};

/// Distinct colours for seams, fabrics and the like, by index: steps of the golden angle round the colour circle.
[[nodiscard]] QColor distinct(std::size_t index);
/// The quiet tint of a piece cut from the fabric with that index.
[[nodiscard]] QColor fabricTint(std::size_t index);
/// The tint of a region meshed at ε_m/2^refinement: the finer, the warmer and stronger.
[[nodiscard]] QColor regionTint(int refinement);

} // namespace toile::ui::colours
