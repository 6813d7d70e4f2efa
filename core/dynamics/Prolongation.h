// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/dynamics/LevelMesh.h"

#include <span>

namespace toile::dynamics {

/// Carries displacements of the particles of a coarse mesh to those of a finer one, linear in each triangle.
struct Prolongation {
    struct Term {
        int particle = 0;
        double weight = 0; ///< none negative; those of a fine particle sum to 1
    };
    std::vector<int> begin; ///< of each fine particle, and the end
    std::vector<Term> terms;

    [[nodiscard]] int count() const { return static_cast<int>(begin.size()) - 1; }
    [[nodiscard]] std::span<const Term> of(int fine) const {
        return {terms.data() + begin[fine], terms.data() + begin[fine + 1]};
    }
};

/// By material coordinates in each patch; a fine particle of several places, sewn together, takes their mean.
[[nodiscard]] Prolongation prolongation(const LevelMesh& fine, const LevelMesh& coarse);

/// The coarse triangle that holds the middle of each fine one.
[[nodiscard]] std::vector<int> parentsOf(const LevelMesh& fine, const LevelMesh& coarse);

} // namespace toile::dynamics
