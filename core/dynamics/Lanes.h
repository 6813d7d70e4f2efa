// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Four numbers at once. Compiled once for each kind of processor by the files that include it, hence without names
// that another file could see.

#include <cstdint>

#pragma GCC diagnostic ignored "-Wpsabi" // all of it is inlined

namespace toile::dynamics {
namespace {

#define TOILE_LANES [[gnu::always_inline]] inline

using Four = double __attribute__((vector_size(32)));
using FourFlags = std::int64_t __attribute__((vector_size(32))); ///< −1 = yes
using FourInMemory = Four __attribute__((may_alias));
using FourAnywhere = Four __attribute__((may_alias, aligned(8)));
using FourFloats [[gnu::may_alias]] = float __attribute__((vector_size(16)));
using FourFloatsAnywhere [[gnu::may_alias]] = float __attribute__((vector_size(16), aligned(4)));

TOILE_LANES Four all(double value) {
    return Four{value, value, value, value};
}

} // namespace
} // namespace toile::dynamics
