// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/ClothParts.h"

#include "core/collision/SelfProximity.h"

#include <algorithm>
#include <map>

namespace toile::simulation {
namespace {

using geometry::TriangleIndices;
using TrianglesAtEdges = std::map<std::array<int, 2>, std::vector<int>>; ///< edges by their corners, rising

/// The triangles at each edge, whichever way they run through it.
TrianglesAtEdges trianglesAtEdges(std::span<const TriangleIndices> triangles) {
    TrianglesAtEdges at;
    for (std::size_t t = 0; t < triangles.size(); ++t)
        for (std::size_t i = 0; i < 3; ++i) {
            const auto [low, high] = std::minmax(triangles[t][i], triangles[t][(i + 1) % 3]);
            at[{low, high}].push_back(static_cast<int>(t));
        }
    return at;
}

/// The triangles beside each triangle.
std::vector<std::vector<int>> neighboursOf(std::span<const TriangleIndices> triangles) {
    std::vector<std::vector<int>> beside(triangles.size());
    for (const auto& [edge, sharing] : trianglesAtEdges(triangles))
        for (const int a : sharing)
            for (const int b : sharing)
                if (a != b) beside[a].push_back(b);
    return beside;
}

/// Every triangle that can be reached from one over edges, in the order in which they are, each with the one it was
/// reached from; −1 for the first.
std::vector<std::array<int, 2>> reachedFrom(int first, const std::vector<std::vector<int>>& beside,
                                            std::vector<bool>& seen) {
    std::vector<std::array<int, 2>> reached{{first, -1}};
    seen[first] = true;
    for (std::size_t i = 0; i < reached.size(); ++i)
        for (const int neighbour : beside[reached[i][0]])
            if (!seen[neighbour]) {
                seen[neighbour] = true;
                reached.push_back({neighbour, reached[i][0]});
            }
    return reached;
}

/// All triangles, those together that can be reached from one another.
std::vector<std::vector<int>> hangingTogether(const std::vector<std::vector<int>>& beside) {
    std::vector<bool> seen(beside.size(), false);
    std::vector<std::vector<int>> groups;
    for (int t = 0; t < static_cast<int>(beside.size()); ++t) {
        if (seen[t]) continue;
        std::vector<int>& group = groups.emplace_back();
        for (const auto& [triangle, from] : reachedFrom(t, beside, seen)) group.push_back(triangle);
    }
    return groups;
}

bool runsThrough(const TriangleIndices& triangle, int from, int to) {
    return (triangle[0] == from && triangle[1] == to) || (triangle[1] == from && triangle[2] == to) ||
           (triangle[2] == from && triangle[0] == to);
}

/// Whether two neighbours run through an edge of both in the same direction.
bool runAlike(const TriangleIndices& a, const TriangleIndices& b) {
    return runsThrough(b, a[0], a[1]) || runsThrough(b, a[1], a[2]) || runsThrough(b, a[2], a[0]);
}

/// The triangles that pass through others or that others pass through, those at the edges that do so included.
std::vector<bool> piercedIn(const geometry::TriangleMesh& mesh, const TrianglesAtEdges& atEdges) {
    std::vector<bool> pierced(mesh.triangles.size(), false);
    collision::SelfProximity proximity(mesh.triangles, mesh.vertices);
    for (const auto& [edge, triangle] : proximity.piercings(mesh.vertices)) {
        pierced[triangle] = true;
        for (const int beside : atEdges.at(proximity.edges()[edge].vertices)) pierced[beside] = true;
    }
    return pierced;
}

} // namespace

std::vector<ClothPart> partsOf(std::span<const TriangleIndices> triangles) {
    std::vector<TriangleIndices> sound;
    std::ranges::copy_if(triangles, std::back_inserter(sound),
                         [](const auto& t) { return t[0] != t[1] && t[1] != t[2] && t[2] != t[0]; });
    std::vector<ClothPart> parts;
    for (const std::vector<int>& group : hangingTogether(neighboursOf(sound))) {
        ClothPart& part = parts.emplace_back();
        for (const int triangle : group) part.push_back(sound[triangle]);
    }
    return parts;
}

std::vector<bool> turnedAgainstFirst(const ClothPart& part) {
    std::vector<bool> turned(part.size(), false), seen(part.size(), false);
    for (const auto& [triangle, from] : reachedFrom(0, neighboursOf(part), seen))
        if (from >= 0) turned[triangle] = turned[from] != runAlike(part[triangle], part[from]);
    return turned;
}

std::vector<std::vector<int>> unpiercedRegions(const geometry::TriangleMesh& mesh) {
    const TrianglesAtEdges atEdges = trianglesAtEdges(mesh.triangles);
    const std::vector<bool> pierced = piercedIn(mesh, atEdges);
    std::vector<std::vector<int>> beside(mesh.triangles.size());
    for (const auto& [edge, sharing] : atEdges) {
        if (sharing.size() != 2 || pierced[sharing[0]] || pierced[sharing[1]]) continue;
        if (runAlike(mesh.triangles[sharing[0]], mesh.triangles[sharing[1]])) continue;
        beside[sharing[0]].push_back(sharing[1]);
        beside[sharing[1]].push_back(sharing[0]);
    }
    return hangingTogether(beside);
}

} // namespace toile::simulation
