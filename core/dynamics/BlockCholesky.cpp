// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/dynamics/BlockCholesky.h"

#include "core/base/Contracts.h"
#include "core/base/Memory.h"

#include <algorithm>
#include <cholmod.h>
#include <initializer_list>

// More threads cost time here: docs/dependencies.md. Both functions may be missing, with another BLAS or a
// CHOLMOD built without OpenMP.
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
    void orderBy(std::initializer_list<int> kinds) {
        common.nmethods = 0;
        for (const int kind : kinds) common.method[common.nmethods++].ordering = kind;
    }
    [[nodiscard]] bool failed() const { return common.status < CHOLMOD_OK; } // warnings are above
    /// Values in double precision and, for statics, once more in single; both with their rows.
    [[nodiscard]] std::size_t neededBytes() const {
        if (!factor || !factor->is_super) return static_cast<std::size_t>(12 * std::max(common.lnz, 1.0));
        return 12 * factor->xsize + 8 * factor->ssize + sizeof(double) * factor->maxcsize;
    }
    void clear() {
        if (factor) cholmod_free_factor(&factor, &common);
        if (matrix) cholmod_free_sparse(&matrix, &common);
    }

    cholmod_common common{};
    cholmod_sparse* matrix = nullptr;
    cholmod_factor* factor = nullptr;
};

BlockCholesky::BlockCholesky(int blocks, std::optional<std::size_t> factorBytes)
    : BlockMatrix(blocks), factor_(std::make_unique<Factor>()), factorBytes_(factorBytes) {}
BlockCholesky::~BlockCholesky() = default;

/// The machine's memory is not taken to its end: vectors want some, and others meanwhile.
std::size_t BlockCholesky::factorRoom() const {
    constexpr double share = 0.9;
    if (factorBytes_) return *factorBytes_;
    return static_cast<std::size_t>(share * static_cast<double>(availableMemory()));
}

bool BlockCholesky::refuse() {
    refused_ = factor_->neededBytes();
    factor_->clear();
    return false;
}

bool BlockCholesky::analyse() {
    Factor& f = *factor_;
    f.clear();
    f.common.status = CHOLMOD_OK;
    if (!prepareMatrix()) return refuse();
    auto order = orderOfBlocks();
    if (!order) return refuse();
    f.orderBy({CHOLMOD_GIVEN});
    f.factor = cholmod_analyze_p(f.matrix, order->data(), nullptr, 0, &f.common);
    if (f.failed() || !f.factor || f.neededBytes() > factorRoom()) return refuse();
    analysedBlocks_ = pattern().size();
    ++analyses_;
    return true;
}

bool BlockCholesky::prepareMatrix() {
    Factor& f = *factor_;
    const std::size_t n = 3 * static_cast<std::size_t>(blockCount());
    const std::size_t entries = 9 * pattern().size() - 3 * static_cast<std::size_t>(blockCount());
    f.matrix = cholmod_allocate_sparse(n, n, entries, 1, 1, -1, CHOLMOD_REAL, &f.common);
    if (!f.matrix) return false;
    auto* const columns = static_cast<int*>(f.matrix->p);
    auto* const rows = static_cast<int*>(f.matrix->i);
    int entry = 0;
    for (std::size_t begin = 0; begin < pattern().size();) {
        const int column = columnOf(pattern()[begin]);
        std::size_t end = begin;
        while (end < pattern().size() && columnOf(pattern()[end]) == column) ++end;
        for (int c = 0; c < 3; ++c) {
            columns[3 * column + c] = entry;
            for (std::size_t b = begin; b < end; ++b) {
                const int row = rowOf(pattern()[b]);
                for (int r = b == begin ? c : 0; r < 3; ++r) rows[entry++] = 3 * row + r;
            }
        }
        begin = end;
    }
    columns[n] = entry;
    return true;
}

