// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/dynamics/SelfContact.h"
#include "core/simulation/Garment.h"
#include "core/simulation/MeetingPieces.h"
#include "core/simulation/Scene.h"

#include <memory>

namespace toile::simulation {

/// Whether two triangles of the cloth have no corner in common: else it cannot reach itself.
[[nodiscard]] bool canReachItself(const Garment& garment);

/// This garment as a surface that must not pass through itself, but for pieces that are let through each other:
/// thickness and friction from the fabrics.
[[nodiscard]] dynamics::ClothSurface clothSurfaceOf(const Scene& scene, const Garment& garment,
                                                    std::span<const PiecePair> passing = {});

/// The stage that keeps the layers of this garment apart.
[[nodiscard]] std::unique_ptr<dynamics::SelfContact> selfContactOf(const Scene& scene, const Garment& garment,
                                                                   std::span<const PiecePair> passing);

} // namespace toile::simulation
