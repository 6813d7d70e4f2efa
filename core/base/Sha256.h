// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <string>

namespace toile {

/// SHA-256 of the bytes as 64 hexadecimal digits. Ref: FIPS 180-4.
[[nodiscard]] std::string sha256(std::span<const std::byte> bytes);

} // namespace toile
