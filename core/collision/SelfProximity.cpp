// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/collision/SelfProximity.h"

#include "core/base/Contracts.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <limits>
#include <map>
#include <numeric>

namespace toile::collision {
namespace {

Vec3 lower(const Vec3& a, const Vec3& b) {
    return {std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)};
}
Vec3 higher(const Vec3& a, const Vec3& b) {
    return {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)};
}

template <class Corners>
bool has(const Corners& corners, int vertex) {
    return std::ranges::find(corners, vertex) != corners.end();
}

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

} // namespace

SelfProximity::SelfProximity(std::vector<geometry::TriangleIndices> triangles, std::span<const Vec3> positions)
    : triangles_(std::move(triangles)), represented_(triangles_.size()), vertexBoxes_(positions.size()) {
    findEdges();
    if (triangles_.empty()) return;
    std::vector<Vec3> centres;
    for (const auto& [a, b, c] : triangles_) {
        expects(a != b && b != c && c != a, "a triangle has three corners");
        centres.push_back((positions[a] + positions[b] + positions[c]) / 3);
    }
    std::vector<int> order(triangles_.size());
    std::iota(order.begin(), order.end(), 0);
    nodes_.reserve(2 * order.size());
    build(order, centres);
    nodeBoxes_.resize(nodes_.size());
}

void SelfProximity::findEdges() {
    std::map<std::array<int, 2>, int> known;
    std::vector<char> spokenFor(vertexBoxes_.size(), 0);
    for (std::size_t t = 0; t < triangles_.size(); ++t)
        for (int k = 0; k < 3; ++k) {
            const int a = triangles_[t][k], b = triangles_[t][(k + 1) % 3], across = triangles_[t][(k + 2) % 3];
            if (!spokenFor[a]++) represented_[t].corners[k] = a;
            const auto [at, isNew] =
                known.try_emplace({std::min(a, b), std::max(a, b)}, static_cast<int>(edges_.size()));
            if (isNew) {
                represented_[t].edges[k] = at->second;
                edges_.push_back({at->first, {across, -1}});
            } else {
                edges_[at->second].opposite[1] = across;
            }
        }
}

/// Halves the triangles along the longest axis of their centres; returns the node made.
int SelfProximity::build(std::span<int> triangles, std::span<const Vec3> centres) {
    const int node = static_cast<int>(nodes_.size());
    nodes_.push_back({});
    if (triangles.size() == 1) {
        nodes_[node].triangle = triangles[0];
        return node;
    }
    Vec3 low = centres[triangles[0]], high = low;
    for (const int t : triangles) {
        low = lower(low, centres[t]);
        high = higher(high, centres[t]);
    }
    const Vec3 extent = high - low;
    const int axis = extent.x >= extent.y && extent.x >= extent.z ? 0 : extent.y >= extent.z ? 1 : 2;
    const std::size_t half = triangles.size() / 2;
    std::ranges::nth_element(triangles, triangles.begin() + static_cast<std::ptrdiff_t>(half), [&](int s, int t) {
        return std::pair(centres[s][axis], s) < std::pair(centres[t][axis], t);
    });
    build(triangles.first(half), centres);
    const int second = build(triangles.subspan(half), centres);
    nodes_[node].second = second;
    return node;
}

/// Boxes round those of the vertices; where some are flagged, those that hold one of them.
void SelfProximity::fitNodes() {
    for (std::size_t n = nodes_.size(); n-- > 0;) {
        if (!flagged_.empty() && !flagged_[n]) continue;
        const Node& node = nodes_[n];
        if (node.second >= 0) {
            nodeBoxes_[n] = around(nodeBoxes_[n + 1], nodeBoxes_[node.second]);
        } else {
            const auto& [a, b, c] = triangles_[node.triangle];
            nodeBoxes_[n] = around(around(vertexBoxes_[a], vertexBoxes_[b]), vertexBoxes_[c]);
        }
    }
}

/// Finds the nodes that have a flagged vertex below them. Where none is flagged all vertices count.
void SelfProximity::beginSearch(double reach, std::span<const char> flagged) {
    reach_ = reach;
    flagged_.assign(flagged.empty() ? 0 : nodes_.size(), 0);
    for (std::size_t n = flagged_.size(); n-- > 0;) {
        const Node& node = nodes_[n];
        if (node.second >= 0) {
            flagged_[n] = flagged_[n + 1] || flagged_[node.second];
        } else {
            const auto& [a, b, c] = triangles_[node.triangle];
            flagged_[n] = flagged[a] || flagged[b] || flagged[c];
        }
    }
}

bool SelfProximity::areLeaves(const NodePair& pair) const {
    return pair.first != pair.second && nodes_[pair.first].second < 0 && nodes_[pair.second].second < 0;
}

bool SelfProximity::areNear(int first, int second) const {
    return meet(nodeBoxes_[first], nodeBoxes_[second]) && (flagged_.empty() || flagged_[first] || flagged_[second]);
}

