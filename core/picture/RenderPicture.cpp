// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/picture/RenderPicture.h"

#include "core/picture/OffscreenGl.h"

namespace toile::picture {

namespace {

Camera fittedTo(const RenderScene& scene, const Camera& direction, Viewport viewport) {
    const auto box = boundsOf(scene);
    return box ? fitted(direction, viewport, *box) : direction;
}

} // namespace

Result<Image> renderPicture(const RenderScene& scene, const Camera& camera, int width, int height) {
    auto gl = OffscreenGl::create();
    if (!gl) return tl::unexpected(gl.error());
    const auto large = gl->render(scene, camera, {2 * width, 2 * height}, 2);
    if (!large) return large;
    return halved(*large);
}

Result<Image> renderPicture(const RenderScene& scene, ViewDirection direction, int width, int height) {
    return renderPicture(scene, fittedTo(scene, lookingFrom(direction, {}), {width, height}), width, height);
}

Result<void> renderMesh(const geometry::TriangleMesh& mesh, const std::filesystem::path& png, bool edges,
                        Camera direction) {
    constexpr int width = 1000, height = 1000;
    RenderScene scene;
    scene.options.floor = false;
    scene.body = Shared(body::Body{.mesh = mesh});
    if (edges) // the three sides of a triangle as one line
        for (const auto& [a, b, c] : mesh.triangles)
            scene.overlay.push_back({{mesh.vertices[a], mesh.vertices[b], mesh.vertices[c], mesh.vertices[a]},
                                     {0.1f, 0.12f, 0.16f, 0.5f},
                                     0.7,
                                     false});
    const auto image = renderPicture(scene, fittedTo(scene, direction, {width, height}), width, height);
    if (!image) return tl::unexpected(image.error());
    return writePng(png, *image);
}

} // namespace toile::picture
