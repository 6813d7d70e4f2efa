// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/meshing/IntegerLines.h"
#include "core/base/Index.h"

#include <algorithm>

namespace toile::meshing {
void IntegerAxis::assign(const std::vector<std::int32_t>& lines) {
    lines_ = lines;
    const std::int64_t range = std::int64_t{lines_.back()} - lines_.front();
    for (shift_ = 0; (range >> shift_) > 2 * std::int64_t{count()};) ++shift_;
    table_.resize(static_cast<std::size_t>(range >> shift_) + 2);
    int line = 0;
    for (std::size_t step = 0; step < table_.size(); ++step) {
        const std::int64_t start = lines_.front() + (static_cast<std::int64_t>(step) << shift_);
        while (line + 2 < count() && lines_[at(line) + 1] <= start) ++line;
        table_[step] = line;
    }
}

int IntegerAxis::firstFrom(std::int64_t value) const {
    int line = interval(value);
    while (line < count() && lines_[at(line)] < value) ++line;
    while (line > 0 && lines_[at(line) - 1] >= value) --line; // lines may coincide on the grid
    return line;
}

void IntegerLines::assign(const PieceFrame& frame, const Lattice& lattice) {
    rounded_.clear();
    for (const double line : lattice.mainX()) rounded_.push_back(frame.gridOf({line, 0}).x);
    x.assign(rounded_);
    rounded_.clear();
    for (const double line : lattice.mainY()) rounded_.push_back(frame.gridOf({0, line}).y);
    y.assign(rounded_);
}

} // namespace toile::meshing
