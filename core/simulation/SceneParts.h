// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Result.h"
#include "core/collision/BodySurface.h"
#include "core/simulation/Garment.h"
#include "core/simulation/MeshInputOf.h"
#include "core/simulation/Scene.h"
#include "core/simulation/Tacks.h"

#include <memory>
#include <vector>

namespace toile::simulation {

/// What a simulation is built from: the meshed pattern, no seam of it closed, its threads, and the body's surface.
struct SceneParts {
    Garment garment;
    std::vector<TackState> tacks;
    std::shared_ptr<const collision::BodySurface> body; ///< none in a scene without
};

/// Checks settings and pattern (pattern::checkPattern: what the mesher does not ask about may still be nonsense, such
/// as cloth that is less than nothing stiff) and builds. standing: the surface of the scene's body, where there is one
/// already.
[[nodiscard]] Result<SceneParts> partsOf(const Scene& scene, const MeshOverrides& overrides,
                                         std::shared_ptr<const collision::BodySurface> standing = nullptr);

} // namespace toile::simulation
