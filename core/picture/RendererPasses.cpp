// SPDX-License-Identifier: GPL-3.0-or-later
// What the renderer draws, pass by pass.
#include "core/picture/RendererState.h"

#include <algorithm>

namespace toile::picture {

namespace {

constexpr Colour backgroundLow{0.71f, 0.73f, 0.76f}, backgroundHigh{0.91f, 0.92f, 0.93f};
constexpr Colour bodyColour{0.80f, 0.765f, 0.725f}; // the linen of a dress form
constexpr Colour selectionColour{1.0f, 0.66f, 0.22f};
constexpr Colour meshLineColour{0.08f, 0.10f, 0.14f, 0.50f};
constexpr double sparseLines = 14; // mesh lines this far apart have their full colour [px]

/// A dense mesh drawn in full colour would hide the cloth.
Colour faded(Colour colour, double pixelsApart) {
    colour.a *= static_cast<float>(std::clamp(pixelsApart / sparseLines, 0.25, 1.0));
    return colour;
}

} // namespace

void Renderer::State::drawShadowMap(const RenderScene& scene, const View& view) {
    GLint bound = 0;
    gl.GetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &bound);
    gl.BindFramebuffer(GL_FRAMEBUFFER, shadowMap.framebuffer);
    gl.Viewport(0, 0, shadowMap.size, shadowMap.size);
    gl.Clear(GL_DEPTH_BUFFER_BIT);
    gl.Enable(GL_POLYGON_OFFSET_FILL);
    gl.PolygonOffset(1.5f, 2.0f);
    const Uniforms uniforms(gl, programs.shadow);
    uniforms.set("shadowMatrix", view.shadow);
    if (showsBody(scene.options)) drawTriangles(gl, body);
    if (showsCloth(scene.options)) drawTriangles(gl, cloth);
    gl.Disable(GL_POLYGON_OFFSET_FILL);
    gl.BindFramebuffer(GL_FRAMEBUFFER, static_cast<GLuint>(bound));
}

void Renderer::State::drawBackground() {
    gl.Disable(GL_DEPTH_TEST);
    const Uniforms uniforms(gl, programs.background);
    uniforms.set("low", backgroundLow);
    uniforms.set("high", backgroundHigh);
    gl.BindVertexArray(emptyArray);
    gl.DrawArrays(GL_TRIANGLES, 0, 3);
    gl.Enable(GL_DEPTH_TEST);
}

void Renderer::State::setShadowUniforms(const Uniforms& uniforms, const View& view) const {
    gl.ActiveTexture(GL_TEXTURE0);
    gl.BindTexture(GL_TEXTURE_2D, shadowMap.texture);
    uniforms.set("shadowMap", 0);
    uniforms.set("shadowMatrix", view.shadow);
    uniforms.set("shadows", view.shadows);
    uniforms.set("shadowTexel", 1.0 / shadowMap.size);
}

void Renderer::State::drawSurfaces(const RenderScene& scene, const View& view) {
    const Uniforms uniforms(gl, programs.surface);
    uniforms.set("view", view.view);
    uniforms.set("projection", view.projection);
    uniforms.set("eye", view.eye);
    uniforms.set("keyDirection", view.lights.key);
    uniforms.set("fillDirection", view.lights.fill);
    uniforms.set("rimDirection", view.lights.rim);
    uniforms.set("bodyColour", bodyColour);
    uniforms.set("selectionColour", selectionColour);
    uniforms.set("triangleColours", 1);
    setShadowUniforms(uniforms, view);
    uniforms.set("cloth", false);
    if (showsBody(scene.options)) drawTriangles(gl, body);
    if (!showsCloth(scene.options)) return;
    uniforms.set("cloth", true);
    gl.ActiveTexture(GL_TEXTURE1);
    gl.BindTexture(GL_TEXTURE_BUFFER, colourTexture);
    gl.TexBuffer(GL_TEXTURE_BUFFER, GL_RGBA8, colourBuffer);
    drawTriangles(gl, cloth);
    gl.ActiveTexture(GL_TEXTURE0);
}

