// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Team.h"
#include "core/collision/ClusterTree.h"
#include "core/collision/ElementPair.h"
#include "core/collision/FourSweptBoxes.h"
#include "core/geometry/TriangleMesh.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <map>
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
/// Clusters of triangles lie under a binary hierarchy of boxes, and within a cluster four boxes of its elements side by
/// side. Each triangle, corner and edge belongs to one cluster, so that a pair is met once (Curtis et al. 2008,
/// representative triangles). Elements with a common corner are never a pair. A team shares out the search; the pairs
/// and their order are the same.
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
    /// Elements of one kind, with `corners` each; those of each cluster together, four boxes side by side.
    template <int corners>
    struct Elements {
        struct Four {
            FourSweptBoxes boxes;
            BoxFlags ids = BoxFlags{} - 1, vertices[corners]{}; ///< −1 = none, and what is nowhere
        };
        std::vector<int> begin{0}; ///< of a cluster in what follows, and the end
        std::vector<Four> fours;

        void add(int id, std::span<const int, corners> vertices);
        void endCluster() { begin.push_back(static_cast<int>(fours.size())); }
        template <class BoxOf>
        void fit(int cluster, const BoxOf& boxOf);
        template <class Visit>
        void forMeeting(int cluster, const SweptBox& box, std::initializer_list<int> without, const Visit& visit) const;
        [[nodiscard]] std::size_t bytes() const;
    };

    using EdgesByCorners = std::map<std::array<int, 2>, int>;
    EdgesByCorners findEdges();
    void shareOut(EdgesByCorners edges);
    void beginSearch(double reach, std::span<const char> flagged = {});
    void fit(Team* team);
    [[nodiscard]] SweptBox boxOfEdge(int edge) const;
    [[nodiscard]] SweptBox boxOfTriangle(int triangle) const;
    template <class Keep>
    void visitElements(const ClusterTree::Pair& clusters, const Keep& keep) const;
    template <class DistanceIfNear>
    Pairs collect(std::size_t most, Team* team, std::span<const char> flagged, const DistanceIfNear& distanceIfNear);

    std::vector<geometry::TriangleIndices> triangles_;
    std::vector<SurfaceEdge> edges_;
    std::vector<SweptBox> vertexBoxes_;
    ClusterTree tree_;
    Elements<1> clusterCorners_;
    Elements<2> clusterEdges_;
    Elements<3> clusterTriangles_;
    static constexpr double noWays = -1;
    double reach_ = noWays; ///< of the last search, if its boxes are round ways [m]
};

} // namespace toile::collision
