// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/meshing/CellMesh.h"

#include "core/meshing/FlatTriangles.h"

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
    Collector(const BoundaryNodes& boundary, const Lattice& lattice, const GridFill& fill, CellLayer& layer)
        : boundary_(boundary), lattice_(lattice), fill_(fill), layer_(layer) {}

    void run() {
        layer_.held.assign(boundary_.points.size() + fill_.inner.size(), 0);
        if (lattice_.isUniform()) collectUniform();
        else collectDivided();
        addWalls();
        listStripNodes();
    }

private:
    void collectDivided() {
        for (int row = 0; row < lattice_.rows(); ++row)
            for (int column = 0; column < lattice_.columns(); ++column) {
                const int u = lattice_.activeDivision(column, row);
                if (u == 0) continue;
                const bool finerBeside =
                    lattice_.horizontalDivision(column, row) > u || lattice_.horizontalDivision(column, row + 1) > u ||
                    lattice_.verticalDivision(column, row) > u || lattice_.verticalDivision(column + 1, row) > u;
                for (int b = 0; b < u; ++b)
                    for (int a = 0; a < u; ++a)
                        if (filled(column, row, a, b)) addCell(column, row, a, b, u, finerBeside);
            }
    }

    /// The same without divisions: nothing hangs, and cells and nodes lie in rows.
    void collectUniform() {
        const int columns = lattice_.columns(), rows = lattice_.rows();
        const std::size_t width = at(columns + 2);
        std::vector<char> full(width * at(rows + 2), 0);
        for (int row = 0; row < rows; ++row)
            for (int column = 0; column < columns; ++column)
                if (lattice_.active[at(lattice_.cell(column, row))])
                    full[at(row + 1) * width + at(column + 1)] = fill_.filled[at(lattice_.firstCell(column, row))];
        layer_.cells.reserve(at(static_cast<int>(std::count(full.begin(), full.end(), char{1}))));
        for (int row = 0; row < rows; ++row) {
            const int* below = fill_.node.data() + at(row * (columns + 1));
            const int* above = below + columns + 1;
            for (int column = 0; column < columns; ++column) {
                const char* here = full.data() + at(row + 1) * width + at(column + 1);
                if (!*here) continue;
                const int main = lattice_.cell(column, row);
                const Cell& cell =
                    layer_.cells.emplace_back(Cell{{below[column], below[column + 1], above[column + 1], above[column]},
                                                   lattice_.region[at(main)],
                                                   lattice_.firstCell(column, row)});
                for (const int corner : cell.corners) layer_.held[at(corner)] = 1;
                if (!here[-static_cast<std::ptrdiff_t>(width)]) addSide(cell, 0);
                if (!here[1]) addSide(cell, 1);
                if (!here[width]) addSide(cell, 2);
                if (!here[-1]) addSide(cell, 3);
            }
        }
    }

    [[nodiscard]] bool filled(int column, int row, int a, int b) const {
        return fill_.filled[at(lattice_.firstCell(column, row) + b * lattice_.divisionOf(column, row) + a)];
    }

    [[nodiscard]] int nodeAt(int column, int row, int a, int b) const {
        return fill_.node[at(lattice_.nodeAt(column, row, a, b))];
    }

    void addCell(int column, int row, int a, int b, int u, bool finerBeside) {
        Cell cell{{nodeAt(column, row, a, b), nodeAt(column, row, a + 1, b), nodeAt(column, row, a + 1, b + 1),
                   nodeAt(column, row, a, b + 1)},
                  lattice_.region[at(lattice_.cell(column, row))],
                  lattice_.firstCell(column, row) + b * u + a};
        if (finerBeside) addHanging(column, row, a, b, u, cell);
        for (const int corner : cell.corners) layer_.held[at(corner)] = 1;
        const std::array<bool, 4> shared{twin(column, row, a, b - 1, u), twin(column, row, a + 1, b, u),
                                         twin(column, row, a, b + 1, u), twin(column, row, a - 1, b, u)};
        for (int side = 0; side < 4; ++side)
            if (!shared[at(side)]) addSide(cell, side);
        layer_.cells.push_back(cell);
    }

    void addHanging(int column, int row, int a, int b, int u, Cell& cell) {
        HangingNodes hanging;
        if (b == 0) hanging[0] = between(true, column, row, a, u);
        if (a + 1 == u) hanging[1] = between(false, column + 1, row, b, u);
        if (b + 1 == u) hanging[2] = reversed(between(true, column, row + 1, a, u));
        if (a == 0) hanging[3] = reversed(between(false, column, row, b, u));
        if (std::all_of(hanging.begin(), hanging.end(), [](const auto& side) { return side.empty(); })) return;
        for (const auto& side : hanging)
            for (const int node : side) layer_.held[at(node)] = 1;
        cell.hanging = static_cast<int>(layer_.hanging.size());
        layer_.hanging.push_back(std::move(hanging));
    }

    static std::vector<int> reversed(std::vector<int> nodes) {
        std::reverse(nodes.begin(), nodes.end());
        return nodes;
    }

    /// The used nodes strictly inside part `part` of `parts` of a main side.
    [[nodiscard]] std::vector<int> between(bool horizontal, int column, int row, int part, int parts) const {
        const int u = horizontal ? lattice_.horizontalDivision(column, row) : lattice_.verticalDivision(column, row);
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
        if (a >= 0 && b >= 0 && a < u && b < u) return filled(column, row, a, b);
        if (a < 0) --column, a = u - 1;
        else if (a == u) ++column, a = 0;
        if (b < 0) --row, b = u - 1;
        else if (b == u) ++row, b = 0;
        return lattice_.activeDivision(column, row) == u && filled(column, row, a, b);
    }

    void addSide(const Cell& cell, int side) {
        int from = cell.corners[at(side)];
        const auto add = [&](int to) {
            open_.push_back({std::min(from, to), std::max(from, to), from < to});
            from = to;
        };
        for (const int node : hangingOn(layer_, cell, at(side))) add(node);
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
        const int boundaryCount = static_cast<int>(boundary_.grid.size());
        std::vector<int> after(boundary_.grid.size(), -1);
        for (const auto& ring : boundary_.rings)
            for (std::size_t i = 0; i < ring.size(); ++i) {
                const int a = ring[i], b = ring[(i + 1) % ring.size()];
                after[at(a)] = b;
                if (!isSide(a, b)) layer_.walls.push_back({a, b});
            }
        for (const HalfEdge& edge : open_) {
            const int from = edge.rising ? edge.low : edge.high, to = edge.rising ? edge.high : edge.low;
            if (isSide(to, from)) continue;
            if (from < boundaryCount && after[at(from)] == to) continue;
            layer_.walls.push_back({to, from});
        }
    }

    void listStripNodes() {
        std::vector<char> enclosed = layer_.held; // of cells and of no wall: nothing to do there
        for (const Wall& wall : layer_.walls) enclosed[at(wall.from)] = enclosed[at(wall.to)] = 0;
        layer_.stripIndex.resize(enclosed.size());
        for (std::size_t node = 0; node < enclosed.size(); ++node) {
            if (enclosed[node]) continue;
            layer_.stripIndex[node] = static_cast<int>(layer_.stripNodes.size());
            layer_.stripNodes.push_back(static_cast<int>(node));
        }
    }

    const BoundaryNodes& boundary_;
    const Lattice& lattice_;
    const GridFill& fill_;
    CellLayer& layer_;
    std::vector<HalfEdge> open_;
};

} // namespace

