// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/batch/Pictures.h"

#include "core/picture/Image.h"
#include "core/picture/RenderPicture.h"

#include <array>
#include <filesystem>

namespace toile::batch {
namespace {

constexpr int pictureWidth = 900, pictureHeight = 1200; // [px]

picture::ViewDirection directionOf(const std::string& file) {
    using picture::ViewDirection;
    static const std::array<std::pair<const char*, ViewDirection>, 5> names{{{"front", ViewDirection::front},
                                                                             {"back", ViewDirection::back},
                                                                             {"left", ViewDirection::left},
                                                                             {"right", ViewDirection::right},
                                                                             {"top", ViewDirection::top}}};
    const std::string stem = std::filesystem::path(file).stem().string();
    for (const auto& [name, direction] : names)
        if (stem.find(name) != std::string::npos) return direction;
    return ViewDirection::front;
}

} // namespace

Result<void> writePictures(const std::vector<std::string>& files, const simulation::Frame& frame,
                           const std::optional<Shared<body::Body>>& body) {
    picture::RenderScene scene;
    scene.body = body;
    scene.frame = Shared<simulation::Frame>(frame);
    for (const std::string& file : files) {
        const auto image = picture::renderPicture(scene, directionOf(file), pictureWidth, pictureHeight);
        if (!image) return tl::unexpected(image.error());
        if (auto written = picture::writePng(file, *image); !written) return written;
    }
    return {};
}

} // namespace toile::batch
