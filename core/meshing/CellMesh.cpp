// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/meshing/CellMesh.h"

#include <algorithm>

namespace toile::meshing {
namespace {

std::size_t at(int i) {
    return static_cast<std::size_t>(i);
}

/// A directed edge of a cell; two cells share it when it appears both ways.
struct HalfEdge {
    int low, high;
    bool rising; ///< the cell walks low → high
    friend auto operator<=>(const HalfEdge&, const HalfEdge&) = default;
};

class Collector {
public:
    Collector(const BoundaryNodes& boundary, const Lattice& lattice, const GridFill& fill, CellMesh& mesh)
        : boundary_(boundary), lattice_(lattice), fill_(fill), mesh_(mesh) {}

    void run() {
        for (int row = 0; row < lattice_.rows(); ++row)
            for (int column = 0; column < lattice_.columns(); ++column)
                for (int u = lattice_.activeDivision(column, row), b = 0; b < u; ++b)
                    for (int a = 0; a < u; ++a)
                        if (filled(column, row, a, b)) addCell(column, row, a, b, u);
        addWalls();
    }

private:
    [[nodiscard]] bool filled(int column, int row, int a, int b) const {
        return fill_.filled[at(lattice_.firstCell(column, row) + b * lattice_.divisionOf(column, row) + a)];
    }

    [[nodiscard]] int nodeAt(int column, int row, int a, int b) const {
        return fill_.node[at(lattice_.nodeAt(column, row, a, b))];
    }

    void addCell(int column, int row, int a, int b, int u) {
        Cell cell{{nodeAt(column, row, a, b), nodeAt(column, row, a + 1, b),
                   nodeAt(column, row, a + 1, b + 1), nodeAt(column, row, a, b + 1)},
                  {},
                  lattice_.region[at(lattice_.cell(column, row))],
                  lattice_.firstCell(column, row) + b * u + a};
        if (b == 0) cell.hanging[0] = between(true, column, row, a, u);
        if (a + 1 == u) cell.hanging[1] = between(false, column + 1, row, b, u);
        if (b + 1 == u) cell.hanging[2] = reversed(between(true, column, row + 1, a, u));
        if (a == 0) cell.hanging[3] = reversed(between(false, column, row, b, u));
        const std::array<bool, 4> shared{twin(column, row, a, b - 1, u), twin(column, row, a + 1, b, u),
                                         twin(column, row, a, b + 1, u), twin(column, row, a - 1, b, u)};
        for (int side = 0; side < 4; ++side)
            if (!shared[at(side)]) addSide(cell, side);
        mesh_.cells.push_back(std::move(cell));
    }

    static std::vector<int> reversed(std::vector<int> nodes) {
        std::reverse(nodes.begin(), nodes.end());
        return nodes;
    }

    /// The used nodes strictly inside part `part` of `parts` of a main side.
    [[nodiscard]] std::vector<int> between(bool horizontal, int column, int row, int part, int parts) const {
        const int u =
            horizontal ? lattice_.horizontalDivision(column, row) : lattice_.verticalDivision(column, row);
        std::vector<int> nodes;
        for (int k = part * (u / parts) + 1; k < (part + 1) * (u / parts); ++k) {
            const int node = fill_.node[at(horizontal ? lattice_.horizontalNode(column, row, k)
                                                      : lattice_.verticalNode(column, row, k))];
            if (node >= 0) nodes.push_back(node);
        }
        return nodes;
    }

    /// The cell beside is filled and of the same division, so that the whole side is shared.
    [[nodiscard]] bool twin(int column, int row, int a, int b, int u) const {
        if (a < 0)
            --column, a = u - 1;
        else if (a == u)
            ++column, a = 0;
        if (b < 0)
            --row, b = u - 1;
        else if (b == u)
            ++row, b = 0;
        return lattice_.activeDivision(column, row) == u && filled(column, row, a, b);
    }

