// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace toile {

/// What a program has asked operator new for since it began, on all threads. What is freed is not taken off.
struct HeapCount {
    std::size_t blocks = 0, bytes = 0;
    friend HeapCount operator-(const HeapCount& a, const HeapCount& b) {
        return {a.blocks - b.blocks, a.bytes - b.bytes};
    }
    friend bool operator==(const HeapCount&, const HeapCount&) = default;
};

/// A program that links this library gets operators new and delete that count. What calls malloc itself (Eigen,
/// CHOLMOD) is not seen.
[[nodiscard]] HeapCount heapTaken();

} // namespace toile
