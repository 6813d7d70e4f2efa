// SPDX-License-Identifier: GPL-3.0-or-later
// What a strip is mended with where moving its nodes does not help: rectangles given up, and nodes put in.
#include "core/base/Index.h"
#include "core/meshing/StripImprovement.h"

#include <algorithm>
#include <cmath>

namespace toile::meshing {
namespace {

double squaredDistance(GridPoint a, GridPoint b) {
    const double x = static_cast<double>(a.x) - b.x, y = static_cast<double>(a.y) - b.y;
    return x * x + y * y;
}

} // namespace

/// Gives up the rectangles round one staircase corner of each bad triangle, the cheapest first.
bool StripImprover::freeNodes() {
    droppedBefore_ = dropped_.size();
    if (!layer_->mixed.empty()) listMixedCells();
    for (const int t : bad_) {
        int cheapest = -1;
        std::size_t fewest = 4;
        for (const int vertex : strip_->sides.corners(t)) {
            if (isBorder(vertex)) continue;
            listCells(vertex);
            if (cells_.empty() || cells_.size() > fewest) continue;
            if (cells_.size() == fewest && (cheapest < 0 || nearerMiddle(point(cheapest), point(vertex)))) continue;
            cheapest = vertex;
            fewest = cells_.size();
        }
        if (cheapest < 0) continue;
        listCells(cheapest);
        dropped_.insert(dropped_.end(), cells_.begin(), cells_.end());
    }
    const auto asked = dropped_.begin() + static_cast<std::ptrdiff_t>(droppedBefore_);
    std::sort(asked, dropped_.end());
    dropped_.erase(std::unique(asked, dropped_.end()), dropped_.end());
    for (std::size_t i = droppedBefore_; i < dropped_.size(); ++i) fill_->filled[at(dropped_[i])] = 0;
    return dropped_.size() > droppedBefore_;
}

/// Puts a node beside each bad triangle that has border nodes alone: moving and freeing cannot mend it.
bool StripImprover::addNodes() {
    bool added = false;
    for (const int t : bad_) {
        const auto corners = strip_->sides.corners(t);
        if (std::all_of(corners.begin(), corners.end(), [&](int vertex) { return isBorder(vertex); }))
            added |= addNodeBeside(t);
    }
    return added;
}

/// Takes a lattice node that was cleared, and puts it into the triangle beyond the longest side that is no wall, so
/// near to that side that it lies in the circle of both.
bool StripImprover::addNodeBeside(int triangle) {
    const TriangleSides& sides = strip_->sides;
    int longest = -1;
    double most = 0;
    for (int side = 3 * triangle; side < 3 * triangle + 3; ++side) {
        if (sides.twinOf(side) < 0) continue;
        const double square = squaredDistance(point(sides.startOf(side)), point(sides.endOf(side)));
        if (square > most) longest = side;
        most = std::max(most, square);
    }
    if (longest < 0) return false;
    const GridPoint a = point(sides.startOf(longest)), b = point(sides.endOf(longest)),
                    c = point(sides.apexOf(sides.twinOf(longest)));
    const auto between = [](std::int32_t p, std::int32_t q, std::int32_t r) {
        return static_cast<std::int32_t>(std::lround(0.4 * p + 0.4 * q + 0.2 * r));
    };
    const GridPoint place{between(a.x, b.x, c.x), between(a.y, b.y, c.y)};
    const int latticeNode = unusedCornerNear(place);
    if (latticeNode < 0 || orientation(b, a, place) <= 0 || orientation(a, c, place) <= 0 ||
        orientation(c, b, place) <= 0)
        return false;
    fill_->inner[at(latticeNode)] = 1;
    const int node = fill_->nodeAt(latticeNode);
    added_.push_back(latticeNode);
    moved_.emplace_back(node, place);
    const int vertex = layer_->addToStrip(node, true);
    strip_->points.push_back(place);
    const auto changed = splitTriangle(strip_->sides, sides.twinOf(longest) / 3, vertex);
    changed_.insert(changed_.end(), changed.begin(), changed.end());
    return true;
}

/// The nearest corner of main cells that is not used, of those round a place; −1 if there is none.
int StripImprover::unusedCornerNear(GridPoint place) const {
    const IntegerLines& lines = fill_->lines;
    const int column = lines.x.interval(place.x), row = lines.y.interval(place.y);
    int nearest = -1;
    double least = 0;
    for (int r = std::max(0, row - 1); r <= std::min(lattice_->rows(), row + 2); ++r)
        for (int c = std::max(0, column - 1); c <= std::min(lattice_->columns(), column + 2); ++c) {
            const GridPoint corner{lines.x[c], lines.y[r]};
            const double square = squaredDistance(place, corner);
            if (fill_->nodeAt(lattice_->corner(c, r)) >= 0 || (nearest >= 0 && square >= least)) continue;
            nearest = lattice_->corner(c, r);
            least = square;
        }
    return nearest;
}

/// Only whole cells away from divided ones were given up.
bool StripImprover::canFillLocally() const {
    if (lattice_->isUniform()) return true;
    const int width = lattice_->columns() + 2;
    return std::all_of(dropped_.begin() + static_cast<std::ptrdiff_t>(droppedBefore_), dropped_.end(), [&](int cell) {
        if (cell >= lattice_->wholeCell(0, lattice_->rows())) return false;
        for (const int beside : {-width - 1, -width, -width + 1, -1, 0, 1, width - 1, width, width + 1})
            if (lattice_->isMixed((cell + beside) % width - 1, (cell + beside) / width - 1)) return false;
        return true;
    });
}

/// Adds the two triangles of each cell that the pass has given up, and joins them to what they touch.
void StripImprover::fillDropped() {
    const int width = lattice_->columns() + 2;
    const auto dropped = std::span(dropped_).subspan(droppedBefore_);
    const int firstSide = static_cast<int>(strip_->sides.start.size());
    for (const int cell : dropped) {
        const int low = lattice_->corner(cell % width - 1, cell / width - 1), high = low + lattice_->columns() + 1;
        std::array<int, 4> c{low, low + 1, high + 1, high};
        for (int& corner : c) {
            addVertexOf(corner);
            corner = layer_->stripIndex[at(fill_->nodeAt(corner))];
        }
        const int side = static_cast<int>(strip_->sides.start.size());
        strip_->sides.start.insert(strip_->sides.start.end(), {c[0], c[1], c[2], c[0], c[2], c[3]});
        strip_->sides.twin.insert(strip_->sides.twin.end(), {-1, -1, side + 3, side + 2, -1, -1});
    }
    matchNewSides(firstSide);
    for (int side = firstSide; side < static_cast<int>(strip_->sides.start.size()); ++side) changed_.push_back(side);
}

/// A corner of a cell given up is a node of the strip now; and free, if no other cell has it.
void StripImprover::addVertexOf(int latticeNode) {
    const int node = fill_->nodeAt(latticeNode);
    const int vertex = layer_->addToStrip(node, false);
    if (at(vertex) == strip_->points.size()) strip_->points.push_back(places_->grid(node));
    if (isBorder(vertex)) return;
    const int column = latticeNode % (lattice_->columns() + 1), row = latticeNode / (lattice_->columns() + 1);
    const auto filled = [&](int c, int r) { return fill_->filled[at(lattice_->wholeCell(c, r))] != 0; };
    layer_->isFree[at(vertex)] =
        !filled(column, row) && !filled(column - 1, row) && !filled(column, row - 1) && !filled(column - 1, row - 1);
}

/// What was a wall between the strip and a cell given up is one no more, nor is what lies between two of them.
void StripImprover::matchNewSides(int firstSide) {
    TriangleSides& sides = strip_->sides;
    openSides_.clear();
    touched_.assign(strip_->points.size(), 0);
    for (std::size_t side = at(firstSide); side < sides.start.size(); ++side) touched_[at(sides.start[side])] = 1;
    for (int side = 0; side < static_cast<int>(sides.start.size()); ++side)
        if (sides.twinOf(side) < 0 && touched_[at(sides.startOf(side))])
            openSides_.push_back({sides.startOf(side), sides.endOf(side), side});
    std::sort(openSides_.begin(), openSides_.end());
    for (int side = firstSide; side < static_cast<int>(sides.start.size()); ++side) {
        if (sides.twinOf(side) >= 0) continue;
        if (folds_.has(nodeOf(sides.startOf(side)), nodeOf(sides.endOf(side)))) continue;
        const auto twin = std::lower_bound(openSides_.begin(), openSides_.end(),
                                           std::array{sides.endOf(side), sides.startOf(side), 0});
        if (twin == openSides_.end() || (*twin)[0] != sides.endOf(side) || (*twin)[1] != sides.startOf(side)) continue;
        sides.twin[at(side)] = (*twin)[2];
        sides.twin[at((*twin)[2])] = side;
    }
}

/// The mixed cells at the nodes of bad triangles.
void StripImprover::listMixedCells() {
    asked_.assign(layer_->stripIndex.size(), 0);
    for (const int t : bad_)
        for (const int vertex : strip_->sides.corners(t)) asked_[at(nodeOf(vertex))] = 1;
    mixedAt_.clear();
    for (const MixedCell& cell : layer_->mixed) {
        const auto enter = [&](int node) {
            if (asked_[at(node)]) mixedAt_.emplace_back(node, cell.index);
        };
        for (const int node : cell.corners) enter(node);
        for (int k = cell.hanging[0]; k < cell.hanging[4]; ++k) enter(layer_->hangingNodes[at(k)]);
    }
    std::sort(mixedAt_.begin(), mixedAt_.end());
}

/// The cells that have a node at a corner or on a side.
void StripImprover::listCells(int vertex) {
    cells_.clear();
    const int node = nodeOf(vertex), latticeNode = places_->latticeNode(node);
    if (latticeNode < lattice_->cornerCount()) {
        const int column = latticeNode % (lattice_->columns() + 1), row = latticeNode / (lattice_->columns() + 1);
        for (const int r : {row - 1, row})
            for (const int c : {column - 1, column})
                if (fill_->filled[at(lattice_->wholeCell(c, r))] && !lattice_->isMixed(c, r))
                    cells_.push_back(lattice_->wholeCell(c, r));
    }
    if (layer_->mixed.empty()) return;
    for (auto cell = std::lower_bound(mixedAt_.begin(), mixedAt_.end(), std::pair(node, 0));
         cell != mixedAt_.end() && cell->first == node; ++cell)
        cells_.push_back(cell->second);
}

} // namespace toile::meshing
