// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pattern/Colours.h"

#include <algorithm>
#include <cmath>

namespace toile::ui::colours {
namespace {

QColor onCircle(std::size_t index, double start, double saturation, double value) {
    const double hue = std::fmod(start + 0.381966 * static_cast<double>(index), 1.0);
    return QColor::fromHsvF(static_cast<float>(hue), static_cast<float>(saturation), static_cast<float>(value));
}

} // namespace

QColor distinct(std::size_t index) {
    return onCircle(index, 0.02, 0.72, 0.82);
}

QColor fabricTint(std::size_t index) {
    return onCircle(index, 0.58, 0.10, 0.96);
}

QColor regionTint(int refinement) {
    const int step = std::clamp(refinement, 0, 5);
    const double hues[] = {0.42, 0.14, 0.07,
                           0.0,  0.93, 0.85}; // green at the main spacing, then from yellow over red to violet
    return QColor::fromHsvF(static_cast<float>(hues[step]), 0.80F, 0.95F, 0.22F + 0.04F * static_cast<float>(step));
}

} // namespace toile::ui::colours
