// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/meshing/GridFill.h"
#include "core/base/Index.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace toile::meshing {
namespace {

/// Squared distance of the origin from a segment.
double squaredDistance(Vec2 a, Vec2 b) {
    const Vec2 along = b - a;
    const double t = std::clamp(-dot(a, along) / squaredLength(along), 0.0, 1.0);
    return squaredLength(a + along * t);
}

} // namespace

GridPoint GridFill::gridAt(const Lattice& lattice, int place) const {
    if (place >= lattice.cornerCount()) return innerGrid[at(place - lattice.cornerCount())];
    const int width = lattice.columns() + 1;
    return {lines.x[place % width], lines.y[place / width]};
}

Vec2 GridFill::placeAt(const Lattice& lattice, int place) const {
    if (place >= lattice.cornerCount()) return innerPlace[at(place - lattice.cornerCount())];
    const int width = lattice.columns() + 1;
    return {lattice.mainX()[at(place % width)], lattice.mainY()[at(place / width)]};
}

void GridFiller::run(const PieceFrame& frame, const BoundaryNodes& boundary, BorderSegments& segments,
                     const Lattice& lattice, double cleared, GridFill& fill) {
    frame_ = &frame;
    boundary_ = &boundary;
    lattice_ = &lattice;
    segments_ = &segments;
    fill_ = &fill;
    cleared_ = cleared;
    fill.borderCount = static_cast<int>(boundary.points.size());
    fill.node.assign(at(lattice.nodeCount()), -1);
    fill.inner.assign(at(lattice.nodeCount()) + GridFill::margin, 0);
    markCorners();
    if (!lattice.isUniform()) {
        placeDivided();
        markDivided();
    }
    listNeighbours();
    alignBoundary();
    clearNearBorder();
    for (const auto& [node, latticeNode] : fill.aligned) fill.inner[at(latticeNode)] = 1; // used, for the cells
    fillCells();
    for (const auto& [node, latticeNode] : fill.aligned) fill.inner[at(latticeNode)] = 0;
}

void GridFiller::markCorners() {
    const IntegerLines& lines = fill_->lines;
    for (int row = 0; row <= lattice_->rows(); ++row) {
        const auto crossings = segments_->crossings(lines.y[row], row);
        const auto first = fill_->inner.begin() + lattice_->corner(0, row);
        for (std::size_t k = 0; k + 1 < crossings.size(); k += 2)
            std::fill(first + lines.x.firstFrom(crossings[k]), first + lines.x.firstFrom(crossings[k + 1]), char{1});
    }
}

/// Coordinates of the nodes beyond the corners, and the coarsest division that has each: its spacing counts for
/// clearing.
void GridFiller::placeDivided() {
    const int corners = lattice_->cornerCount();
    const std::size_t count = at(lattice_->nodeCount() - corners);
    fill_->innerPlace.resize(count);
    fill_->innerGrid.resize(count);
    coarsest_.assign(count, 0);
    for (const int cell : lattice_->dividedCells()) {
        const int column = cell % lattice_->columns(), row = cell / lattice_->columns();
        const int u = lattice_->divisionOf(cell);
        for (int b = 0; b <= u; ++b) {
            lattice_->nodesOfRow(column, row, b, rowNodes_);
            for (int a = 0; a <= u; ++a) {
                const int node = rowNodes_[at(a)] - corners;
                if (node < 0) continue;
                int& coarsest = coarsest_[at(node)];
                if (coarsest == 0) {
                    const Vec2 place{lattice_->xAt(column, a, u), lattice_->yAt(row, b, u)};
                    fill_->innerPlace[at(node)] = place;
                    fill_->innerGrid[at(node)] = frame_->gridOf(place);
                }
                coarsest = coarsest == 0 ? u : std::min(coarsest, u);
            }
        }
    }
}

