// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/picture/Camera.h"
#include "core/picture/Image.h"
#include "core/picture/RenderScene.h"

namespace toile::picture {

/// A still picture with smooth edges: drawn at twice the size and averaged. Needs no window, no display and
/// no Qt.
[[nodiscard]] Result<Image> renderPicture(const RenderScene& scene, const Camera& camera, int width, int height);

/// The scene from a direction, filling the picture.
[[nodiscard]] Result<Image> renderPicture(const RenderScene& scene, ViewDirection direction, int width, int height);

/// A mesh alone, seen from a little to the side and above, its edges drawn if wanted, as a PNG file.
[[nodiscard]] Result<void> renderMesh(const geometry::TriangleMesh& mesh, const std::filesystem::path& png,
                                      bool edges = false, Camera direction = {.yaw = 0.5, .pitch = 0.15});

} // namespace toile::picture
