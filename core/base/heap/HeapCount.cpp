// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/heap/HeapCount.h"

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <new>

namespace {

std::atomic<std::size_t> blocks{0}, bytes{0};

} // namespace

void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
    blocks.fetch_add(1, std::memory_order_relaxed);
    bytes.fetch_add(size, std::memory_order_relaxed);
    return std::malloc(size > 0 ? size : 1);
}
void* operator new(std::size_t size) {
    if (void* block = operator new(size, std::nothrow)) return block;
    throw std::bad_alloc();
}
void* operator new(std::size_t size, std::align_val_t alignment) { // what polymorphic containers ask for
    blocks.fetch_add(1, std::memory_order_relaxed);
    bytes.fetch_add(size, std::memory_order_relaxed);
    const auto step = static_cast<std::size_t>(alignment);
    if (void* block = std::aligned_alloc(step, (std::max(size, step) + step - 1) / step * step)) return block;
    throw std::bad_alloc();
}
void operator delete(void* block) noexcept {
    std::free(block);
}
void operator delete(void* block, std::align_val_t) noexcept {
    std::free(block);
}
void operator delete(void* block, std::size_t, std::align_val_t) noexcept {
    std::free(block);
}
void operator delete(void* block, std::size_t) noexcept {
    std::free(block);
}

namespace toile {

HeapCount heapTaken() {
    return {blocks.load(std::memory_order_relaxed), bytes.load(std::memory_order_relaxed)};
}

} // namespace toile
