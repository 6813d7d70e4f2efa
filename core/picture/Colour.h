// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace toile::picture {

/// Red, green and blue as a screen has them (sRGB) and opacity, each in [0, 1].
struct Colour {
    float r = 0, g = 0, b = 0, a = 1;
    friend bool operator==(const Colour&, const Colour&) = default;
};

} // namespace toile::picture