/// Rows of a block stay together: the order is found for blocks, of which there are a ninth as many places. Of two
/// kinds of order the one that fills less is taken; dissection, where it is there, also leaves subtrees to share out.
/// Absent without the memory for it.
std::optional<std::vector<int>> BlockCholesky::orderOfBlocks() {
    Factor& f = *factor_;
    const std::size_t n = blockCount();
    cholmod_sparse* blocks = cholmod_allocate_sparse(n, n, pattern().size(), 1, 1, -1, CHOLMOD_PATTERN, &f.common);
    if (!blocks) return std::nullopt;
    auto* const columns = static_cast<int*>(blocks->p);
    auto* const rows = static_cast<int*>(blocks->i);
    int column = 0;
    for (std::size_t place = 0; place < pattern().size(); ++place) {
        while (column <= columnOf(pattern()[place])) columns[column++] = static_cast<int>(place);
        rows[place] = rowOf(pattern()[place]);
    }
    columns[n] = static_cast<int>(pattern().size());
    f.orderBy({CHOLMOD_AMD, CHOLMOD_METIS});
    cholmod_factor* ordered = cholmod_analyze(blocks, &f.common);
    std::vector<int> order;
    for (std::size_t b = 0; ordered && b < n; ++b)
        for (int k = 0; k < 3; ++k) order.push_back(3 * static_cast<const int*>(ordered->Perm)[b] + k);
    cholmod_free_sparse(&blocks, &f.common);
    if (!ordered) return std::nullopt;
    cholmod_free_factor(&ordered, &f.common);
    return order;
}

void BlockCholesky::writeValues(std::span<const double> shift) {
    auto* const to = static_cast<double*>(factor_->matrix->x);
    int entry = 0;
    for (std::size_t begin = 0; begin < pattern().size();) {
        const int column = columnOf(pattern()[begin]);
        std::size_t end = begin;
        while (end < pattern().size() && columnOf(pattern()[end]) == column) ++end;
        for (int c = 0; c < 3; ++c)
            for (std::size_t b = begin; b < end; ++b)
                for (int r = b == begin ? c : 0; r < 3; ++r)
                    to[entry++] = block(b)[3 * r + c] + (b == begin && r == c ? shift[column] : 0);
        begin = end;
    }
}

bool BlockCholesky::factorize(std::span<const double> shift) {
    expects(static_cast<int>(shift.size()) == blockCount(), "one shift per block");
    settlePattern();
    if (refused_ > 0 || (pattern().size() != analysedBlocks_ && !analyse())) return false;
    writeValues(shift);
    ++factorizations_;
    Factor& f = *factor_;
    f.stayOnOneThread();
    f.common.status = CHOLMOD_OK;
    cholmod_factorize(f.matrix, f.factor, &f.common);
    if (f.failed()) return refuse();
    return f.common.status == CHOLMOD_OK && f.factor->minor == f.factor->n;
}

std::optional<std::vector<Vec3>> BlockCholesky::solve(std::span<const Vec3> b) {
    Factor& f = *factor_;
    const std::size_t n = 3 * b.size();
    cholmod_dense* right = cholmod_allocate_dense(n, 1, n, CHOLMOD_REAL, &f.common);
    for (std::size_t i = 0; right && i < n; ++i) static_cast<double*>(right->x)[i] = b[i / 3][static_cast<int>(i % 3)];
    cholmod_dense* solution = right ? cholmod_solve(CHOLMOD_A, f.factor, right, &f.common) : nullptr;
    cholmod_free_dense(&right, &f.common);
    if (!solution) {
        (void)refuse();
        return std::nullopt;
    }
    std::vector<Vec3> x(b.size());
    for (std::size_t i = 0; i < n; ++i) x[i / 3][static_cast<int>(i % 3)] = static_cast<double*>(solution->x)[i];
    cholmod_free_dense(&solution, &f.common);
    return x;
}

SupernodalFactor BlockCholesky::factor() const {
    const cholmod_factor& f = *factor_->factor;
    const auto ints = [](const void* from, std::size_t count) {
        return std::span(static_cast<const int*>(from), count);
    };
    return {ints(f.super, f.nsuper + 1), ints(f.pi, f.nsuper + 1), ints(f.px, f.nsuper + 1),
            ints(f.s, f.ssize),          ints(f.Perm, f.n),        std::span(static_cast<const double*>(f.x), f.xsize)};
}

std::size_t BlockCholesky::bytes() const {
    return BlockMatrix::bytes() + factor_->common.memory_inuse;
}

} // namespace toile::dynamics
