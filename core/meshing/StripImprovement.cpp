// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/meshing/StripImprovement.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <optional>

namespace toile::meshing {
namespace {

std::size_t at(int i) {
    return static_cast<std::size_t>(i);
}

/// Angles are compared by their cotangents, which fall as they grow and need no more than products: there is none
/// greater than this.
constexpr double flat = std::numeric_limits<double>::infinity();

/// How good a strip is: first the number of triangles below the wanted angle, then the smallest angle.
struct Grade {
    int bad = 0;
    double sharpest = -flat; ///< cotangent of the smallest angle

    [[nodiscard]] bool betterThan(const Grade& other) const {
        return bad != other.bad ? bad < other.bad : sharpest < other.sharpest;
    }
};

double dotAt(GridPoint corner, GridPoint a, GridPoint b) {
    const double ax = static_cast<double>(a.x) - corner.x, ay = static_cast<double>(a.y) - corner.y;
    const double bx = static_cast<double>(b.x) - corner.x, by = static_cast<double>(b.y) - corner.y;
    return ax * bx + ay * by;
}

class Improver {
public:
    Improver(const PieceFrame& frame, const BoundaryNodes& boundary, const Lattice& lattice, GridFill& fill,
             CellMesh& mesh, const ImprovementSettings& settings)
        : frame_(frame), boundary_(boundary), lattice_(lattice), fill_(fill), mesh_(mesh), settings_(settings),
          wanted_(1 / std::tan(settings.wantedAngle * std::numbers::pi / 180)) {
        after_.assign(at(mesh.boundaryCount), -1);
        for (const auto& ring : boundary.rings)
            for (std::size_t i = 0; i < ring.size(); ++i) after_[at(ring[i])] = ring[(i + 1) % ring.size()];
    }

    void run() {
        triangulateStrip(lattice_, mesh_);
        std::vector<int> bad = badTriangles();
        if (bad.empty()) return;
        keepAsBest();
        for (int pass = 0; pass < settings_.passes && !bad.empty(); ++pass) {
            const bool moved = moveNodesOf(bad);
            const bool freed = (pass % 2 == 1 || !moved) && freeNodesOf(bad);
            if (!moved && !freed) break;
            triangulateStrip(lattice_, mesh_);
            bad = badTriangles();
            if (grade_.betterThan(best_.grade)) keepAsBest();
        }
        restoreBest();
    }

private:
    [[nodiscard]] GridPoint point(int node) const { return mesh_.grid[at(node)]; }

    /// The corner angle is the border's own: nothing inside can change it.
    [[nodiscard]] bool isBorderAngle(const std::array<int, 3>& t, std::size_t corner) const {
        const int here = t[corner], next = t[(corner + 1) % 3], before = t[(corner + 2) % 3];
        return here < mesh_.boundaryCount && next < mesh_.boundaryCount && before < mesh_.boundaryCount &&
               after_[at(here)] == next && after_[at(before)] == here;
    }

    /// Cotangent of the smallest angle of a triangle, the border's own corners left out; infinite where it has no area
    /// or is turned over.
    [[nodiscard]] double sharpness(const std::array<int, 3>& t) const {
        const GridPoint a = point(t[0]), b = point(t[1]), c = point(t[2]);
        const std::int64_t area = orientation(a, b, c);
        if (area <= 0) return flat;
        const std::array<double, 3> dots{dotAt(a, b, c), dotAt(b, c, a), dotAt(c, a, b)};
        double sharpest = -flat;
        for (std::size_t i = 0; i < 3; ++i)
            if (dots[i] > sharpest && !isBorderAngle(t, i)) sharpest = dots[i];
        return sharpest / static_cast<double>(area);
    }

    void keepAsBest() {
        best_ = {grade_, mesh_.triangles, mesh_.strip.sides, {}, {}};
        for (const int node : mesh_.layer.stripNodes)
            if (node >= mesh_.boundaryCount) best_.places.emplace_back(node, mesh_.grid[at(node)]);
    }

