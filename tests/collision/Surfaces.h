// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/collision/BodySurface.h"

#include <QtGlobal>
#include <limits>

namespace toile::shapes {

constexpr double anywhere = std::numeric_limits<double>::infinity(); ///< how far off the nearest place may be

/// Of a sound shape.
inline collision::BodySurface surfaceOf(geometry::TriangleMesh mesh) {
    auto surface = collision::BodySurface::create(std::move(mesh));
    if (!surface) qFatal("%s", toString(surface.error()).c_str());
    return std::move(*surface);
}

} // namespace toile::shapes
