// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/DrapeFaces.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace toile::io {
namespace {

using simulation::FrameTopology;
using NodePair = std::pair<int, int>;

NodePair edgeOf(int a, int b) {
    return std::minmax(a, b);
}

} // namespace

std::span<const geometry::TriangleIndices> trianglesOf(const FrameTopology& topology,
                                                       const FrameTopology::PieceRange& piece) {
    return std::span(topology.triangles).subspan(piece.firstTriangle, piece.triangleCount);
}

std::vector<Vec3> drapeNormals(const FrameTopology& topology, std::span<const Vec3> positions) {
    std::vector<Vec3> normals =
        geometry::vertexNormals({std::vector<Vec3>(positions.begin(), positions.end()), topology.triangles});
    for (Vec3& n : normals)
        if (n == Vec3{}) n = {0, 0, 1}; // a vertex without triangle: formats ask for unit length
    return normals;
}

std::vector<std::vector<int>> facesOf(const FrameTopology& topology, const FrameTopology::PieceRange& piece) {
    const auto triangles = trianglesOf(topology, piece);
    std::set<NodePair> lines;
    for (const auto& [a, b] : topology.meshLines) lines.insert(edgeOf(a, b));

    std::map<NodePair, int> open; // an edge that is no line, and the face whose last corner lies opposite to it
    std::vector<std::vector<int>> faces;
    for (const auto& t : triangles) {
        bool joined = false;
        for (int k = 0; k < 3 && !joined && !lines.empty(); ++k) {
            const auto other = open.find(edgeOf(t[k], t[(k + 1) % 3]));
            if (other == open.end() || faces[other->second].size() != 3) continue;
            std::vector<int>& face = faces[other->second];
            const auto at = std::ranges::find(face, t[(k + 1) % 3]); // the neighbour runs through the edge backward
            if (at == face.end()) continue;
            face.insert(at + 1, t[(k + 2) % 3]);
            joined = true;
        }
        if (joined) continue;
        for (int k = 0; k < 3; ++k)
            if (const NodePair edge = edgeOf(t[k], t[(k + 1) % 3]); !lines.contains(edge))
                open.emplace(edge, static_cast<int>(faces.size()));
        faces.push_back({t[0], t[1], t[2]});
    }
    return faces;
}

} // namespace toile::io
