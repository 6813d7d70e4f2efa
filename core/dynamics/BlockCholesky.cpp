// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/dynamics/BlockCholesky.h"

#include "core/base/Contracts.h"

#include <algorithm>
#include <cholmod.h>
#include <numeric>

// More threads cost time here: docs/dependencies.md. Both functions may be missing, with another BLAS or a CHOLMOD
// built without OpenMP.
extern "C" {
void openblas_set_num_threads(int) __attribute__((weak));
void omp_set_max_active_levels(int) __attribute__((weak));
}

namespace toile::dynamics {

struct BlockCholesky::Factor {
    Factor() {
        cholmod_start(&common);
        common.supernodal = CHOLMOD_SUPERNODAL;
        common.print = 0;
        common.quick_return_if_not_posdef = 1;
        common.try_catch = 1; // "not positive definite" is an answer, not a message
        stayOnOneThread();
    }
    ~Factor() {
        clear();
        cholmod_finish(&common);
    }
    static void stayOnOneThread() {
        if (openblas_set_num_threads) openblas_set_num_threads(1);
        if (omp_set_max_active_levels) omp_set_max_active_levels(0); // holds for the calling thread
    }
    void clear() {
        if (factor) cholmod_free_factor(&factor, &common);
        if (matrix) cholmod_free_sparse(&matrix, &common);
    }

    cholmod_common common{};
    cholmod_sparse* matrix = nullptr;
    cholmod_factor* factor = nullptr;
};

BlockCholesky::BlockCholesky(int blocks) : blocks_(blocks), factor_(std::make_unique<Factor>()) {}
BlockCholesky::~BlockCholesky() = default;

void BlockCholesky::clear() {
    std::ranges::fill(values_, 0.0);
    newKeys_.clear();
    newValues_.clear();
    call_ = 0;
}

void BlockCholesky::add(int i, int j, const double (&block)[9]) {
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

void BlockCholesky::mergeNewBlocks() {
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
}

void BlockCholesky::analyse() {
    Factor& f = *factor_;
    f.clear();
    const std::size_t n = 3 * static_cast<std::size_t>(blocks_);
    const std::size_t entries = 9 * pattern_.size() - 3 * static_cast<std::size_t>(blocks_);
    f.matrix = cholmod_allocate_sparse(n, n, entries, 1, 1, -1, CHOLMOD_REAL, &f.common);
    expects(f.matrix != nullptr, "memory for the matrix");
    auto* const columns = static_cast<int*>(f.matrix->p);
    auto* const rows = static_cast<int*>(f.matrix->i);
    int entry = 0;
    for (std::size_t begin = 0; begin < pattern_.size();) {
        const Key column = pattern_[begin] >> 32;
        std::size_t end = begin;
        while (end < pattern_.size() && (pattern_[end] >> 32) == column) ++end;
        for (int c = 0; c < 3; ++c) {
            columns[3 * column + c] = entry;
            for (std::size_t b = begin; b < end; ++b) {
                const int row = static_cast<int>(pattern_[b] & 0xffffffffu);
                for (int r = b == begin ? c : 0; r < 3; ++r) rows[entry++] = 3 * row + r;
            }
        }
        begin = end;
    }
    columns[n] = entry;
    f.factor = cholmod_analyze(f.matrix, &f.common);
    expects(f.factor != nullptr, "memory for the factor");
    ++analyses_;
}

void BlockCholesky::writeValues(std::span<const double> shift) {
    auto* const to = static_cast<double*>(factor_->matrix->x);
    int entry = 0;
    for (std::size_t begin = 0; begin < pattern_.size();) {
        const Key column = pattern_[begin] >> 32;
        std::size_t end = begin;
        while (end < pattern_.size() && (pattern_[end] >> 32) == column) ++end;
        for (int c = 0; c < 3; ++c)
            for (std::size_t b = begin; b < end; ++b)
                for (int r = b == begin ? c : 0; r < 3; ++r)
                    to[entry++] = values_[9 * b + 3 * r + c] + (b == begin && r == c ? shift[column] : 0);
        begin = end;
    }
}

bool BlockCholesky::factorize(std::span<const double> shift) {
    expects(static_cast<int>(shift.size()) == blocks_, "one shift per block");
    const bool grown = !newKeys_.empty() || pattern_.empty();
    if (grown) mergeNewBlocks();
    if (grown || !factor_->factor) analyse();
    writeValues(shift);
    ++factorizations_;
    Factor& f = *factor_;
    f.stayOnOneThread();
    f.common.status = CHOLMOD_OK;
    cholmod_factorize(f.matrix, f.factor, &f.common);
    return f.common.status == CHOLMOD_OK && f.factor->minor == f.factor->n;
}

std::vector<Vec3> BlockCholesky::solve(std::span<const Vec3> b) {
    Factor& f = *factor_;
    const std::size_t n = 3 * b.size();
    cholmod_dense* right = cholmod_allocate_dense(n, 1, n, CHOLMOD_REAL, &f.common);
    expects(right != nullptr, "memory for a vector");
    for (std::size_t i = 0; i < n; ++i) static_cast<double*>(right->x)[i] = b[i / 3][static_cast<int>(i % 3)];
    cholmod_dense* solution = cholmod_solve(CHOLMOD_A, f.factor, right, &f.common);
    expects(solution != nullptr, "memory for a vector");
    std::vector<Vec3> x(b.size());
    for (std::size_t i = 0; i < n; ++i) x[i / 3][static_cast<int>(i % 3)] = static_cast<double*>(solution->x)[i];
    cholmod_free_dense(&right, &f.common);
    cholmod_free_dense(&solution, &f.common);
    return x;
}

std::size_t BlockCholesky::bytes() const {
    const auto of = [](const auto& v) { return v.capacity() * sizeof(v[0]); };
    return of(pattern_) + of(values_) + of(callKeys_) + of(callSlots_) + factor_->common.memory_inuse;
}

} // namespace toile::dynamics
