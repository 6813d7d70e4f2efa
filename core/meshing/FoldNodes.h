// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/meshing/BoundaryNodes.h"
#include "core/meshing/Lattice.h"

#include <utility>
#include <vector>

namespace toile::meshing {

/// Refuses folds that do not run from border to border.
[[nodiscard]] Result<void> checkFolds(const PieceInput& piece, const PieceBoundary& boundary);

/// Appends the nodes of a piece's folds to those of its border: at the fold's ends and corners, where a leg along
/// the grain meets main lines, elsewhere in equal parts no longer than the cells there. Refuses folds that cross or
/// touch the border or one another. The lattice must be numbered.
[[nodiscard]] Result<void> addFoldNodes(const PieceInput& piece, const PieceBoundary& boundary, const Lattice& lattice,
                                        BoundaryNodes& nodes);

/// The sides between neighbouring nodes of folds, to be asked which they are.
class FoldSides {
public:
    void assign(const BoundaryNodes& nodes);
    [[nodiscard]] bool isEmpty() const { return sides_.empty(); }
    [[nodiscard]] bool has(int a, int b) const;

private:
    std::vector<std::pair<int, int>> sides_; ///< the smaller node first, sorted
};

} // namespace toile::meshing
