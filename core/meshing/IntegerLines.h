// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/meshing/Lattice.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace toile::meshing {

/// Rising integer coordinates, and which interval between two of them a value lies in. A table of equal steps says
/// where to look, so that it takes a few instructions however many lines there are.
class IntegerAxis {
public:
    void assign(const std::vector<std::int32_t>& lines);
    /// The interval of a value, clamped to those there are.
    [[nodiscard]] int interval(std::int64_t value) const {
        if (value <= lines_.front()) return 0;
        if (value >= lines_.back()) return count() - 2;
        const auto step = static_cast<std::size_t>((value - lines_.front()) >> shift_);
        const int low = table_[step], high = table_[step + 1];
        if (high - low <= 1) return low + (lines_[static_cast<std::size_t>(low) + 1] <= value ? 1 : 0);
        return static_cast<int>(std::upper_bound(lines_.begin() + low, lines_.begin() + high + 1, value) -
                                lines_.begin()) -
               1;
    }
    /// The first line that is no less than the value; one past the last if there is none.
    [[nodiscard]] int firstFrom(std::int64_t value) const;
    [[nodiscard]] std::int32_t operator[](int line) const { return lines_[static_cast<std::size_t>(line)]; }
    [[nodiscard]] int count() const { return static_cast<int>(lines_.size()); }

private:
    std::vector<std::int32_t> lines_;
    std::vector<int> table_; ///< the interval in which each step begins
    int shift_ = 0;          ///< of a step's width, a power of two
};

constexpr int sameNode = 2; ///< border and lattice nodes this near are one [units]

/// The main lines on the integer grid.
struct IntegerLines {
    IntegerAxis x, y;

    void assign(const PieceFrame& frame, const Lattice& lattice);

private:
    std::vector<std::int32_t> rounded_;
};

} // namespace toile::meshing
