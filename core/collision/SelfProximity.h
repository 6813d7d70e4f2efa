// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Team.h"
#include "core/collision/ElementPair.h"
#include "core/collision/SweptBox.h"
#include "core/geometry/TriangleMesh.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace toile::collision {

/// An edge of a surface and the corners across it; −1 where it has no second triangle.
struct SurfaceEdge {
    std::array<int, 2> vertices{};
    std::array<int, 2> opposite{-1, -1};
};

/// An edge that passes through a triangle: indices into edges() and triangles().
struct Piercing {
    int edge = 0, triangle = 0;
    friend auto operator<=>(const Piercing&, const Piercing&) = default;
};

/// Which elements of one deforming surface are near each other.
///
/// Triangles lie under a binary hierarchy of boxes, whose shape is fixed by where they are at first and whose
/// boxes are made anew for every search. Each corner and each edge belongs to one triangle, so that a pair is
/// met once (Curtis et al. 2008, representative triangles). Elements with a common corner are never a pair.
/// A team shares out the search; the pairs and their order are the same.
class SelfProximity {
public:
    /// No triangle names a vertex twice.
    SelfProximity(std::vector<geometry::TriangleIndices> triangles, std::span<const Vec3> positions);

    [[nodiscard]] const std::vector<geometry::TriangleIndices>& triangles() const { return triangles_; }
    [[nodiscard]] const std::vector<SurfaceEdge>& edges() const { return edges_; }
    [[nodiscard]] std::size_t bytes() const;

    /// A pair, and how near its elements are while the vertices are at their positions [m].
    struct Near {
        ElementPair pair;
        double distance = 0;
        std::uint64_t order =
            0; ///< where it stands among all pairs there could be: lists of several searches can be merged
    };
    /// Nothing when there are more than were asked for: then none is kept.
    using Pairs = std::optional<std::vector<Near>>;
    static constexpr std::size_t unlimited = std::numeric_limits<std::size_t>::max();

    /// The pairs not farther apart than `reach` [m].
    [[nodiscard]] Pairs pairsWithin(double reach, std::span<const Vec3> positions, std::size_t most = unlimited);
    /// Every pair that can come nearer than `reach` [m] while all vertices go together, on straight ways and
    /// in step, from their positions by their moves.
    [[nodiscard]] Pairs pairsInStep(double reach, std::span<const Vec3> positions, std::span<const Vec3> moves,
                                    std::size_t most = unlimited, Team* team = nullptr);
    /// Every pair that can come nearer than `reach` [m] while each vertex is anywhere in a box of its own, seen
    /// from its position.
    [[nodiscard]] Pairs pairsInBoxes(double reach, std::span<const Vec3> positions,
                                     std::span<const geometry::Box3> boxes, std::size_t most = unlimited,
                                     Team* team = nullptr);

    /// The last of these two searches again, for the pairs that have a flagged vertex: these go from their positions by
    /// their moves in that time, the others stay as they were in it. Only what flagged vertices reach is gone through.
    [[nodiscard]] Pairs pairsOfFlagged(std::span<const char> flagged, std::span<const Vec3> positions,
                                       std::span<const Vec3> moves, std::size_t most = unlimited, Team* team = nullptr);

    /// Edges that pass through triangles they have no corner in common with, in rising order.
    [[nodiscard]] std::vector<Piercing> piercings(std::span<const Vec3> positions);

private:
    struct Node {
        int second = -1;   ///< the first child follows its parent; −1 = leaf
        int triangle = -1; ///< of a leaf
    };
    /// What a triangle speaks for.
    struct Represented {
        std::array<int, 3> corners{-1, -1, -1}, edges{-1, -1, -1};
    };

    void findEdges();
    int build(std::span<int> triangles, std::span<const Vec3> centres);
    void fitNodes();
    void beginSearch(double reach, std::span<const char> flagged = {});
    /// Two nodes, and the way from the root to them: what is visited earlier has the lower one.
    struct NodePair {
        int first = 0, second = 0;
        int left = 64; ///< bits of the way that are not used yet
        std::uint64_t way = 0;
        friend bool operator==(const NodePair&, const NodePair&) = default;
    };
    [[nodiscard]] bool areNear(int first, int second) const;
    void appendBelow(const NodePair& pair, std::vector<NodePair>& todo) const;
    [[nodiscard]] bool areLeaves(const NodePair& pair) const;
    template <class Visit>
    void forNearTriangles(const NodePair& from, const Visit& visit) const;
    [[nodiscard]] std::vector<NodePair> sharesOfSearch(std::size_t count) const;
    template <class Keep>
    void visitElements(const NodePair& leaves, const Keep& keep) const;
    template <class MayMeet>
    Pairs collect(std::span<const Vec3> positions, std::size_t most, Team* team, std::span<const char> flagged,
                  const MayMeet& mayMeet);

    std::vector<geometry::TriangleIndices> triangles_;
    std::vector<SurfaceEdge> edges_;
    std::vector<Represented> represented_;
    std::vector<Node> nodes_;
    std::vector<SweptBox> vertexBoxes_, nodeBoxes_;
    std::vector<char> flagged_; ///< nodes below which a vertex is flagged; empty = all vertices count
    static constexpr double noWays = -1;
    double reach_ = noWays; ///< of the last search, if its boxes are round ways [m]
};

} // namespace toile::collision
