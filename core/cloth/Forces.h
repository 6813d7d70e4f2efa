// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/cloth/ClothModel.h"
#include "core/cloth/HessianSink.h"

#include <span>
#include <vector>

namespace toile::cloth {

/// Elastic energy by kind of element [J].
struct ElasticEnergy {
    double springs = 0;  ///< structural, shear and flexion, and elastics
    double bending = 0;  ///< three-point, twist and hinges
    double membrane = 0; ///< triangles and membrane cells
    [[nodiscard]] double total() const { return springs + bending + membrane; }
};

[[nodiscard]] ElasticEnergy elasticEnergy(const ClothModel& model, std::span<const Vec3> positions);

/// Total elastic energy [J]. Slaves are read at their own positions.
[[nodiscard]] double energy(const ClothModel& model, std::span<const Vec3> positions);

/// Adds −∂E/∂x [N], |particles|. A slave's share stays with the slave: see gatherToMasters.
void addForces(const ClothModel& model, std::span<const Vec3> positions, std::span<Vec3> forces);

/// Both ends in one place leave a spring no direction: it takes one of its own, so that it parts them, and always the
/// same way. Of unit length.
[[nodiscard]] Vec3 ownDirection(int a, int b);

enum class HessianForm {
    exact,     ///< may be indefinite where cloth is compressed
    projected, ///< each element's negative part is left out: positive semi-definite
};

void addHessian(const ClothModel& model, std::span<const Vec3> positions, HessianForm form, HessianSink& sink);

/// Moves what lies on slaves to their masters by their weights, leaving 0.
void gatherToMasters(const ClothModel& model, std::span<Vec3> forces);

/// Puts slaves where their masters say.
void placeSlaves(const ClothModel& model, std::span<Vec3> positions);

/// Gershgorin rows of M⁻¹K near rest [1/s²], one per particle, slaves' shares given to their masters: the largest
/// bounds every squared angular frequency. 0 for what is pinned, a slave, or without elements. Positions are read for
/// hinges only.
[[nodiscard]] std::vector<double> frequenciesSquared(const ClothModel& model, std::span<const Vec3> positions = {});

/// The largest of them; 0 for a cloth without elements.
[[nodiscard]] double largestFrequencySquared(const ClothModel& model, std::span<const Vec3> positions = {});

/// The largest such row of K [N/m]: what a displacement of one particle can cause, for the rounding floor of forces.
[[nodiscard]] double largestStiffness(const ClothModel& model, std::span<const Vec3> positions = {});

} // namespace toile::cloth