/// What is below two nodes that are no leaves, and near each other; the last is visited first. Triangles lie at most 29
/// nodes deep, and a way takes two bits for each.
void SelfProximity::appendBelow(const NodePair& pair, std::vector<NodePair>& todo) const {
    const auto [a, b, left, way] = pair;
    const Node &first = nodes_[a], &second = nodes_[b];
    const auto append = [&, left = left, way = way](int one, int other, int bits, std::uint64_t turn) {
        if (one == other ? flagged_.empty() || flagged_[one] : areNear(one, other))
            todo.push_back({one, other, left - bits, way | turn << (left - bits)});
    };
    if (a == b) {
        if (first.second < 0) return;
        append(first.second, first.second, 2, 2);
        append(a + 1, a + 1, 2, 1);
        append(a + 1, first.second, 2, 0);
    } else if (second.second < 0 || (first.second >= 0 && first.second - a >= second.second - b)) {
        append(a + 1, b, 1, 1);
        append(first.second, b, 1, 0);
    } else {
        append(a, b + 1, 1, 1);
        append(a, second.second, 1, 0);
    }
}

/// visit(leaves) once for every two leaves below these nodes whose boxes meet, until it returns false.
template <class Visit>
void SelfProximity::forNearTriangles(const NodePair& from, const Visit& visit) const {
    std::vector<NodePair> todo{from};
    while (!todo.empty()) {
        const NodePair pair = todo.back();
        todo.pop_back();
        if (!areLeaves(pair)) appendBelow(pair, todo);
        else if (!visit(pair)) return;
    }
}

/// Pairs of nodes, some `count` of them, below which all near leaves are found, in the order of a search from the root.
std::vector<SelfProximity::NodePair> SelfProximity::sharesOfSearch(std::size_t count) const {
    if (nodes_.empty()) return {};
    std::vector<NodePair> shares{NodePair{}}, next, below;
    while (shares.size() < count && shares != next) {
        next = std::move(shares);
        shares.clear();
        for (const NodePair& pair : next) {
            below.clear();
            if (areLeaves(pair)) below.push_back(pair);
            else appendBelow(pair, below);
            shares.insert(shares.end(), below.rbegin(), below.rend());
        }
    }
    return shares;
}

SelfProximity::Pairs SelfProximity::pairsWithin(double reach, std::span<const Vec3> positions, std::size_t most) {
    for (std::size_t v = 0; v < vertexBoxes_.size(); ++v) vertexBoxes_[v] = {{positions[v], positions[v]}, 0.5 * reach};
    beginSearch(noWays);
    return collect(positions, most, nullptr, {},
                   [&](const ElementPair&, const Separation& at) { return at.distance <= reach; });
}

/// The gap along a direction that stays the same is a concave function of the time, so that between two ends it is not
/// less than at both.
SelfProximity::Pairs SelfProximity::pairsInStep(double reach, std::span<const Vec3> positions,
                                                std::span<const Vec3> moves, std::size_t most, Team* team) {
    beginSearch(reach);
    std::vector<Vec3> ends(positions.size());
    for (std::size_t v = 0; v < ends.size(); ++v) {
        ends[v] = positions[v] + moves[v];
        vertexBoxes_[v] = {{positions[v], positions[v]}, 0.5 * reach, moves[v]};
    }
    return collect(positions, most, team, {}, [&](const ElementPair& pair, const Separation& start) {
        if (start.distance <= reach) return true;
        const Vec3 direction = start.way / start.distance;
        return gapAlong(direction, pair, positions) <= reach || gapAlong(direction, pair, ends) <= reach;
    });
}

SelfProximity::Pairs SelfProximity::pairsInBoxes(double reach, std::span<const Vec3> positions,
                                                 std::span<const geometry::Box3> boxes, std::size_t most, Team* team) {
    for (std::size_t v = 0; v < vertexBoxes_.size(); ++v)
        vertexBoxes_[v] = {{positions[v] + boxes[v].low, positions[v] + boxes[v].high}, 0.5 * reach};
    beginSearch(reach);
    return collect(positions, most, team, {}, [&](const ElementPair& pair, const Separation& start) {
        return start.distance <= reach || leastGapAlong(start.way / start.distance, pair, positions, boxes) <= reach;
    });
}

