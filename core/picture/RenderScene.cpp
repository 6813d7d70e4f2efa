// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/picture/RenderScene.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace toile::picture {

std::optional<geometry::Box3> boundsOf(const RenderScene& scene) {
    std::optional<geometry::Box3> box;
    const auto grow = [&](const std::vector<Vec3>& points) {
        for (const Vec3& p : points) {
            if (!isFinite(p)) continue;
            if (!box) box = {p, p};
            for (int axis = 0; axis < 3; ++axis) {
                box->low[axis] = std::min(box->low[axis], p[axis]);
                box->high[axis] = std::max(box->high[axis], p[axis]);
            }
        }
    };
    if (scene.body && scene.options.body) grow((*scene.body)->mesh.vertices);
    if (scene.frame && scene.options.cloth) grow((*scene.frame)->positions);
    return box;
}

Colour seamColour(std::size_t seam) {
    // Steps of the golden section round the wheel of hues never come back close to where they were.
    const double hue = std::fmod(0.02 + 0.61803398875 * static_cast<double>(seam), 1.0) * 6;
    const auto channel = [&](double offset) {
        const double away = std::abs(std::remainder(hue - offset, 6.0)); // of the channel's own hue, 0…3
        return static_cast<float>(0.16 + 0.64 * std::clamp(2 - away, 0.0, 1.0));
    };
    return {channel(0), channel(2), channel(4)};
}

} // namespace toile::picture
