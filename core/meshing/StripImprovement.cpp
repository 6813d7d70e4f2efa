// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/meshing/StripImprovement.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace toile::meshing {
namespace {

std::size_t at(int i) {
    return static_cast<std::size_t>(i);
}

/// How good a strip is: first the number of triangles below the wanted angle, then the smallest angle.
struct Grade {
    int bad = 0;
    double smallest = std::numbers::pi;

    [[nodiscard]] bool betterThan(const Grade& other) const {
        return bad != other.bad ? bad < other.bad : smallest > other.smallest;
    }
};

double angleAt(GridPoint corner, GridPoint a, GridPoint b) {
    const double ax = static_cast<double>(a.x) - corner.x, ay = static_cast<double>(a.y) - corner.y;
    const double bx = static_cast<double>(b.x) - corner.x, by = static_cast<double>(b.y) - corner.y;
    return std::atan2(ax * by - ay * bx, ax * bx + ay * by);
}

class Improver {
public:
    Improver(const PieceFrame& frame, const BoundaryNodes& boundary, const Lattice& lattice, GridFill& fill,
             CellMesh& mesh, const ImprovementSettings& settings)
        : frame_(frame), boundary_(boundary), lattice_(lattice), fill_(fill), mesh_(mesh),
          settings_(settings), wanted_(settings.wantedAngle * std::numbers::pi / 180) {
        after_.assign(at(mesh.boundaryCount), -1);
        for (const auto& ring : boundary.rings)
            for (std::size_t i = 0; i < ring.size(); ++i) after_[at(ring[i])] = ring[(i + 1) % ring.size()];
    }

    void run() {
        triangulateStrip(lattice_, mesh_);
        std::vector<int> bad = badTriangles();
        CellMesh best = mesh_;
        Grade bestGrade = grade_;
        for (int pass = 0; pass < settings_.passes && !bad.empty(); ++pass) {
            const bool moved = moveNodesOf(bad);
            const bool freed = (pass % 2 == 1 || !moved) && freeNodesOf(bad);
            if (!moved && !freed) break;
            triangulateStrip(lattice_, mesh_);
            bad = badTriangles();
            if (!grade_.betterThan(bestGrade)) continue;
            bestGrade = grade_;
            best = mesh_;
        }
        mesh_ = std::move(best);
    }

private:
    [[nodiscard]] GridPoint point(int node) const { return mesh_.grid[at(node)]; }

    /// The corner angle is the border's own: nothing inside can change it.
    [[nodiscard]] bool isBorderAngle(const std::array<int, 3>& t, std::size_t corner) const {
        const int here = t[corner], next = t[(corner + 1) % 3], before = t[(corner + 2) % 3];
        return here < mesh_.boundaryCount && next < mesh_.boundaryCount && before < mesh_.boundaryCount &&
               after_[at(here)] == next && after_[at(before)] == here;
    }

    /// Smallest angle of a triangle, the border's own corners left out.
    [[nodiscard]] double freeAngle(const std::array<int, 3>& t) const {
        double smallest = std::numbers::pi;
        for (std::size_t i = 0; i < 3; ++i)
            if (!isBorderAngle(t, i))
                smallest =
                    std::min(smallest, angleAt(point(t[i]), point(t[(i + 1) % 3]), point(t[(i + 2) % 3])));
        return smallest;
    }

    /// Grades the strip and lists what is below the wanted angle; collects who touches whom.
    std::vector<int> badTriangles() {
        std::vector<int> bad;
        grade_ = {};
        star_.assign(mesh_.grid.size(), {});
        for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
            for (const int node : mesh_.triangles[t].nodes) star_[at(node)].push_back(static_cast<int>(t));
            const double angle = freeAngle(mesh_.triangles[t].nodes);
            grade_.smallest = std::min(grade_.smallest, angle);
            if (angle < wanted_) bad.push_back(static_cast<int>(t));
        }
        grade_.bad = static_cast<int>(bad.size());
        cellsAt_.assign(mesh_.grid.size(), {});
        for (std::size_t c = 0; c < mesh_.cells.size(); ++c) {
            for (const int node : mesh_.cells[c].corners) cellsAt_[at(node)].push_back(static_cast<int>(c));
            for (const auto& side : mesh_.cells[c].hanging)
                for (const int node : side) cellsAt_[at(node)].push_back(static_cast<int>(c));
        }
        return bad;
    }

