// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <memory_resource>
#include <vector>

namespace toile {

/// Memory for what a computation works in, if it is done again and again: handed out piece after piece, taken back all
/// at once, and kept. A computation that needs no more than those before it takes none from the system. For one thread.
///
///     std::pmr::vector<int> found(&arena);
class Arena final : public std::pmr::memory_resource {
public:
    /// Takes all back: nothing may live in the arena any longer.
    void rewind();

private:
    struct Block {
        std::unique_ptr<std::byte[]> bytes;
        std::size_t size = 0;
    };

    void* do_allocate(std::size_t bytes, std::size_t alignment) override;
    void do_deallocate(void* memory, std::size_t bytes, std::size_t alignment) override;
    [[nodiscard]] bool do_is_equal(const memory_resource& other) const noexcept override { return this == &other; }

    std::vector<Block> blocks_;
    std::size_t block_ = 0; ///< that is handed out of; those before it are full
    std::size_t used_ = 0;  ///< of it
};

} // namespace toile
