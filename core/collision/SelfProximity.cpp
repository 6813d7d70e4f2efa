// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/collision/SelfProximity.h"

#include "core/base/Contracts.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <limits>
#include <utility>

namespace toile::collision {
namespace {

/// The least of what a point of the box has along a direction.
double leastAlong(const Vec3& direction, const geometry::Box3& box) {
    const auto least = [&](int axis) {
        return std::min(direction[axis] * box.low[axis], direction[axis] * box.high[axis]);
    };
    return least(0) + least(1) + least(2);
}

/// As gapAlong, while each vertex is anywhere in its box.
double leastGapAlong(const Vec3& direction, const ElementPair& pair, std::span<const Vec3> positions,
                     std::span<const geometry::Box3> boxes) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    double nearest = infinity, farthest = -infinity;
    for (int i = 0; i < 4; ++i) {
        const int v = pair.vertices[i];
        const double along = dot(direction, positions[v]);
        if (i < pair.firstCount) nearest = std::min(nearest, along + leastAlong(direction, boxes[v]));
        else farthest = std::max(farthest, along - leastAlong(-direction, boxes[v]));
    }
    return nearest - farthest;
}

/// The distance of a pair at first, if it can come nearer than `reach` while its vertices go by their moves.
///
/// The gap along a direction that stays the same is a concave function of the time, so that between two ends it is not
/// less than at both. That between the middles is asked first: of most pairs it tells without their shortest way.
std::optional<double> distanceInStep(double reach, const ElementPair& pair, std::span<const Vec3> positions,
                                     std::span<const Vec3> moves) {
    std::array<Vec3, 4> starts, ends;
    for (int i = 0; i < 4; ++i) {
        starts[i] = positions[pair.vertices[i]];
        ends[i] = starts[i] + moves[pair.vertices[i]];
    }
    const ElementPair here{{0, 1, 2, 3}, pair.firstCount};
    const auto isApart = [&](const Vec3& direction, double gap) {
        return gapAlong(direction, here, starts) > gap && gapAlong(direction, here, ends) > gap;
    };
    const Vec3 between = pair.firstCount == 1 ? 3 * starts[0] - starts[1] - starts[2] - starts[3]
                                              : starts[0] + starts[1] - starts[2] - starts[3];
    if (isApart(between, reach * length(between))) return std::nullopt;
    const Separation start = separationOf(here, starts);
    if (start.distance > reach && isApart(start.way / start.distance, reach)) return std::nullopt;
    return start.distance;
}

} // namespace

SelfProximity::SelfProximity(std::vector<geometry::TriangleIndices> triangles, std::span<const Vec3> positions)
    : triangles_(std::move(triangles)), vertexBoxes_(positions.size()), tree_(triangles_, positions) {
    for (const auto& [a, b, c] : triangles_) expects(a != b && b != c && c != a, "a triangle has three corners");
    shareOut(findEdges());
}

SelfProximity::EdgesByCorners SelfProximity::findEdges() {
    EdgesByCorners known;
    for (const auto& corners : triangles_)
        for (int k = 0; k < 3; ++k) {
            const int a = corners[k], b = corners[(k + 1) % 3], across = corners[(k + 2) % 3];
            const auto [at, isNew] =
                known.try_emplace({std::min(a, b), std::max(a, b)}, static_cast<int>(edges_.size()));
            if (isNew) edges_.push_back({at->first, {across, -1}});
            else edges_[at->second].opposite[1] = across;
        }
    return known;
}

