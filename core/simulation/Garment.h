// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Result.h"
#include "core/base/Shared.h"
#include "core/cloth/ClothModel.h"
#include "core/cloth/PaperSprings.h"
#include "core/cloth/Patch.h"
#include "core/pattern/Pattern.h"
#include "core/simulation/FoldHinges.h"
#include "core/simulation/ParticleMap.h"

#include <optional>
#include <vector>

namespace toile::simulation {

/// A meshed pattern as cloth, with some of its seams merged.
struct Garment {
    Shared<meshing::GarmentMesh> mesh;
    std::vector<bool> mergedSeams;
    ParticleMap particles;
    cloth::ClothModel model;
    std::vector<int> pinnedToBody;     ///< those of the model's pinned that the body carries along, rising
    std::vector<double> halfThickness; ///< of the cloth at each particle [m]
    std::vector<double> friction;      ///< of the cloth at each particle [–]
    std::vector<FoldHinges> folds;
    std::optional<cloth::PaperReport> paper = {}; ///< of springs alone
};

/// Of the cloth in a region of a piece that is no mirror image; outside all regions (negative) those of the fabric
/// itself.
[[nodiscard]] cloth::StiffnessFactors factorsOf(const pattern::Piece& piece, int region);

/// Builds the cloth; of the paper's springs alone if that is asked. Errors name the fabric or pin that is wrong.
[[nodiscard]] Result<Garment> makeGarment(const pattern::Pattern& pattern, Shared<meshing::GarmentMesh> mesh,
                                          std::vector<bool> mergedSeams, bool paper = false);

/// The display triangles of all pieces, naming particles.
[[nodiscard]] std::vector<std::array<int, 3>> particleTriangles(const Garment& garment);

/// Of each particle, which it will be part of when all seams are merged; none where they are.
[[nodiscard]] std::vector<int> whatBecomesOf(const Garment& garment);

} // namespace toile::simulation
