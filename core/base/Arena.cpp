// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/Arena.h"

#include <algorithm>

namespace toile {

constexpr std::size_t firstBlock = 1 << 14; // bytes; each block has twice those of the one before

void Arena::rewind() {
    block_ = used_ = 0;
}

void* Arena::do_allocate(std::size_t bytes, std::size_t alignment) {
    for (; block_ < blocks_.size(); ++block_, used_ = 0) {
        Block& block = blocks_[block_];
        void* free = block.bytes.get() + used_;
        std::size_t left = block.size - used_;
        if (!std::align(alignment, bytes, free, left)) continue;
        used_ = block.size - left + bytes;
        return free;
    }
    const std::size_t size = std::max(blocks_.empty() ? firstBlock : 2 * blocks_.back().size, bytes + alignment);
    blocks_.push_back({std::make_unique_for_overwrite<std::byte[]>(size), size});
    return do_allocate(bytes, alignment);
}

/// What was handed out last is handed out again; the rest waits for all to be taken back.
void Arena::do_deallocate(void* memory, std::size_t bytes, std::size_t) {
    if (block_ == blocks_.size() || bytes > used_) return;
    std::byte* const last = blocks_[block_].bytes.get() + used_ - bytes;
    if (memory == last) used_ -= bytes;
}

} // namespace toile