/// Gives each corner and each of the edges to the first cluster that has it.
void SelfProximity::shareOut(EdgesByCorners edges) {
    std::vector<char> isGiven(vertexBoxes_.size(), 0);
    for (int cluster = 0; cluster < tree_.clusters(); ++cluster) {
        for (const int t : tree_.trianglesOf(cluster)) {
            clusterTriangles_.add(t, triangles_[t]);
            for (int k = 0; k < 3; ++k) {
                const int a = triangles_[t][k], b = triangles_[t][(k + 1) % 3];
                if (!std::exchange(isGiven[a], 1)) clusterCorners_.add(a, std::array{a});
                if (const auto edge = edges.extract({std::min(a, b), std::max(a, b)}))
                    clusterEdges_.add(edge.mapped(), edge.key());
            }
        }
        clusterTriangles_.endCluster();
        clusterCorners_.endCluster();
        clusterEdges_.endCluster();
    }
}

template <int corners>
void SelfProximity::Elements<corners>::add(int id, std::span<const int, corners> vertices) {
    if (static_cast<int>(fours.size()) == begin.back() || fours.back().ids[FourSweptBoxes::width - 1] >= 0)
        fours.emplace_back();
    Four& four = fours.back();
    int lane = 0;
    while (four.ids[lane] >= 0) ++lane;
    four.ids[lane] = id;
    for (int k = 0; k < corners; ++k) four.vertices[k][lane] = vertices[k];
}

template <int corners>
template <class BoxOf>
void SelfProximity::Elements<corners>::fit(int cluster, const BoxOf& boxOf) {
    for (int f = begin[cluster]; f < begin[cluster + 1]; ++f)
        for (int lane = 0; lane < FourSweptBoxes::width; ++lane)
            if (const int id = fours[f].ids[lane]; id >= 0) fours[f].boxes.set(lane, boxOf(id));
}

/// visit(i, id) for the elements of a cluster that have none of these vertices and whose boxes meet this one; i is
/// their number in it.
template <int corners>
template <class Visit>
void SelfProximity::Elements<corners>::forMeeting(int cluster, const SweptBox& box, std::initializer_list<int> without,
                                                  const Visit& visit) const {
    for (int f = begin[cluster]; f < begin[cluster + 1]; ++f) {
        const Four& four = fours[f];
        BoxFlags found = meeting(four.boxes, box);
        for (const int vertex : without)
            for (const BoxFlags& of : four.vertices) found &= of != vertex;
        for (unsigned lanes = bitsOf(found); lanes != 0; lanes &= lanes - 1) {
            const int lane = std::countr_zero(lanes);
            visit(FourSweptBoxes::width * (f - begin[cluster]) + lane, four.ids[lane]);
        }
    }
}

template <int corners>
std::size_t SelfProximity::Elements<corners>::bytes() const {
    return begin.capacity() * sizeof(int) + fours.capacity() * sizeof(Four);
}

SweptBox SelfProximity::boxOfEdge(int edge) const {
    const auto& [p, q] = edges_[edge].vertices;
    return around(vertexBoxes_[p], vertexBoxes_[q]);
}

SweptBox SelfProximity::boxOfTriangle(int triangle) const {
    const auto& [a, b, c] = triangles_[triangle];
    return around(around(vertexBoxes_[a], vertexBoxes_[b]), vertexBoxes_[c]);
}

/// Where no vertex is flagged all count; else clusters that have one that is.
void SelfProximity::beginSearch(double reach, std::span<const char> flagged) {
    reach_ = reach;
    if (flagged.empty()) return tree_.countAll();
    tree_.countOnly([&](int cluster) {
        return std::ranges::any_of(tree_.trianglesOf(cluster), [&](int t) {
            return std::ranges::any_of(triangles_[t], [&](int v) { return flagged[v] != 0; });
        });
    });
}

/// Boxes round those of the vertices.
void SelfProximity::fit(Team* team) {
    tree_.fit(team, [&](int cluster) {
        clusterCorners_.fit(cluster, [&](int v) { return vertexBoxes_[v]; });
        clusterEdges_.fit(cluster, [&](int e) { return boxOfEdge(e); });
        clusterTriangles_.fit(cluster, [&](int t) { return boxOfTriangle(t); });
        const auto triangles = tree_.trianglesOf(cluster);
        SweptBox box = boxOfTriangle(triangles.front());
        for (const int t : triangles.subspan(1)) box = around(box, boxOfTriangle(t));
        return box;
    });
}