    void addSide(const Cell& cell, int side) {
        int from = cell.corners[at(side)];
        const auto add = [&](int to) {
            open_.push_back({std::min(from, to), std::max(from, to), from < to});
            from = to;
        };
        for (const int node : cell.hanging[at(side)]) add(node);
        add(cell.corners[at((side + 1) % 4)]);
    }

    /// The sides that belong to one cell only, unless they are the piece's border; and the border that is no
    /// side.
    void addWalls() {
        std::sort(open_.begin(), open_.end());
        const auto isSide = [&](int from, int to) {
            return std::binary_search(open_.begin(), open_.end(),
                                      HalfEdge{std::min(from, to), std::max(from, to), from < to});
        };
        std::vector<int> after(boundary_.grid.size(), -1);
        for (const auto& ring : boundary_.rings)
            for (std::size_t i = 0; i < ring.size(); ++i) {
                const int a = ring[i], b = ring[(i + 1) % ring.size()];
                after[at(a)] = b;
                if (!isSide(a, b)) mesh_.walls.push_back({a, b, true});
            }
        for (const HalfEdge& edge : open_) {
            const int from = edge.rising ? edge.low : edge.high, to = edge.rising ? edge.high : edge.low;
            if (isSide(to, from)) continue;
            if (from < mesh_.boundaryCount && after[at(from)] == to) continue;
            mesh_.walls.push_back({to, from, true});
        }
    }

    const BoundaryNodes& boundary_;
    const Lattice& lattice_;
    const GridFill& fill_;
    CellMesh& mesh_;
    std::vector<HalfEdge> open_;
};

} // namespace

CellMesh cellMesh(const PieceFrame& frame, const BoundaryNodes& boundary, const Lattice& lattice,
                  const GridFill& fill) {
    CellMesh mesh;
    mesh.boundaryCount = static_cast<int>(boundary.points.size());
    for (const Vec2 point : boundary.points) mesh.position.push_back(frame.frameOf(point));
    for (const auto& [node, place] : fill.aligned) mesh.position[at(node)] = place;
    mesh.position.insert(mesh.position.end(), fill.inner.begin(), fill.inner.end());
    mesh.grid = boundary.grid;
    mesh.grid.insert(mesh.grid.end(), fill.innerGrid.begin(), fill.innerGrid.end());
    Collector(boundary, lattice, fill, mesh).run();
    return mesh;
}

void triangulateStrip(const Lattice& lattice, CellMesh& mesh) {
    std::vector<char> enclosed(mesh.grid.size(), 0); // a corner of cells and of no wall: nothing to do there
    for (const Cell& cell : mesh.cells) {
        for (const int corner : cell.corners) enclosed[at(corner)] = 1;
        for (const auto& side : cell.hanging)
            for (const int node : side) enclosed[at(node)] = 1;
    }
    for (const Constraint& wall : mesh.walls) enclosed[at(wall.from)] = enclosed[at(wall.to)] = 0;
    std::vector<int> stripNodes, local(mesh.grid.size(), -1);
    std::vector<GridPoint> points;
    for (std::size_t node = 0; node < mesh.grid.size(); ++node)
        if (!enclosed[node]) {
            local[node] = static_cast<int>(points.size());
            points.push_back(mesh.grid[node]);
            stripNodes.push_back(static_cast<int>(node));
        }
    std::vector<Constraint> walls;
    for (const Constraint& wall : mesh.walls)
        walls.push_back({local[at(wall.from)], local[at(wall.to)], wall.fillLeft});
    mesh.triangles.clear();
    for (const auto& corners : constrainedDelaunay(points, walls)) {
        Triangle triangle;
        Vec2 middle;
        for (std::size_t i = 0; i < 3; ++i) {
            triangle.nodes[i] = stripNodes[at(corners[i])];
            middle += mesh.position[at(triangle.nodes[i])] / 3.0;
        }
        triangle.region =
            lattice.region[at(lattice.cell(lattice.columnOf(middle.x), lattice.rowOf(middle.y)))];
        mesh.triangles.push_back(triangle);
    }
}

} // namespace toile::meshing
