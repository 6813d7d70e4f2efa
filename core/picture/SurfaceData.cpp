// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/picture/SurfaceData.h"

#include "core/base/UnionFind.h"
#include "core/picture/Cavity.h"

#include <algorithm>
#include <set>

namespace toile::picture {

namespace {

constexpr std::array<Colour, 6> regionTints{{{0.95f, 0.55f, 0.35f},
                                             {0.40f, 0.72f, 0.45f},
                                             {0.62f, 0.47f, 0.80f},
                                             {0.93f, 0.77f, 0.32f},
                                             {0.30f, 0.68f, 0.78f},
                                             {0.88f, 0.48f, 0.66f}}};

Colour mixed(Colour a, Colour b, float t) {
    return {a.r + (b.r - a.r) * t, a.g + (b.g - a.g) * t, a.b + (b.b - a.b) * t, a.a};
}

std::uint8_t asByte(float x) {
    return static_cast<std::uint8_t>(std::clamp(x, 0.0f, 1.0f) * 255 + 0.5f);
}

std::array<int, 2> ordered(int a, int b) {
    return {std::min(a, b), std::max(a, b)};
}

std::array<float, 3> asFloats(const Vec3& v) {
    return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

/// For each vertex one that stands for all that are sewn to it.
std::vector<int> sewnPoints(const std::vector<Vec3>& places, const std::vector<Vec3>& normals,
                            const std::vector<std::vector<std::array<int, 2>>>& seams) {
    UnionFind sewn(places.size());
    for (const auto& pairs : seams)
        for (const auto& [a, b] : pairs)
            if (places[a] == places[b] && dot(normals[a], normals[b]) > 0) sewn.join(a, b);
    std::vector<int> point(places.size());
    for (std::size_t i = 0; i < point.size(); ++i) point[i] = sewn.rootOf(static_cast<int>(i));
    return point;
}

} // namespace

std::vector<SurfaceVertex> surfaceVertices(const std::vector<Vec3>& positions,
                                           const std::vector<geometry::TriangleIndices>& triangles,
                                           const std::vector<std::vector<std::array<int, 2>>>& seams) {
    geometry::TriangleMesh surface{positions, triangles};
    for (Vec3& place : surface.vertices)
        if (!isFinite(place)) place = {};
    const std::vector<int> point = sewnPoints(surface.vertices, geometry::vertexNormals(surface), seams);
    for (geometry::TriangleIndices& corners : surface.triangles)
        for (int& corner : corners) corner = point[corner];
    const std::vector<Vec3> normals = geometry::vertexNormals(surface);
    const std::vector<double> hollow = cavities(surface.vertices, normals, surface.triangles);
    std::vector<SurfaceVertex> vertices(positions.size());
    for (std::size_t i = 0; i < vertices.size(); ++i)
        vertices[i] = {asFloats(surface.vertices[i]), asFloats(normals[point[i]]),
                       static_cast<float>(hollow[point[i]])};
    return vertices;
}

std::vector<std::array<std::uint8_t, 4>> triangleColours(const RenderScene& scene,
                                                         const simulation::FrameTopology& topology) {
    std::vector<std::array<std::uint8_t, 4>> colours(topology.triangles.size());
    for (const auto& piece : topology.pieces) {
        const auto own = scene.pieceColours.find(piece.id);
        const Colour fabric = own == scene.pieceColours.end() ? defaultFabricColour : own->second;
        const bool selected = !scene.selectedPiece.empty() && piece.id == scene.selectedPiece;
        const auto kind =
            static_cast<std::uint8_t>(selected ? (piece.rightSidesOnly ? 0 : 96) : (piece.rightSidesOnly ? 160 : 255));
        for (int t = piece.firstTriangle; t < piece.firstTriangle + piece.triangleCount; ++t) {
            const auto i = static_cast<std::size_t>(t);
            const int region =
                scene.options.regions && i < topology.triangleRegion.size() ? topology.triangleRegion[i] : -1;
            const Colour c =
                region < 0 ? fabric
                           : mixed(fabric, regionTints[static_cast<std::size_t>(region) % regionTints.size()], 0.55f);
            colours[i] = {asByte(c.r), asByte(c.g), asByte(c.b), kind};
        }
    }
    return colours;
}

std::vector<SeamLines> seamLines(const simulation::FrameTopology& topology) {
    std::set<std::array<int, 2>> edges;
    if (!topology.seams.empty())
        for (const auto& [a, b, c] : topology.triangles) edges.insert({ordered(a, b), ordered(b, c), ordered(c, a)});
    std::vector<SeamLines> lines;
    for (const auto& pairs : topology.seams) {
        SeamLines seam;
        for (std::size_t i = 0; i < pairs.size(); ++i) {
            seam.across.push_back(pairs[i]);
            for (std::size_t side = 0; i > 0 && side < 2; ++side) {
                const std::array<int, 2> step{pairs[i - 1][side], pairs[i][side]};
                if (edges.contains(ordered(step[0], step[1]))) seam.along.push_back(step);
            }
        }
        lines.push_back(std::move(seam));
    }
    return lines;
}

std::vector<std::vector<std::array<int, 2>>> pieceBorders(const simulation::FrameTopology& topology) {
    std::vector<std::vector<std::array<int, 2>>> borders;
    for (const auto& piece : topology.pieces) {
        std::set<std::array<int, 2>> seenOnce;
        const auto first = topology.triangles.begin() + piece.firstTriangle;
        for (auto t = first; t != first + piece.triangleCount; ++t)
            for (const auto& edge : {ordered((*t)[0], (*t)[1]), ordered((*t)[1], (*t)[2]), ordered((*t)[2], (*t)[0])})
                if (!seenOnce.insert(edge).second) seenOnce.erase(edge);
        borders.emplace_back(seenOnce.begin(), seenOnce.end());
    }
    return borders;
}

} // namespace toile::picture
