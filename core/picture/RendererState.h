// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/picture/GlMesh.h"
#include "core/picture/GlProgram.h"
#include "core/picture/Lights.h"
#include "core/picture/Renderer.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace toile::picture {

inline constexpr double floorRadius = 3; ///< [m]

struct Programs {
    GLuint background = 0, shadow = 0, surface = 0, floor = 0, line = 0;
};

struct ShadowMap {
    GLuint texture = 0, framebuffer = 0;
    int size = 0; ///< a side [texels]
};

/// What every pass over a picture needs.
struct View {
    Matrix4 view, projection, shadow;
    Camera camera;
    Vec3 eye;
    Lights lights;
    Viewport viewport;
    double lineScale = 1;
    bool shadows = false;
};

struct Renderer::State {
    GlFunctions gl;
    Programs programs;
    ShadowMap shadowMap;
    GLuint emptyArray = 0; ///< core profiles draw nothing without a vertex array
    GlMesh body, cloth, strokes;
    GLuint colourBuffer = 0, colourTexture = 0;
    std::string device;

    // What the graphics card holds now.
    std::optional<Shared<body::Body>> sentBody;
    std::optional<Shared<simulation::Frame>> sentFrame;
    std::optional<Shared<simulation::FrameTopology>> sentTopology;
    std::vector<std::array<std::uint8_t, 4>> sentColours;
    LineRange meshLines;
    double meanLineLength = 0; ///< of the mesh lines as they are in the frame [m]
    struct SeamRanges {
        LineRange along, across;
    };
    std::vector<SeamRanges> seams;
    std::map<std::string, LineRange> borders; ///< by id of the piece

    void send(const RenderScene& scene);
    void sendTopology(const simulation::FrameTopology& topology);
    void sendColours(std::vector<std::array<std::uint8_t, 4>> colours);
    void drawShadowMap(const RenderScene& scene, const View& view);
    void drawBackground();
    void drawSurfaces(const RenderScene& scene, const View& view);
    void drawFloor(const Camera& camera, const View& view);
    void drawClothLines(const RenderScene& scene, const View& view);
    void drawOverlay(const std::vector<Stroke>& overlay, const View& view);
    [[nodiscard]] Uniforms lineUniforms(const View& view) const;
    void setShadowUniforms(const Uniforms& uniforms, const View& view) const;
    [[nodiscard]] bool showsBody(const RenderOptions& options) const { return options.body && sentBody; }
    [[nodiscard]] bool showsCloth(const RenderOptions& options) const {
        return options.cloth && sentFrame && cloth.triangleIndices > 0;
    }
};

} // namespace toile::picture
