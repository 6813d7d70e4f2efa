// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/dynamics/BlockMatrix.h"

#include <algorithm>
#include <array>

namespace toile::dynamics {
namespace {

/// A product is made of so many parts, whatever the number of threads: then the bits are the same for any …
constexpr std::size_t parts = 4;
/// … unless they would hold fewer blocks than this, some 20 µs of work.
constexpr std::size_t leastPart = 4000;

} // namespace

void BlockMatrix::clear() {
    std::ranges::fill(values_, 0.0);
    newKeys_.clear();
    newValues_.clear();
    call_ = 0;
}

void BlockMatrix::add(int i, int j, const double (&block)[9]) {
    if (i < j) return;
    const Key key = keyOf(i, j);
    int slot = -1;
    if (call_ < callKeys_.size() && callKeys_[call_] == key) {
        slot = callSlots_[call_];
    } else {
        const auto it = std::ranges::lower_bound(pattern_, key);
        if (it != pattern_.end() && *it == key) slot = static_cast<int>(it - pattern_.begin());
        if (call_ == callKeys_.size()) {
            callKeys_.push_back(key);
            callSlots_.push_back(slot);
        } else {
            callKeys_[call_] = key;
            callSlots_[call_] = slot;
        }
    }
    ++call_;
    if (slot >= 0) {
        double* const to = values_.data() + 9 * static_cast<std::size_t>(slot);
        for (int k = 0; k < 9; ++k) to[k] += block[k];
    } else {
        newKeys_.push_back(key);
        newValues_.insert(newValues_.end(), block, block + 9);
    }
}

bool BlockMatrix::settlePattern() {
    if (newKeys_.empty() && !pattern_.empty()) return false;
    std::vector<Key> pattern = pattern_;
    pattern.insert(pattern.end(), newKeys_.begin(), newKeys_.end());
    if (pattern_.empty())
        for (int b = 0; b < blocks_; ++b) pattern.push_back(keyOf(b, b)); // for the shift
    std::ranges::sort(pattern);
    pattern.erase(std::ranges::unique(pattern).begin(), pattern.end());
    std::vector<double> values(9 * pattern.size(), 0.0);
    const auto addAll = [&](const std::vector<Key>& keys, const std::vector<double>& from) {
        for (std::size_t b = 0; b < keys.size(); ++b) {
            const auto slot = std::ranges::lower_bound(pattern, keys[b]) - pattern.begin();
            for (int k = 0; k < 9; ++k) values[9 * slot + k] += from[9 * b + k];
        }
    };
    addAll(pattern_, values_);
    addAll(newKeys_, newValues_);
    pattern_ = std::move(pattern);
    values_ = std::move(values);
    newKeys_ = {};
    newValues_ = {};
    callKeys_.clear(); // places have moved
    callSlots_.clear();
    call_ = 0;
    return true;
}

void BlockMatrix::multiplyPart(std::size_t begin, std::size_t end, std::span<const Vec3> x, Vec3* result,
                               int first) const {
    const double* a = block(begin);
    for (std::size_t place = begin; place < end; ++place, a += 9) {
        const int row = rowOf(pattern_[place]), column = columnOf(pattern_[place]);
        const Vec3& right = x[column];
        result[row - first] +=
            Vec3{a[0] * right.x + a[1] * right.y + a[2] * right.z, a[3] * right.x + a[4] * right.y + a[5] * right.z,
                 a[6] * right.x + a[7] * right.y + a[8] * right.z};
        if (row == column) continue;
        const Vec3& left = x[row];
        result[column - first] +=
            Vec3{a[0] * left.x + a[3] * left.y + a[6] * left.z, a[1] * left.x + a[4] * left.y + a[7] * left.z,
                 a[2] * left.x + a[5] * left.y + a[8] * left.z};
    }
}

void BlockMatrix::multiply(std::span<const double> shift, std::span<const Vec3> x, std::span<Vec3> result,
                           Team* team) const {
    for (std::size_t i = 0; i < x.size(); ++i) result[i] = shift[i] * x[i];
    if (pattern_.size() < parts * leastPart) return multiplyPart(0, pattern_.size(), x, result.data(), 0);
    // Parts of whole columns, the first straight into the result. Of the lower half a part from column c on knows no
    // row above c.
    std::array<std::size_t, parts + 1> border{};
    for (std::size_t part = 1; part <= parts; ++part) {
        border[part] = pattern_.size() * part / parts;
        while (border[part] < pattern_.size() &&
               columnOf(pattern_[border[part]]) == columnOf(pattern_[border[part] - 1]))
            ++border[part];
    }
    std::array<std::vector<Vec3>, parts> sums;
    const auto firstOf = [&](int part) { return columnOf(pattern_[border[part]]); };
    inParts(team, static_cast<int>(parts), 1, [&](int begin, int end) {
        for (int part = begin; part < end; ++part) {
            if (part > 0) sums[part].resize(x.size() - firstOf(part));
            multiplyPart(border[part], border[part + 1], x, part > 0 ? sums[part].data() : result.data(),
                         part > 0 ? firstOf(part) : 0);
        }
    });
    for (int part = 1; part < static_cast<int>(parts); ++part)
        for (std::size_t i = 0; i < sums[part].size(); ++i) result[firstOf(part) + i] += sums[part][i];
}

std::size_t BlockMatrix::bytes() const {
    const auto of = [](const auto& v) { return v.capacity() * sizeof(v[0]); };
    return of(pattern_) + of(values_) + of(callKeys_) + of(callSlots_);
}

} // namespace toile::dynamics
