// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <cstring>
#include <png.h>
#include <set>
#include <vector>

namespace toile {

/// How many different colours a PNG file shows; 0 when it cannot be read. A blank picture has one.
inline std::size_t coloursIn(const QString& file) {
    png_image image;
    std::memset(&image, 0, sizeof image);
    image.version = PNG_IMAGE_VERSION;
    if (!png_image_begin_read_from_file(&image, file.toUtf8().constData())) return 0;
    image.format = PNG_FORMAT_RGB;
    std::vector<png_byte> pixels(PNG_IMAGE_SIZE(image));
    if (!png_image_finish_read(&image, nullptr, pixels.data(), 0, nullptr)) return 0;
    std::set<int> colours;
    for (std::size_t i = 0; i + 2 < pixels.size(); i += 3)
        colours.insert((pixels[i] << 16) + (pixels[i + 1] << 8) + pixels[i + 2]);
    return colours.size();
}

} // namespace toile
