// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/meshing/DisplayElements.h"
#include "core/base/Index.h"

#include <algorithm>

namespace toile::meshing {
namespace {

/// Whether the triangle is cut from the rectangle: two rectangles share a side at most.
bool isPartOf(const PieceMesh& mesh, const Rectangle& cell, const std::array<int, 3>& triangle) {
    const Vec2 low = mesh.material[at(cell.nodes[0])], high = mesh.material[at(cell.nodes[2])];
    const Vec2 rounding = 1e-9 * (high - low);
    return std::all_of(triangle.begin(), triangle.end(), [&](int node) {
        const Vec2 p = mesh.material[at(node)];
        return p.x >= low.x - rounding.x && p.x <= high.x + rounding.x && p.y >= low.y - rounding.y &&
               p.y <= high.y + rounding.y;
    });
}

} // namespace

std::vector<int> displayElements(const PieceMesh& mesh) {
    // Display triangles come in the order of the rectangles, then of the triangles.
    std::vector<int> elements;
    elements.reserve(mesh.display.size());
    const std::size_t ofRectangles = mesh.display.size() - mesh.triangles.size();
    std::size_t cell = 0;
    for (std::size_t i = 0; i < ofRectangles; ++i) {
        while (cell + 1 < mesh.rectangles.size() && !isPartOf(mesh, mesh.rectangles[cell], mesh.display[i])) ++cell;
        elements.push_back(static_cast<int>(cell));
    }
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        elements.push_back(static_cast<int>(mesh.rectangles.size() + t));
    return elements;
}

int regionOf(const PieceMesh& mesh, int element) {
    const auto rectangles = static_cast<int>(mesh.rectangles.size());
    return element < rectangles ? mesh.rectangles[at(element)].region : mesh.triangles[at(element - rectangles)].region;
}

} // namespace toile::meshing
