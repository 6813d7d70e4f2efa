// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/meshing/FixedPoints.h"

#include <functional>

namespace toile::meshing {

/// A stretch of an edge between fixed points.
struct Stretch {
    double from = 0, to = 1; ///< fractions of the edge's arc length
    int group = 0;           ///< stretches of one group carry equal counts
};

/// The finest spacing wanted along a stretch of an edge [m].
using SpacingAlong = std::function<double(int piece, int loop, int edge, double from, double to)>;

/// How all boundary edges are divided: into stretches, and these into equal parts, the same number on both
/// sides of every seam. Lives in the arena it was created in.
class BoundaryDivision {
public:
    [[nodiscard]] static Result<BoundaryDivision> create(const MeshInput& input,
                                                         const std::vector<PieceBoundary>& boundaries,
                                                         std::span<const CheckedSeam> seams, const FixedPoints& points,
                                                         const SpacingAlong& spacing, Arena& arena);

    [[nodiscard]] std::span<const Stretch> stretches(int piece, int loop, int edge) const;
    [[nodiscard]] int count(const Stretch& stretch) const { return counts_[static_cast<std::size_t>(stretch.group)]; }
    /// The fractions of the nodes of an edge from 0 to 1, which overwrite the list.
    void listFractions(int piece, int loop, int edge, std::pmr::vector<double>& fractions) const;
    /// How many nodes a loop has at most.
    [[nodiscard]] std::size_t mostNodes(int piece, int loop) const;
    /// The stretches of the straight edges along the grain of a piece, by axis.
    [[nodiscard]] GrainStretches grainStretches(const PieceInput& piece, int pieceIndex, const PieceBoundary& boundary,
                                                Arena& arena) const;
    /// All that says where the nodes of a piece's border lie on it.
    void describe(int piece, std::pmr::vector<double>& description) const;
    /// Doubles the number of parts of all stretches of a group.
    void refine(int group) { counts_[static_cast<std::size_t>(group)] *= 2; }
    /// The end of the edge is no node: it lies in a smooth run of edges much shorter than the spacing, as
    /// digitisers give them, and only every so manieth of their vertices is taken.
    [[nodiscard]] bool passesEnd(int piece, int loop, int edge) const;
    /// Makes every vertex of a loop a node after all.
    void takeEveryVertex(int piece, int loop);

private:
    /// [piece][loop][edge]
    template <class T>
    using OfEdges = std::pmr::vector<std::pmr::vector<std::pmr::vector<T>>>;

    explicit BoundaryDivision(Arena& arena) : passed_(&arena), stretches_(&arena), counts_(&arena) {}

    [[nodiscard]] std::pmr::vector<int> groupsAlong(const SeamChain& chain, Arena& arena) const;
    void followFacingEdges(const PieceInput& piece, int pieceIndex, const PieceBoundary& boundary,
                           const SewnEdges& sewn, Arena& arena);

    OfEdges<char> passed_;
    OfEdges<std::pmr::vector<Stretch>> stretches_;
    std::pmr::vector<int> counts_; ///< by group
};

} // namespace toile::meshing
