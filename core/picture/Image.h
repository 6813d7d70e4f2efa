// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Result.h"

#include <cstdint>
#include <filesystem>
#include <vector>

namespace toile::picture {

/// Pixels from the top left, row by row, four bytes each: red, green, blue, opacity.
struct Image {
    int width = 0, height = 0;
    std::vector<std::uint8_t> rgba; ///< width × height × 4
    friend bool operator==(const Image&, const Image&) = default;
};

/// Half the width and height: each pixel is the mean of four. Width and height must be even.
[[nodiscard]] Image halved(const Image& image);

/// The image as the bytes of a PNG file.
[[nodiscard]] Result<std::string> pngBytes(const Image& image);
/// Writes a PNG file, whole or not at all.
[[nodiscard]] Result<void> writePng(const std::filesystem::path& path, const Image& image);

} // namespace toile::picture