    void restoreBest() {
        for (const int node : mesh_.layer.stripNodes) // also those that were cells' corners in the best mesh
            if (node >= mesh_.boundaryCount) place(node, fill_.innerGrid[at(node - mesh_.boundaryCount)]);
        if (best_.layer) mesh_.layer = std::move(*best_.layer);
        for (const auto& [node, at] : best_.places) place(node, at);
        mesh_.triangles = std::move(best_.triangles);
        mesh_.strip.sides = std::move(best_.sides);
        mesh_.strip.points.clear();
        for (const int node : mesh_.layer.stripNodes) mesh_.strip.points.push_back(point(node));
    }

    /// Sets a node that is the strip's own; on its lattice place it has the lattice's coordinates.
    void place(int node, GridPoint grid) {
        const std::size_t inner = at(node - mesh_.boundaryCount);
        mesh_.grid[at(node)] = grid;
        mesh_.position[at(node)] = grid == fill_.innerGrid[inner] ? fill_.inner[inner] : frame_.placeOf(grid);
    }

    /// Grades the strip and lists what is below the wanted angle.
    std::vector<int> badTriangles() {
        std::vector<int> bad;
        grade_ = {};
        for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
            const double sharp = sharpness(mesh_.triangles[t].nodes);
            grade_.sharpest = std::max(grade_.sharpest, sharp);
            if (sharp > wanted_) bad.push_back(static_cast<int>(t));
        }
        grade_.bad = static_cast<int>(bad.size());
        return bad;
    }

    /// Collects the triangles of each strip node.
    void collectStars() {
        firstOfStar_.assign(mesh_.layer.stripNodes.size() + 1, 0);
        const std::vector<int>& corners = mesh_.strip.sides.start;
        for (const int vertex : corners) ++firstOfStar_[at(vertex)];
        std::partial_sum(firstOfStar_.begin(), firstOfStar_.end(), firstOfStar_.begin());
        stars_.resize(corners.size());
        for (std::size_t side = corners.size(); side-- > 0;)
            stars_[--firstOfStar_[at(corners[side])]] = static_cast<int>(side / 3);
    }

    [[nodiscard]] std::size_t stripIndex(int node) const { return at(mesh_.layer.stripIndex[at(node)]); }

    /// The triangles at a strip node.
    [[nodiscard]] std::span<const int> star(int node) const {
        const std::size_t i = stripIndex(node);
        return std::span(stars_).subspan(firstOfStar_[i], firstOfStar_[i + 1] - firstOfStar_[i]);
    }

    [[nodiscard]] bool isFree(int node) const { return node >= mesh_.boundaryCount && !mesh_.layer.held[at(node)]; }

    bool moveNodesOf(const std::vector<int>& bad) {
        constexpr std::size_t crowded = 24; // triangles: a node of so many cannot have good angles
        bool moved = false;
        collectStars();
        std::vector<int> nodes;
        for (const int t : bad)
            for (const int node : mesh_.triangles[at(t)].nodes)
                if (isFree(node) && star(node).size() < crowded) nodes.push_back(node);
        std::sort(nodes.begin(), nodes.end(),
                  [&](int a, int b) { return mortonCode(point(a)) < mortonCode(point(b)); });
        nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
        for (const int node : nodes) moved |= moveNode(node);
        return moved;
    }

    /// Cotangent of the smallest angle of the star; infinite if a triangle would turn over.
    [[nodiscard]] double starSharpness(std::span<const int> triangles) const {
        double sharpest = -flat;
        for (const int t : triangles) sharpest = std::max(sharpest, sharpness(mesh_.triangles[at(t)].nodes));
        return sharpest;
    }

