// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>

namespace toile::meshing {

/// Eight flags at once, each 0 or 1.
inline std::uint64_t eight(const char* flags) {
    std::uint64_t all = 0;
    std::memcpy(&all, flags, sizeof all);
    return all;
}
constexpr std::uint64_t allEight = 0x0101010101010101ULL;

/// How many of them are set.
inline std::size_t countOf(std::span<const char> flags) {
    std::size_t count = 0, i = 0;
    for (; i + 8 <= flags.size(); i += 8) count += (eight(flags.data() + i) * allEight) >> 56; // the sum of its bytes
    for (; i < flags.size(); ++i) count += static_cast<std::size_t>(flags[i]);
    return count;
}

} // namespace toile::meshing
