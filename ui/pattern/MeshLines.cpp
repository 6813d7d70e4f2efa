// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pattern/MeshLines.h"

#include <algorithm>

namespace toile::ui {
namespace {

using Side = std::pair<int, int>;

Side side(int a, int b) {
    return {std::min(a, b), std::max(a, b)};
}

/// The side that two triangles share, or (−1, −1).
Side commonSide(const meshing::Triangle& a, const meshing::Triangle& b) {
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
            const Side mine = side(a.nodes[i], a.nodes[(i + 1) % 3]);
            if (mine == side(b.nodes[j], b.nodes[(j + 1) % 3])) return mine;
        }
    return {-1, -1};
}

std::vector<Side> sidesOf(const meshing::PieceMesh& mesh) {
    std::vector<Side> sides;
    for (const meshing::Rectangle& rectangle : mesh.rectangles)
        for (int i = 0; i < 4; ++i) sides.push_back(side(rectangle.nodes[i], rectangle.nodes[(i + 1) % 4]));
    for (const meshing::Triangle& triangle : mesh.triangles) {
        const Side hidden =
            triangle.mergedWith >= 0 ? commonSide(triangle, mesh.triangles[triangle.mergedWith]) : Side{-1, -1};
        for (int i = 0; i < 3; ++i)
            if (const Side s = side(triangle.nodes[i], triangle.nodes[(i + 1) % 3]); s != hidden) sides.push_back(s);
    }
    std::ranges::sort(sides);
    const auto rest = std::ranges::unique(sides);
    sides.erase(rest.begin(), rest.end());
    return sides;
}

PieceLines linesOf(const meshing::PieceMesh& mesh) {
    PieceLines result;
    double total = 0;
    for (const auto& [a, b] : sidesOf(mesh)) {
        result.lines.emplace_back(mesh.nodes[a].x, mesh.nodes[a].y, mesh.nodes[b].x, mesh.nodes[b].y);
        total += distance(mesh.nodes[a], mesh.nodes[b]);
    }
    if (!result.lines.empty()) result.spacing = total / static_cast<double>(result.lines.size());
    return result;
}

} // namespace

MeshLines meshLinesOf(const meshing::GarmentMesh& mesh) {
    MeshLines result;
    for (const meshing::PieceMesh& piece : mesh.pieces) result.push_back(linesOf(piece));
    return result;
}

} // namespace toile::ui