/// Marks the nodes beyond the corners that lie inside, row by row of the finest cell in a row of main cells.
void GridFiller::markDivided() {
    const std::vector<int>& divided = lattice_->dividedCells();
    const int columns = lattice_->columns(), corners = lattice_->cornerCount();
    for (auto first = divided.begin(); first != divided.end();) {
        const int row = *first / columns;
        const auto last = std::find_if(first, divided.end(), [&](int cell) { return cell / columns != row; });
        int finest = 1;
        for (auto cell = first; cell != last; ++cell) finest = std::max(finest, lattice_->divisionOf(*cell));
        for (int b = 0; b <= finest; ++b) {
            const std::int32_t y = frame_->gridOf({0, lattice_->yAt(row, b, finest)}).y;
            const auto crossings = segments_->crossings(y, b < finest ? row : row + 1);
            for (auto cell = first; cell != last; ++cell) {
                const int u = lattice_->divisionOf(*cell);
                if (b * u % finest != 0) continue;
                lattice_->nodesOfRow(*cell % columns, row, b * u / finest, rowNodes_);
                for (const int node : rowNodes_) {
                    if (node < corners) continue;
                    const std::int64_t x = fill_->innerGrid[at(node - corners)].x;
                    fill_->inner[at(node)] =
                        (std::upper_bound(crossings.begin(), crossings.end(), x) - crossings.begin()) % 2 == 1;
                }
            }
        }
        first = last;
    }
}

/// Boundary nodes that lie on lattice nodes are those nodes and stay.
void GridFiller::alignBoundary() {
    const IntegerLines& lines = fill_->lines;
    const auto gap = [](std::int32_t a, std::int32_t b) { return std::abs(std::int64_t{a} - b); };
    const auto partOf = [](std::int32_t value, std::int32_t low, std::int32_t high, int u) {
        const double part =
            static_cast<double>(std::int64_t{value} - low) / static_cast<double>(std::int64_t{high} - low);
        return std::clamp(static_cast<int>(std::lround(part * u)), 0, u);
    };
    fill_->aligned.clear();
    for (std::size_t i = 0; i < boundary_->grid.size(); ++i) {
        if (before_[i] < 0 && !lattice_->isUniform()) continue; // beside divided cells a fold has triangles
        const GridPoint p = boundary_->grid[i];
        const int left = lines.x.interval(std::int64_t{p.x} - sameNode);
        const int right = lines.x.interval(std::int64_t{p.x} + sameNode);
        const int below = lines.y.interval(std::int64_t{p.y} - sameNode);
        const int above = lines.y.interval(std::int64_t{p.y} + sameNode);
        if (left == right && below == above && !lattice_->isMixed(left, below) && // the usual case: on no line
            gap(lines.x[left], p.x) > sameNode && gap(lines.x[left + 1], p.x) > sameNode)
            continue;
        for (int column = left; column <= right; ++column)
            for (int row = below; row <= above; ++row) {
                const int u = lattice_->activeDivision(column, row);
                if (u == 0) continue;
                const int a = partOf(p.x, lines.x[column], lines.x[column + 1], u);
                const int b = partOf(p.y, lines.y[row], lines.y[row + 1], u);
                const int node = lattice_->nodeAt(column, row, a, b);
                const GridPoint place = fill_->gridAt(*lattice_, node);
                if (fill_->node[at(node)] >= 0 || gap(place.x, p.x) > sameNode || gap(place.y, p.y) > sameNode)
                    continue;
                fill_->node[at(node)] = static_cast<int>(i);
                fill_->aligned.emplace_back(static_cast<int>(i), node);
            }
    }
}

/// The wider of the cells beside each main line.
void GridFiller::measureLines() {
    const auto measure = [&](const IntegerAxis& lines, const std::vector<double>& places, std::vector<double>& widths,
                             std::vector<double>& inverse) {
        widths.assign(at(lines.count()), 0);
        for (std::size_t i = 0; i + 1 < places.size(); ++i) {
            const double width = (places[i + 1] - places[i]) / frame_->unit;
            widths[i] = std::max(widths[i], width);
            widths[i + 1] = width;
        }
        inverse.clear();
        for (const double width : widths) inverse.push_back(1 / width);
    };
    measure(fill_->lines.x, lattice_->mainX(), widthAt_, perWidth_);
    measure(fill_->lines.y, lattice_->mainY(), heightAt_, perHeight_);
}