    /// Tries the middle of the star and steps that shrink.
    bool moveNode(int node) {
        constexpr double leastGain = 1e-6; // [rad]: the cotangent of an angle falls by 1 + its square
        const GridPoint before = point(node);
        const std::span<const int> triangles = star(node);
        double best = starSharpness(triangles);
        double reach = 0;
        for (const int t : triangles)
            for (const int other : mesh_.triangles[at(t)].nodes)
                reach = std::max(reach, std::hypot(static_cast<double>(point(other).x) - before.x,
                                                   static_cast<double>(point(other).y) - before.y));
        for (double step = 0.3 * reach; step > 0.02 * reach; step *= 0.6)
            for (int direction = 0; direction < 8; ++direction) {
                const GridPoint here = point(node);
                const double dx = std::array<double, 8>{1, 0.7, 0, -0.7, -1, -0.7, 0, 0.7}[at(direction)];
                const double dy = std::array<double, 8>{0, 0.7, 1, 0.7, 0, -0.7, -1, -0.7}[at(direction)];
                mesh_.grid[at(node)] = {here.x + static_cast<std::int32_t>(std::lround(dx * step)),
                                        here.y + static_cast<std::int32_t>(std::lround(dy * step))};
                const double sharp = starSharpness(triangles);
                if (sharp < best - leastGain * (1 + best * best)) best = sharp;
                else mesh_.grid[at(node)] = here;
            }
        if (point(node) == before) return false;
        mesh_.position[at(node)] = frame_.placeOf(point(node));
        return true;
    }

    /// Gives up the rectangles round one staircase corner of each bad triangle, the cheapest first.
    bool freeNodesOf(const std::vector<int>& bad) {
        const std::vector<std::vector<int>> cellsAt = cellsAtCorners(bad);
        std::vector<int> dropped;
        for (const int t : bad) {
            int cheapest = -1;
            std::size_t fewest = 4;
            for (const int node : mesh_.triangles[at(t)].nodes) {
                const auto& cells = cellsAt[stripIndex(node)];
                if (node < mesh_.boundaryCount || cells.empty() || cells.size() >= fewest) continue;
                cheapest = node;
                fewest = cells.size();
            }
            if (cheapest < 0) continue;
            const auto& cells = cellsAt[stripIndex(cheapest)];
            dropped.insert(dropped.end(), cells.begin(), cells.end());
        }
        if (!dropped.empty()) rebuildWithout(dropped);
        return !dropped.empty();
    }

    /// The cells at the corners of these triangles, by strip node.
    [[nodiscard]] std::vector<std::vector<int>> cellsAtCorners(const std::vector<int>& triangles) const {
        std::vector<char> asked(mesh_.grid.size(), 0);
        for (const int t : triangles)
            for (const int node : mesh_.triangles[at(t)].nodes) asked[at(node)] = 1;
        std::vector<std::vector<int>> cells(mesh_.layer.stripNodes.size());
        for (std::size_t c = 0; c < mesh_.layer.cells.size(); ++c) {
            const Cell& cell = mesh_.layer.cells[c];
            const auto enter = [&](int node) {
                if (asked[at(node)]) cells[stripIndex(node)].push_back(static_cast<int>(c));
            };
            for (const int node : cell.corners) enter(node);
            for (std::size_t side = 0; cell.hanging >= 0 && side < 4; ++side)
                for (const int node : hangingOn(mesh_.layer, cell, side)) enter(node);
        }
        return cells;
    }

    void rebuildWithout(const std::vector<int>& dropped) {
        for (const int c : dropped) fill_.filled[at(mesh_.layer.cells[at(c)].index)] = 0;
        CellLayer layer = cellLayer(boundary_, lattice_, fill_);
        if (!best_.layer) best_.layer = std::move(mesh_.layer);
        mesh_.layer = std::move(layer);
    }

    /// The best strip so far, without copying what is not its own.
    struct Best {
        Grade grade;
        std::vector<Triangle> triangles;
        TriangleSides sides;
        std::vector<std::pair<int, GridPoint>> places; ///< of the nodes of its strip
        std::optional<CellLayer> layer;                ///< empty while it is the mesh's own
    };

    const PieceFrame& frame_;
    const BoundaryNodes& boundary_;
    const Lattice& lattice_;
    GridFill& fill_;
    CellMesh& mesh_;
    ImprovementSettings settings_;
    double wanted_;
    Grade grade_;
    Best best_;
    std::vector<int> after_;
    std::vector<std::size_t> firstOfStar_; ///< of each strip node, into stars_
    std::vector<int> stars_;
};

} // namespace

void improveStrip(const PieceFrame& frame, const BoundaryNodes& boundary, const Lattice& lattice, GridFill& fill,
                  CellMesh& mesh, const ImprovementSettings& settings) {
    Improver(frame, boundary, lattice, fill, mesh, settings).run();
}

} // namespace toile::meshing