    [[nodiscard]] bool isFree(int node) const {
        return node >= mesh_.boundaryCount && cellsAt_[at(node)].empty();
    }

    bool moveNodesOf(const std::vector<int>& bad) {
        constexpr std::size_t crowded = 24; // triangles: a node of so many cannot have good angles
        bool moved = false;
        std::vector<int> nodes;
        for (const int t : bad)
            for (const int node : mesh_.triangles[at(t)].nodes)
                if (isFree(node) && star_[at(node)].size() < crowded) nodes.push_back(node);
        std::sort(nodes.begin(), nodes.end(),
                  [&](int a, int b) { return mortonCode(point(a)) < mortonCode(point(b)); });
        nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
        for (const int node : nodes) moved |= moveNode(node);
        return moved;
    }

    /// Smallest angle of the star; negative if a triangle would turn over.
    [[nodiscard]] double starAngle(int node) const {
        double smallest = std::numbers::pi;
        for (const int t : star_[at(node)]) {
            const auto& n = mesh_.triangles[at(t)].nodes;
            if (orientation(point(n[0]), point(n[1]), point(n[2])) <= 0) return -1;
            smallest = std::min(smallest, freeAngle(n));
        }
        return smallest;
    }

    /// Tries the middle of the star and steps that shrink.
    bool moveNode(int node) {
        const GridPoint before = point(node);
        double best = starAngle(node);
        double reach = 0;
        for (const int t : star_[at(node)])
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
                const double angle = starAngle(node);
                if (angle > best + 1e-6)
                    best = angle;
                else
                    mesh_.grid[at(node)] = here;
            }
        if (point(node) == before) return false;
        mesh_.position[at(node)] = frame_.placeOf(point(node));
        return true;
    }

    /// Gives up the rectangles round one staircase corner of each bad triangle, the cheapest first.
    bool freeNodesOf(const std::vector<int>& bad) {
        std::vector<char> dropped(mesh_.cells.size(), 0);
        bool any = false;
        for (const int t : bad) {
            int cheapest = -1;
            std::size_t fewest = 4;
            for (const int node : mesh_.triangles[at(t)].nodes) {
                const auto& cells = cellsAt_[at(node)];
                if (node < mesh_.boundaryCount || cells.empty() || cells.size() >= fewest) continue;
                cheapest = node;
                fewest = cells.size();
            }
            if (cheapest < 0) continue;
            for (const int cell : cellsAt_[at(cheapest)]) dropped[at(cell)] = 1;
            any = true;
        }
        if (any) rebuildWithout(dropped);
        return any;
    }

    void rebuildWithout(const std::vector<char>& dropped) {
        for (std::size_t c = 0; c < dropped.size(); ++c)
            if (dropped[c]) fill_.filled[at(mesh_.cells[c].index)] = 0;
        std::vector<Vec2> position = std::move(mesh_.position);
        std::vector<GridPoint> grid = std::move(mesh_.grid);
        mesh_ = cellMesh(frame_, boundary_, lattice_, fill_);
        mesh_.position = std::move(position); // nodes keep their numbers, and moved ones their places
        mesh_.grid = std::move(grid);
    }

    const PieceFrame& frame_;
    const BoundaryNodes& boundary_;
    const Lattice& lattice_;
    GridFill& fill_;
    CellMesh& mesh_;
    ImprovementSettings settings_;
    double wanted_;
    Grade grade_;
    std::vector<int> after_;
    std::vector<std::vector<int>> star_, cellsAt_;
};

} // namespace

void improveStrip(const PieceFrame& frame, const BoundaryNodes& boundary, const Lattice& lattice,
                  GridFill& fill, CellMesh& mesh, const ImprovementSettings& settings) {
    Improver(frame, boundary, lattice, fill, mesh, settings).run();
}

} // namespace toile::meshing
