// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/cloth/ClothModel.h"
#include "core/pattern/Pattern.h"
#include "core/simulation/ParticleMap.h"

#include <span>
#include <vector>

namespace toile::simulation {

/// The hinges of one pressed fold in a cloth.
struct FoldHinges {
    int piece = 0, fold = 0;        ///< of the pattern, and of the piece
    std::size_t first = 0, end = 0; ///< in ClothModel::hinges
};

/// Appends a hinge for every side of the mesh that lies on a pressed fold. Rest angle and stiffness factor come from
/// the fold.
[[nodiscard]] std::vector<FoldHinges> appendFoldHinges(cloth::ClothModel& model, const pattern::Pattern& pattern,
                                                       const meshing::GarmentMesh& mesh, const ParticleMap& particles);

[[nodiscard]] std::ptrdiff_t hingesOf(std::span<const FoldHinges> folds);

/// How a pressed fold lies.
struct FoldReport {
    std::string piece, name;
    double restAngle = 0;                 ///< as pressed [rad]
    double mean = 0, least = 0, most = 0; ///< of the angles along it, the mean by length [rad]
};

[[nodiscard]] std::vector<FoldReport> foldReports(const pattern::Pattern& pattern, const cloth::ClothModel& model,
                                                  std::span<const FoldHinges> folds, std::span<const Vec3> positions);

} // namespace toile::simulation
