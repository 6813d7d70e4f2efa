// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Contracts.h"
#include "core/cloth/RegularPatches.h"
#include "core/dynamics/Stage.h"

#include <numbers>
#include <random>

/// What the cases are made of.
namespace toile::study::validation {

using cloth::ClothModel;
using cloth::evenLines;
using cloth::flatPositions;
using cloth::gridPatch;
using cloth::Patch;
using cloth::trianglePatch;
using cloth::twoRegionPatch;
using cloth::unequalWeave;
using dynamics::ParticleState;
using material::Fabric;

constexpr double standardGravity = 9.81; ///< [m/s²]
constexpr Vec3 downward{0, -standardGravity, 0};

/// Speeds of up to 1 m/s along each axis, at random, always the same.
inline std::vector<Vec3> kickOf(std::size_t particles) {
    std::mt19937 random(11);
    std::vector<Vec3> velocities(particles);
    for (Vec3& v : velocities)
        for (int axis = 0; axis < 3; ++axis) v[axis] = 2 * (static_cast<double>(random()) / std::mt19937::max()) - 1;
    return velocities;
}

inline ClothModel modelOf(const Patch& patch, const Fabric& fabric, cloth::CellForm form = cloth::CellForm::automatic) {
    ClothModel model;
    const auto report = cloth::appendPatch(model, patch, fabric, {form});
    expects(report.has_value(), "the patch of a case is a cloth");
    return model;
}

} // namespace toile::study::validation