void Renderer::State::drawFloor(const Camera& camera, const View& view) {
    const Uniforms uniforms(gl, programs.floor);
    uniforms.set("view", view.view);
    uniforms.set("projection", view.projection);
    uniforms.set("centre", Vec3{camera.target.x, 0, camera.target.z});
    uniforms.set("radius", floorRadius);
    uniforms.set("eye", view.eye);
    setShadowUniforms(uniforms, view);
    gl.BindVertexArray(emptyArray);
    gl.DrawArrays(GL_TRIANGLE_STRIP, 0, 4);
}

Uniforms Renderer::State::lineUniforms(const View& view) const {
    Uniforms uniforms(gl, programs.line);
    uniforms.set("view", view.view);
    uniforms.set("projection", view.projection);
    uniforms.set("size", Vec2{static_cast<double>(view.viewport.width), static_cast<double>(view.viewport.height)});
    return uniforms;
}

void Renderer::State::drawClothLines(const RenderScene& scene, const View& view) {
    const Uniforms uniforms = lineUniforms(view);
    if (scene.options.meshLines) {
        uniforms.set("towardsEye", 0.0008);
        uniforms.set("width", 1.0 * view.lineScale);
        uniforms.set("lineColour",
                     faded(meshLineColour, meanLineLength / pixelSize(view.camera, view.viewport, view.camera.target)));
        drawLines(gl, cloth, meshLines);
    }
    uniforms.set("towardsEye", 0.0016);
    if (const auto selected = borders.find(scene.selectedPiece); selected != borders.end()) {
        uniforms.set("width", 4.5 * view.lineScale);
        uniforms.set("lineColour", selectionColour);
        drawLines(gl, cloth, selected->second);
    }
    if (!scene.options.seams) return;
    for (std::size_t i = 0; i < seams.size(); ++i) {
        Colour colour = i < scene.seamColours.size() ? scene.seamColours[i] : seamColour(i);
        uniforms.set("lineColour", colour);
        uniforms.set("width", 1.8 * view.lineScale);
        drawLines(gl, cloth, seams[i].along);
        colour.a = 0.55f;
        uniforms.set("lineColour", colour);
        uniforms.set("width", 1.0 * view.lineScale);
        drawLines(gl, cloth, seams[i].across);
    }
}

void Renderer::State::drawOverlay(const std::vector<Stroke>& overlay, const View& view) {
    if (overlay.empty()) return;
    std::vector<SurfaceVertex> vertices;
    std::vector<std::array<int, 2>> lines;
    std::vector<LineRange> ranges;
    for (const Stroke& stroke : overlay) {
        const auto first = static_cast<GLsizei>(lines.size() * 2);
        for (std::size_t i = 0; i < stroke.points.size(); ++i) {
            const Vec3& p = stroke.points[i];
            const int index = static_cast<int>(vertices.size());
            vertices.push_back(
                {.position = {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)}});
            if (i > 0) lines.push_back({index - 1, index});
        }
        ranges.push_back({first, static_cast<GLsizei>(lines.size() * 2) - first});
    }
    uploadVertices(gl, strokes, vertices);
    uploadLines(gl, strokes, lines);
    const Uniforms uniforms = lineUniforms(view);
    uniforms.set("towardsEye", 0.0016);
    for (std::size_t i = 0; i < overlay.size(); ++i) {
        if (overlay[i].onTop) gl.Disable(GL_DEPTH_TEST);
        uniforms.set("lineColour", overlay[i].colour);
        uniforms.set("width", overlay[i].width * view.lineScale);
        drawLines(gl, strokes, ranges[i]);
        gl.Enable(GL_DEPTH_TEST);
    }
}

} // namespace toile::picture