/// Distances are measured in cells, so that oblong cells are cleared alike both ways.
void GridFiller::clearNearBorder() {
    measureLines();
    const IntegerLines& lines = fill_->lines;
    for (const BorderSegment& segment : segments_->all()) {
        clearCorners(segment);
        if (lattice_->isUniform()) continue;
        const auto [lowX, highX] = std::minmax(segment.a.x, segment.b.x);
        const auto [lowY, highY] = std::minmax(segment.a.y, segment.b.y);
        const int column0 = std::max(0, lines.x.interval(lowX) - 1),
                  column1 = std::min(lattice_->columns() - 1, lines.x.interval(highX) + 1);
        const int row0 = std::max(0, lines.y.interval(lowY) - 1),
                  row1 = std::min(lattice_->rows() - 1, lines.y.interval(highY) + 1);
        for (int row = row0; row <= row1; ++row)
            for (int column = column0; column <= column1; ++column)
                if (lattice_->isMixed(column, row))
                    if (const int u = lattice_->activeDivision(column, row); u > 1)
                        clearDivided(segment, column, row, u);
    }
}

void GridFiller::clearCorners(const BorderSegment& segment) {
    const IntegerLines& lines = fill_->lines;
    const auto [lowX, highX] = std::minmax(segment.a.x, segment.b.x);
    const auto [lowY, highY] = std::minmax(segment.a.y, segment.b.y);
    // The lines that the segment's box reaches, of those nearest to it.
    const auto range = [&](const IntegerAxis& axis, const std::vector<double>& widths, std::int32_t low,
                           std::int32_t high) {
        int first = std::max(0, axis.interval(low) - 1), last = std::min(axis.count() - 1, axis.interval(high) + 2);
        while (first < last && axis[first] < low - cleared_ * widths[at(first)]) ++first;
        while (last > first && axis[last] > high + cleared_ * widths[at(last)]) --last;
        return std::pair(first, last);
    };
    const auto [column0, column1] = range(lines.x, widthAt_, lowX, highX);
    const auto [row0, row1] = range(lines.y, heightAt_, lowY, highY);
    for (int row = row0; row <= row1; ++row)
        for (int column = column0; column <= column1; ++column) {
            char& inner = fill_->inner[at(lattice_->corner(column, row))];
            if (!inner) continue;
            const double x = lines.x[column], y = lines.y[row];
            const double scaleX = perWidth_[at(column)], scaleY = perHeight_[at(row)];
            const Vec2 a{(segment.a.x - x) * scaleX, (segment.a.y - y) * scaleY};
            const Vec2 b{(segment.b.x - x) * scaleX, (segment.b.y - y) * scaleY};
            const double radius = cleared_ / coarsestAt(column, row);
            inner = squaredDistance(a, b) >= radius * radius * (1 - 1e-9);
        }
}

/// The smallest u of the main cells at a corner.
int GridFiller::coarsestAt(int column, int row) const {
    if (lattice_->isUniform()) return 1;
    int coarsest = 0;
    for (const int c : {column - 1, column})
        for (const int r : {row - 1, row})
            if (const int u = lattice_->activeDivision(c, r); u > 0) coarsest = coarsest ? std::min(coarsest, u) : u;
    return std::max(coarsest, 1);
}

/// Clears the nodes of a main cell beyond its corners.
void GridFiller::clearDivided(const BorderSegment& segment, int column, int row, int u) {
    const IntegerLines& lines = fill_->lines;
    const double x0 = lines.x[column], y0 = lines.y[row];
    const double scaleX = frame_->unit / lattice_->width(column), scaleY = frame_->unit / lattice_->height(row);
    const Vec2 a{(segment.a.x - x0) * scaleX, (segment.a.y - y0) * scaleY};
    const Vec2 b{(segment.b.x - x0) * scaleX, (segment.b.y - y0) * scaleY};
    const auto range = [&](double low, double high) { // of node lines
        return std::pair(std::max(0, static_cast<int>(std::ceil((low - cleared_) * u))),
                         std::min(u, static_cast<int>(std::floor((high + cleared_) * u))));
    };
    const auto [a0, a1] = range(std::min(a.x, b.x), std::max(a.x, b.x));
    const auto [b0, b1] = range(std::min(a.y, b.y), std::max(a.y, b.y));
    for (int j = b0; j <= b1; ++j)
        for (int i = a0; i <= a1; ++i) {
            const int node = lattice_->nodeAt(column, row, i, j);
            if (node < lattice_->cornerCount() || !fill_->inner[at(node)]) continue;
            const Vec2 p{static_cast<double>(i) / u, static_cast<double>(j) / u};
            const double radius = cleared_ / coarsest_[at(node - lattice_->cornerCount())];
            if (squaredDistance(a - p, b - p) < radius * radius * (1 - 1e-9)) fill_->inner[at(node)] = 0;
        }
}

} // namespace toile::meshing
