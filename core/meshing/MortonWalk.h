// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/meshing/GridPoint.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace toile::meshing {

/// A node and its place along a Morton curve of the lattice: columns and rows with 8 binary digits behind the point.
using KeyedNode = std::pair<std::uint64_t, int>;

/// Columns and rows of a block of 8 × 8 along the curve.
struct BlockOffset {
    std::int8_t x, y;
};
constexpr std::array<BlockOffset, 64> orderInBlock = [] {
    std::array<BlockOffset, 64> order{};
    for (unsigned k = 0; k < 64; ++k)
        order[k] = {static_cast<std::int8_t>((k & 1) | ((k >> 1) & 2) | ((k >> 2) & 4)),
                    static_cast<std::int8_t>(((k >> 1) & 1) | ((k >> 2) & 2) | ((k >> 3) & 4))};
    return order;
}();

/// Sorts by key, then by node: counts over as many of the leading bits that vary as tell most nodes apart, then sorts
/// what is left. `buffer` is room to work in.
void sortByKey(std::vector<KeyedNode>& nodes, std::vector<KeyedNode>& buffer);

/// Where a Morton curve runs over a lattice: its quadrants meet at a corner in the middle.
struct MortonSquare {
    int size = 1;            ///< of its side in blocks of 8 × 8 corners, a power of two
    int column = 0, row = 0; ///< what is added to those of the lattice

    MortonSquare() = default;
    MortonSquare(int columns, int rows, int middleColumn, int middleRow) {
        while (4 * size < std::max({middleColumn, columns - middleColumn, middleRow, rows - middleRow})) size *= 2;
        column = 4 * size - middleColumn;
        row = 4 * size - middleRow;
    }
    /// The key of a place, given in 1/256 of columns and rows.
    [[nodiscard]] std::uint64_t key(int x, int y) const {
        return interleaved(static_cast<std::uint32_t>(x + 256 * column), static_cast<std::uint32_t>(y + 256 * row));
    }
};

/// Walks the corners of a lattice of columns × rows and other nodes between them along the curve, without sorting the
/// corners: block by block.
///   isEmpty(column, row)              nothing is to be visited in the whole block that starts there
///   visitCorner(number, column, row)  the next number is in hand; returns that after it, or the same where it took
///   none visitOther(number, node)          of `others`, which are sorted
template <class IsEmpty, class VisitCorner, class VisitOther>
class MortonWalk {
public:
    MortonWalk(const MortonSquare& square, int columns, int rows, const std::vector<KeyedNode>& others, IsEmpty isEmpty,
               VisitCorner visitCorner, VisitOther visitOther)
        : square_(square), columns_(columns), rows_(rows), others_(others), isEmpty_(isEmpty),
          visitCorner_(visitCorner), visitOther_(visitOther) {}

    /// Returns the number after the last.
    int run() {
        walk(0, 0, square_.size);
        othersBefore(~std::uint64_t{0});
        return number_;
    }

private:
    /// A square of blocks.
    void walk(int x, int y, int size) {
        const int column = 8 * x - square_.column, row = 8 * y - square_.row;
        if (column >= columns_ || row >= rows_ || column + 8 * size <= 0 || row + 8 * size <= 0) return;
        if (size == 1) return walkBlock(column, row);
        const int half = size / 2;
        walk(x, y, half);
        walk(x + half, y, half);
        walk(x, y + half, half);
        walk(x + half, y + half, half);
    }

    void walkBlock(int column, int row) {
        const std::uint64_t first = square_.key(256 * column, 256 * row);
        const bool alone = next_ == others_.size() || others_[next_].first >= first + (std::uint64_t{64} << 16);
        if (alone && column >= 0 && row >= 0 && column + 8 <= columns_ && row + 8 <= rows_) {
            if (isEmpty_(column, row)) return;
            const VisitCorner visit = visitCorner_; // a copy of its own: what it writes cannot change it
            int number = number_;
            for (const auto [x, y] : orderInBlock) number = visit(number, column + x, row + y);
            number_ = number;
            return;
        }
        for (std::size_t k = 0; k < 64; ++k) {
            const int c = column + orderInBlock[k].x, r = row + orderInBlock[k].y;
            othersBefore(first + (std::uint64_t{k} << 16));
            if (c >= 0 && r >= 0 && c < columns_ && r < rows_) number_ = visitCorner_(number_, c, r);
        }
    }

    void othersBefore(std::uint64_t key) {
        for (; next_ < others_.size() && others_[next_].first < key; ++next_)
            number_ = visitOther_(number_, others_[next_].second);
    }

    MortonSquare square_;
    int columns_, rows_;
    const std::vector<KeyedNode>& others_;
    IsEmpty isEmpty_;
    VisitCorner visitCorner_;
    VisitOther visitOther_;
    std::size_t next_ = 0; ///< of `others`
    int number_ = 0;
};

} // namespace toile::meshing