SelfProximity::Pairs SelfProximity::pairsWithin(double reach, std::span<const Vec3> positions, std::size_t most) {
    for (std::size_t v = 0; v < vertexBoxes_.size(); ++v) vertexBoxes_[v] = {{positions[v], positions[v]}, 0.5 * reach};
    beginSearch(noWays);
    return collect(most, nullptr, {}, [&](const ElementPair& pair) {
        const double distance = separationOf(pair, positions).distance;
        return distance <= reach ? std::optional(distance) : std::nullopt;
    });
}

SelfProximity::Pairs SelfProximity::pairsInStep(double reach, std::span<const Vec3> positions,
                                                std::span<const Vec3> moves, std::size_t most, Team* team) {
    for (std::size_t v = 0; v < vertexBoxes_.size(); ++v)
        vertexBoxes_[v] = {{positions[v], positions[v]}, 0.5 * reach, moves[v]};
    beginSearch(reach);
    return collect(most, team, {},
                   [&](const ElementPair& pair) { return distanceInStep(reach, pair, positions, moves); });
}

SelfProximity::Pairs SelfProximity::pairsInBoxes(double reach, std::span<const Vec3> positions,
                                                 std::span<const geometry::Box3> boxes, std::size_t most, Team* team) {
    for (std::size_t v = 0; v < vertexBoxes_.size(); ++v)
        vertexBoxes_[v] = {{positions[v] + boxes[v].low, positions[v] + boxes[v].high}, 0.5 * reach};
    beginSearch(reach);
    return collect(most, team, {}, [&](const ElementPair& pair) -> std::optional<double> {
        const Separation start = separationOf(pair, positions);
        if (start.distance > reach && leastGapAlong(start.way / start.distance, pair, positions, boxes) > reach)
            return std::nullopt;
        return start.distance;
    });
}

SelfProximity::Pairs SelfProximity::pairsOfFlagged(std::span<const char> flagged, std::span<const Vec3> positions,
                                                   std::span<const Vec3> moves, std::size_t most, Team* team) {
    expects(reach_ >= 0, "a search along ways came before");
    for (std::size_t v = 0; v < vertexBoxes_.size(); ++v)
        if (flagged[v]) vertexBoxes_[v] = {{positions[v], positions[v]}, 0.5 * reach_, moves[v]};
    beginSearch(reach_, flagged);
    return collect(most, team, flagged,
                   [&](const ElementPair& pair) { return distanceInStep(reach_, pair, positions, moves); });
}

/// keep(pair, number) for the pairs of elements that two clusters have and whose boxes meet; numbers rise, up to 255.
template <class Keep>
void SelfProximity::visitElements(const ClusterTree::Pair& clusters, const Keep& keep) const {
    constexpr int most = 3 * ClusterTree::most; // corners, or edges, of a cluster
    const int a = tree_.clusterAt(clusters.first), b = tree_.clusterAt(clusters.second);
    const bool isOne = a == b;
    const auto cornersAgainst = [&](int speaker, int other, int otherNode, int number) {
        clusterCorners_.forMeeting(speaker, tree_.boxAt(otherNode), {}, [&](int i, int v) {
            clusterTriangles_.forMeeting(other, vertexBoxes_[v], {v}, [&](int k, int t) {
                const auto& corners = triangles_[t];
                keep({{v, corners[0], corners[1], corners[2]}, 1}, number + ClusterTree::most * i + k);
            });
        });
    };
    cornersAgainst(a, b, clusters.second, 0);
    if (!isOne) cornersAgainst(b, a, clusters.first, most * ClusterTree::most);
    clusterEdges_.forMeeting(a, tree_.boxAt(clusters.second), {}, [&](int i, int e) {
        const auto [p, q] = edges_[e].vertices;
        clusterEdges_.forMeeting(b, boxOfEdge(e), {p, q}, [&, p = p, q = q](int k, int f) {
            const auto& other = edges_[f].vertices;
            if (!isOne || i < k) keep({{p, q, other[0], other[1]}, 2}, 2 * most * ClusterTree::most + most * i + k);
        });
    });
}

