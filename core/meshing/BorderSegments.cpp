// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/meshing/BorderSegments.h"
#include "core/base/Index.h"

#include <algorithm>

namespace toile::meshing {
void BorderSegments::assign(const BoundaryNodes& boundary, const IntegerLines& lines) {
    segments_.clear();
    for (const auto& ring : boundary.rings)
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const int a = ring[i], b = ring[i + 1 < ring.size() ? i + 1 : 0];
            segments_.push_back({boundary.grid[at(a)], boundary.grid[at(b)], a, b});
        }
    for (const auto& fold : boundary.folds) // what enters the inside across a fold has left it there
        for (std::size_t i = 0; i + 1 < fold.size(); ++i)
            for (const auto& [a, b] : {std::pair(fold[i], fold[i + 1]), std::pair(fold[i + 1], fold[i])})
                segments_.push_back({boundary.grid[at(a)], boundary.grid[at(b)], a, b, true});
    sortIntoRows(lines);
}

void BorderSegments::assign(const std::vector<std::vector<GridPoint>>& rings, const IntegerLines& lines) {
    segments_.clear();
    for (const auto& ring : rings)
        for (std::size_t i = 0; i < ring.size(); ++i)
            segments_.push_back({ring[i], ring[i + 1 < ring.size() ? i + 1 : 0], 0, 0, false});
    sortIntoRows(lines);
}

void BorderSegments::sortIntoRows(const IntegerLines& lines) {
    const auto forEachRow = [&](auto use) {
        for (std::size_t s = 0; s < segments_.size(); ++s) {
            const auto [low, high] = std::minmax(segments_[s].a.y, segments_[s].b.y);
            const int last = lines.y.interval(high);
            for (int row = lines.y.interval(low); row <= last; ++row) use(at(row), static_cast<int>(s));
        }
    };
    firstOfRow_.assign(at(lines.y.count()) + 1, 0);
    forEachRow([&](std::size_t row, int) { ++firstOfRow_[row + 1]; });
    for (std::size_t row = 1; row < firstOfRow_.size(); ++row) firstOfRow_[row] += firstOfRow_[row - 1];
    byRow_.resize(at(firstOfRow_.back()));
    forEachRow([&](std::size_t row, int segment) { byRow_[at(firstOfRow_[row]++)] = segment; });
    std::copy_backward(firstOfRow_.begin(), firstOfRow_.end() - 1, firstOfRow_.end());
    firstOfRow_.front() = 0;
}

std::span<const std::int64_t> BorderSegments::crossings(std::int32_t y, int row) {
    crossings_.clear();
    for (int k = firstOfRow_[at(row)]; k < firstOfRow_[at(row) + 1]; ++k) {
        GridPoint a = segments_[at(byRow_[at(k)])].a, b = segments_[at(byRow_[at(k)])].b;
        if (a.y > b.y) std::swap(a, b);
        if (y < a.y || y >= b.y) continue;
        const std::int64_t numerator = (std::int64_t{y} - a.y) * (std::int64_t{b.x} - a.x),
                           height = std::int64_t{b.y} - a.y;
        std::int64_t quotient = numerator / height;
        if (numerator % height < 0) --quotient; // towards minus infinity
        crossings_.push_back(a.x + quotient + 1);
    }
    std::sort(crossings_.begin(), crossings_.end());
    return crossings_;
}

void markActiveCells(const IntegerLines& lines, BorderSegments& segments, Lattice& lattice) {
    std::fill(lattice.active.begin(), lattice.active.end(), char{0});
    for (int row = 0; row < lattice.rows(); ++row) { // cells whose middle lies inside
        const std::int32_t middle = lines.y[row] + (lines.y[row + 1] - lines.y[row]) / 2;
        const auto crossings = segments.crossings(middle, row);
        for (std::size_t k = 0; k + 1 < crossings.size(); k += 2) {
            const auto firstMiddle = [&](std::int64_t x) {
                const int column = lines.x.interval(x);
                const bool before = lines.x[column] + (lines.x[column + 1] - lines.x[column]) / 2 < x;
                return lattice.active.begin() + lattice.cell(column, row) + before;
            };
            std::fill(firstMiddle(crossings[k]), firstMiddle(crossings[k + 1]), char{1});
        }
    }
    for (const BorderSegment& segment : segments.all()) { // and those that the border may meet
        const auto [lowX, highX] = std::minmax(segment.a.x, segment.b.x);
        const auto [lowY, highY] = std::minmax(segment.a.y, segment.b.y);
        const int column0 = lines.x.interval(std::int64_t{lowX} - sameNode);
        const int column1 = lines.x.interval(std::int64_t{highX} + sameNode);
        const int row1 = lines.y.interval(std::int64_t{highY} + sameNode);
        for (int row = lines.y.interval(std::int64_t{lowY} - sameNode); row <= row1; ++row)
            for (int column = column0; column <= column1; ++column) lattice.active[at(lattice.cell(column, row))] = 1;
    }
}

} // namespace toile::meshing
