// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/picture/Image.h"

#include "core/base/AtomicFile.h"
#include "core/base/Contracts.h"

#include <png.h>

#include <string>

namespace toile::picture {

Image halved(const Image& image) {
    expects(image.width % 2 == 0 && image.height % 2 == 0, "only even images can be halved");
    Image half{image.width / 2, image.height / 2, {}};
    half.rgba.resize(static_cast<std::size_t>(half.width) * half.height * 4);
    const std::size_t row = static_cast<std::size_t>(image.width) * 4;
    auto out = half.rgba.begin();
    for (int y = 0; y < half.height; ++y)
        for (int x = 0; x < half.width; ++x) {
            const std::uint8_t* corner = image.rgba.data() + 2 * y * row + 8 * static_cast<std::size_t>(x);
            for (int channel = 0; channel < 4; ++channel, ++corner)
                *out++ = static_cast<std::uint8_t>((corner[0] + corner[4] + corner[row] + corner[row + 4] + 2) / 4);
        }
    return half;
}

Result<std::string> pngBytes(const Image& image) {
    expects(image.rgba.size() == static_cast<std::size_t>(image.width) * image.height * 4,
            "an image has all its pixels");
    png_image header{};
    header.version = PNG_IMAGE_VERSION;
    header.width = static_cast<png_uint_32>(image.width);
    header.height = static_cast<png_uint_32>(image.height);
    header.format = PNG_FORMAT_RGBA;
    png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(header);
    std::string bytes(size, '\0');
    if (!png_image_write_to_memory(&header, bytes.data(), &size, 0, image.rgba.data(), 0, nullptr))
        return fail(ErrorCode::io, std::string("The picture could not be packed as PNG: ") + header.message + '.');
    bytes.resize(size);
    return bytes;
}

Result<void> writePng(const std::filesystem::path& path, const Image& image) {
    const auto bytes = pngBytes(image);
    if (!bytes) return tl::unexpected(bytes.error());
    return writeFileAtomically(path, *bytes);
}

} // namespace toile::picture