SelfProximity::Pairs SelfProximity::pairsOfFlagged(std::span<const char> flagged, std::span<const Vec3> positions,
                                                   std::span<const Vec3> moves, std::size_t most, Team* team) {
    expects(reach_ >= 0, "a search along ways came before");
    beginSearch(reach_, flagged);
    for (std::size_t v = 0; v < vertexBoxes_.size(); ++v)
        if (flagged[v]) vertexBoxes_[v] = {{positions[v], positions[v]}, 0.5 * reach_, moves[v]};
    return collect(positions, most, team, flagged, [&](const ElementPair& pair, const Separation& start) {
        if (start.distance <= reach_) return true;
        const Vec3 direction = start.way / start.distance;
        std::array<Vec3, 4> ends;
        for (int i = 0; i < 4; ++i) ends[i] = positions[pair.vertices[i]] + moves[pair.vertices[i]];
        return gapAlong(direction, pair, positions) <= reach_ ||
               gapAlong(direction, {{0, 1, 2, 3}, pair.firstCount}, ends) <= reach_;
    });
}

/// keep(pair, number) for the pairs of elements that two triangles speak for and whose boxes meet; numbers rise, up
/// to 15.
template <class Keep>
void SelfProximity::visitElements(const NodePair& leaves, const Keep& keep) const {
    const auto cornersAgainst = [&](int speaker, int node, int number) {
        const auto& corners = triangles_[nodes_[node].triangle];
        for (int k = 0; k < 3; ++k)
            if (const int v = represented_[speaker].corners[k];
                v >= 0 && meet(vertexBoxes_[v], nodeBoxes_[node]) && !has(corners, v))
                keep({{v, corners[0], corners[1], corners[2]}, 1}, number + k);
    };
    const auto boxOf = [&](const std::array<int, 2>& edge) {
        return around(vertexBoxes_[edge[0]], vertexBoxes_[edge[1]]);
    };
    const int a = leaves.first, b = leaves.second;
    const int first = nodes_[a].triangle, second = nodes_[b].triangle;
    cornersAgainst(first, b, 0);
    cornersAgainst(second, a, 3);
    for (int i = 0; i < 3; ++i) {
        const int e = represented_[first].edges[i];
        if (e < 0) continue;
        const auto& edge = edges_[e].vertices;
        const SweptBox box = boxOf(edge);
        if (!meet(box, nodeBoxes_[b])) continue;
        for (int k = 0; k < 3; ++k) {
            const int f = represented_[second].edges[k];
            if (f < 0) continue;
            const auto& other = edges_[f].vertices;
            if (!has(other, edge[0]) && !has(other, edge[1]) && meet(box, boxOf(other)))
                keep({{edge[0], edge[1], other[0], other[1]}, 2}, 6 + 3 * i + k);
        }
    }
}

/// The pairs whose boxes meet and of which mayMeet(pair, separation) says so; those with a flagged vertex, if any is.
template <class MayMeet>
SelfProximity::Pairs SelfProximity::collect(std::span<const Vec3> positions, std::size_t most, Team* team,
                                            std::span<const char> flagged, const MayMeet& mayMeet) {
    constexpr std::size_t wanted = 64; ///< many more than threads, for they take unequal times
    fitNodes();
    const std::vector<NodePair> shares = sharesOfSearch(team && team->members() > 1 ? wanted : 1);
    std::vector<std::vector<Near>> found(shares.size());
    std::atomic<std::size_t> count{0}; // in all shares: none goes on when together they have too many
    const auto search = [&](int s) {
        forNearTriangles(shares[s], [&](const NodePair& leaves) {
            const std::size_t before = found[s].size();
            visitElements(leaves, [&](const ElementPair& pair, int number) {
                if (!flagged.empty() && std::ranges::none_of(pair.vertices, [&](int v) { return flagged[v]; })) return;
                const Separation separation = separationOf(pair, positions);
                if (mayMeet(pair, separation))
                    found[s].push_back({pair, separation.distance, leaves.way | static_cast<std::uint64_t>(number)});
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
    fitNodes();
    std::vector<Piercing> found;
    const auto edgesAgainst = [&](int speaker, int triangle) {
        const auto& corners = triangles_[triangle];
        for (const int e : represented_[speaker].edges) {
            if (e < 0) continue;
            const auto [p, q] = edges_[e].vertices;
            if (!has(corners, p) && !has(corners, q) &&
                segmentPierces(positions[p], positions[q], positions[corners[0]], positions[corners[1]],
                               positions[corners[2]]))
                found.push_back({e, triangle});
        }
    };
    for (const NodePair& whole : sharesOfSearch(1))
        forNearTriangles(whole, [&](const NodePair& leaves) {
            const int first = nodes_[leaves.first].triangle, second = nodes_[leaves.second].triangle;
            edgesAgainst(first, second);
            edgesAgainst(second, first);
            return true;
        });
    std::ranges::sort(found);
    return found;
}

std::size_t SelfProximity::bytes() const {
    return triangles_.capacity() * sizeof(geometry::TriangleIndices) + edges_.capacity() * sizeof(SurfaceEdge) +
           represented_.capacity() * sizeof(Represented) + nodes_.capacity() * sizeof(Node) +
           (vertexBoxes_.capacity() + nodeBoxes_.capacity()) * sizeof(SweptBox) + flagged_.capacity();
}

} // namespace toile::collision