std::span<const int> hangingOn(const CellLayer& layer, const Cell& cell, std::size_t side) {
    if (cell.hanging < 0) return {};
    return layer.hanging[at(cell.hanging)][side];
}

CellLayer cellLayer(const BoundaryNodes& boundary, const Lattice& lattice, const GridFill& fill) {
    CellLayer layer;
    Collector(boundary, lattice, fill, layer).run();
    return layer;
}

CellMesh cellMesh(const PieceFrame& frame, const BoundaryNodes& boundary, const Lattice& lattice,
                  const GridFill& fill) {
    CellMesh mesh;
    mesh.boundaryCount = static_cast<int>(boundary.points.size());
    mesh.position.reserve(boundary.points.size() + fill.inner.size());
    mesh.grid.reserve(boundary.points.size() + fill.inner.size());
    for (const Vec2 point : boundary.points) mesh.position.push_back(frame.frameOf(point));
    for (const auto& [node, place] : fill.aligned) mesh.position[at(node)] = place;
    mesh.position.insert(mesh.position.end(), fill.inner.begin(), fill.inner.end());
    mesh.grid = boundary.grid;
    mesh.grid.insert(mesh.grid.end(), fill.innerGrid.begin(), fill.innerGrid.end());
    mesh.layer = cellLayer(boundary, lattice, fill);
    return mesh;
}

void triangulateStrip(const Lattice& lattice, CellMesh& mesh) {
    const CellLayer& layer = mesh.layer;
    Strip& strip = mesh.strip;
    strip.points.clear();
    for (const int node : layer.stripNodes) strip.points.push_back(mesh.grid[at(node)]);
    strip.walls.clear();
    for (const Wall& wall : layer.walls)
        strip.walls.push_back({layer.stripIndex[at(wall.from)], layer.stripIndex[at(wall.to)]});
    strip.sweep.run(strip.points, strip.walls, strip.sides);
    strip.flips.run(strip.points, strip.sides);
    turnFlatTriangles(strip.points, strip.sides);
    mesh.triangles.clear();
    for (int t = 0; t < strip.sides.triangles(); ++t) {
        Triangle triangle;
        Vec2 middle;
        for (std::size_t i = 0; i < 3; ++i) {
            triangle.nodes[i] = layer.stripNodes[at(strip.sides.startOf(3 * t + static_cast<int>(i)))];
            middle += mesh.position[at(triangle.nodes[i])] / 3.0;
        }
        if (lattice.hasRegions)
            triangle.region = lattice.region[at(lattice.cell(lattice.columnOf(middle.x), lattice.rowOf(middle.y)))];
        mesh.triangles.push_back(triangle);
    }
}

} // namespace toile::meshing
