// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/meshing/GridPoint.h"
#include "core/meshing/KeyedNodes.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace toile::meshing {

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

/// Where a Morton curve runs over a lattice: its quadrants meet at a corner in the middle. Keys have 8 binary digits of
/// columns and rows behind the point.
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
/// corners: block by block. The next number is in hand; what visits returns that after it, or the same if it took none.
///   visitBlock(number, column, row)   the whole block of corners that starts there, in the order `orderInBlock`
///   visitCorner(number, column, row)
///   visitOther(number, node)          of `others`, which are sorted
template <class VisitBlock, class VisitCorner, class VisitOther>
class MortonWalk {
public:
    MortonWalk(const MortonSquare& square, int columns, int rows, const std::vector<KeyedNode>& others,
               VisitBlock visitBlock, VisitCorner visitCorner, VisitOther visitOther)
        : square_(square), columns_(columns), rows_(rows), others_(others), visitBlock_(visitBlock),
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
            number_ = visitBlock_(number_, column, row);
            return;
        }
        const VisitCorner visit = visitCorner_; // a copy of its own: what it writes cannot change it
        othersBefore(first);
        for (std::size_t k = 0; k < 64;) {
            const bool isLast = next_ == others_.size() || others_[next_].first >= first + (std::uint64_t{64} << 16);
            const std::size_t end = isLast ? 64 : ((others_[next_].first - first) >> 16) + 1;
            for (; k < end; ++k) {
                const int c = column + orderInBlock[k].x, r = row + orderInBlock[k].y;
                if (c >= 0 && r >= 0 && c < columns_ && r < rows_) number_ = visit(number_, c, r);
            }
            othersBefore(first + (std::uint64_t{k} << 16));
        }
    }

    void othersBefore(std::uint64_t key) {
        for (; next_ < others_.size() && others_[next_].first < key; ++next_)
            number_ = visitOther_(number_, others_[next_].second);
    }

    MortonSquare square_;
    int columns_, rows_;
    const std::vector<KeyedNode>& others_;
    VisitBlock visitBlock_;
    VisitCorner visitCorner_;
    VisitOther visitOther_;
    std::size_t next_ = 0; ///< of `others`
    int number_ = 0;
};

} // namespace toile::meshing