/// The pairs whose boxes meet and of which distanceIfNear(pair) gives one; those with a flagged vertex, if any is.
template <class DistanceIfNear>
SelfProximity::Pairs SelfProximity::collect(std::size_t most, Team* team, std::span<const char> flagged,
                                            const DistanceIfNear& distanceIfNear) {
    constexpr std::size_t wanted = 64; ///< many more than threads, for they take unequal times
    fit(team);
    const std::vector<ClusterTree::Pair> shares = tree_.sharesOfSearch(team && team->members() > 1 ? wanted : 1);
    std::vector<std::vector<Near>> found(shares.size());
    std::atomic<std::size_t> count{0}; // in all shares: none goes on when together they have too many
    const auto search = [&](int s) {
        tree_.forNearClusters(shares[s], [&](const ClusterTree::Pair& clusters) {
            const std::size_t before = found[s].size();
            visitElements(clusters, [&](const ElementPair& pair, int number) {
                if (!flagged.empty() && std::ranges::none_of(pair.vertices, [&](int v) { return flagged[v]; })) return;
                if (const auto distance = distanceIfNear(pair))
                    found[s].push_back({pair, *distance, clusters.way | static_cast<std::uint64_t>(number)});
            });
            const std::size_t more = found[s].size() - before;
            return (more > 0 ? count.fetch_add(more, std::memory_order_relaxed) + more
                             : count.load(std::memory_order_relaxed)) <= most;
        });
    };
    if (team) team->run(static_cast<int>(shares.size()), search);
    else if (!shares.empty()) search(0);
    if (count > most) return std::nullopt;
    if (found.size() == 1) return std::move(found.front());
    std::vector<Near> all;
    all.reserve(count);
    for (const auto& share : found) all.insert(all.end(), share.begin(), share.end());
    return all;
}

std::vector<Piercing> SelfProximity::piercings(std::span<const Vec3> positions) {
    for (std::size_t v = 0; v < vertexBoxes_.size(); ++v) vertexBoxes_[v] = {{positions[v], positions[v]}, 0};
    beginSearch(noWays);
    fit(nullptr);
    std::vector<Piercing> found;
    const auto edgesAgainst = [&](int speaker, int other, int otherNode) {
        clusterEdges_.forMeeting(speaker, tree_.boxAt(otherNode), {}, [&](int, int e) {
            const auto [p, q] = edges_[e].vertices;
            clusterTriangles_.forMeeting(other, boxOfEdge(e), {p, q}, [&, p = p, q = q](int, int t) {
                const auto& corners = triangles_[t];
                if (segmentPierces(positions[p], positions[q], positions[corners[0]], positions[corners[1]],
                                   positions[corners[2]]))
                    found.push_back({e, t});
            });
        });
    };
    for (const ClusterTree::Pair& whole : tree_.sharesOfSearch(1))
        tree_.forNearClusters(whole, [&](const ClusterTree::Pair& clusters) {
            const int first = tree_.clusterAt(clusters.first), second = tree_.clusterAt(clusters.second);
            edgesAgainst(first, second, clusters.second);
            if (first != second) edgesAgainst(second, first, clusters.first);
            return true;
        });
    std::ranges::sort(found);
    return found;
}

std::size_t SelfProximity::bytes() const {
    return triangles_.capacity() * sizeof(geometry::TriangleIndices) + edges_.capacity() * sizeof(SurfaceEdge) +
           vertexBoxes_.capacity() * sizeof(SweptBox) + tree_.bytes() + clusterTriangles_.bytes() +
           clusterCorners_.bytes() + clusterEdges_.bytes();
}

} // namespace toile::collision
