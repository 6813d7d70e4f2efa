// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/meshing/RegionBorderPath.h"
#include "core/base/Index.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

namespace toile::meshing {
namespace {

constexpr double distanceWeight = 4; ///< of the distance to the border against the length of the path [–]

/// In 1e-10 m, so that paths of equal cost are equal whatever rounding did.
using Cost = std::int64_t;

int nearestLine(const std::vector<double>& lines, double value) {
    const auto above = std::lower_bound(lines.begin(), lines.end(), value);
    if (above == lines.begin()) return 0;
    if (above == lines.end()) return static_cast<int>(lines.size()) - 1;
    const int i = static_cast<int>(above - lines.begin());
    const double gap = *above - lines[at(i - 1)]; // half-way goes down, whatever rounding did to it
    return value - lines[at(i - 1)] <= gap * (0.5 + 1e-7) ? i - 1 : i;
}

/// Dijkstra on the crossings in a box round both ends.
class PathSearch {
public:
    PathSearch(const Lattice& lattice, LatticePoint from, LatticePoint to, Vec2 sideFrom, Vec2 sideTo, Arena& arena)
        : lattice_(lattice), from_(from), to_(to), sideFrom_(sideFrom), sideTo_(sideTo), arena_(arena) {
        low_ = {std::max(0, std::min(from.column, to.column) - 1), std::max(0, std::min(from.row, to.row) - 1)};
        high_ = {std::min(lattice.columns(), std::max(from.column, to.column) + 1),
                 std::min(lattice.rows(), std::max(from.row, to.row) + 1)};
    }

    LatticePath run() {
        const int width = high_.column - low_.column + 1, height = high_.row - low_.row + 1;
        std::pmr::vector<Cost> cost(at(width * height), std::numeric_limits<Cost>::max(), &arena_);
        std::pmr::vector<LatticePoint> before(cost.size(), &arena_);
        const auto index = [&](LatticePoint p) { return at((p.row - low_.row) * width + p.column - low_.column); };
        using Entry = std::pair<Cost, LatticePoint>;
        using Entries = std::pmr::vector<Entry>;
        std::priority_queue<Entry, Entries, std::greater<>> open{std::greater<>(), Entries(&arena_)};
        cost[index(from_)] = 0;
        open.emplace(0, from_);
        while (!open.empty()) {
            const auto [spent, here] = open.top();
            open.pop();
            if (here == to_) break;
            if (spent > cost[index(here)]) continue;
            for (const LatticePoint step : {LatticePoint{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
                const LatticePoint there{here.column + step.column, here.row + step.row};
                if (there.column < low_.column || there.row < low_.row || there.column > high_.column ||
                    there.row > high_.row)
                    continue;
                const Cost total = spent + weight(here, there);
                if (total >= cost[index(there)]) continue;
                cost[index(there)] = total;
                before[index(there)] = here;
                open.emplace(total, there);
            }
        }
        LatticePath path(1, to_, &arena_);
        while (path.back() != from_) path.push_back(before[index(path.back())]);
        std::reverse(path.begin(), path.end());
        return path;
    }

private:
    [[nodiscard]] Cost weight(LatticePoint p, LatticePoint q) const {
        const Vec2 a = place(p), b = place(q), middle = lerp(a, b, 0.5);
        const double metres =
            distance(a, b) + distanceWeight * distance(middle, geometry::closestOnSegment(sideFrom_, sideTo_, middle));
        return std::llround(metres * 1e10 + 0.3719);
    }
    [[nodiscard]] Vec2 place(LatticePoint p) const {
        return {lattice_.mainX()[at(p.column)], lattice_.mainY()[at(p.row)]};
    }

    const Lattice& lattice_;
    LatticePoint from_, to_, low_, high_;
    Vec2 sideFrom_, sideTo_;
    Arena& arena_;
};

} // namespace

LatticePath nearestLatticePath(std::span<const Vec2> border, const Lattice& lattice, Arena& arena) {
    const auto nearest = [&](Vec2 p) {
        return LatticePoint{nearestLine(lattice.mainX(), p.x), nearestLine(lattice.mainY(), p.y)};
    };
    LatticePath closed(&arena);
    for (std::size_t i = 0; i < border.size(); ++i) {
        const Vec2 a = border[i], b = border[(i + 1) % border.size()];
        const LatticePoint from = nearest(a), to = nearest(b);
        if (from == to) continue;
        // From the smaller end, so that a border walked the other way takes the same path.
        LatticePath path = from < to ? PathSearch(lattice, from, to, a, b, arena).run()
                                     : PathSearch(lattice, to, from, b, a, arena).run();
        if (to < from) std::reverse(path.begin(), path.end());
        closed.insert(closed.end(), path.begin(), path.end() - 1);
    }
    return closed;
}

} // namespace toile::meshing
