// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/picture/Renderer.h"

#include "core/picture/RendererState.h"
#include "core/picture/Shaders.h"

#include <algorithm>
#include <string_view>
#include <utility>

namespace toile::picture {

namespace {

constexpr int shadowMapSize = 2048, softwareShadowMapSize = 1024; // a side [texels]

double meanLength(const std::vector<std::array<int, 2>>& lines, const std::vector<Vec3>& positions) {
    double sum = 0;
    for (const auto& [a, b] : lines) sum += distance(positions[a], positions[b]);
    return lines.empty() ? 0 : sum / static_cast<double>(lines.size());
}

template <class T>
bool same(const std::optional<Shared<T>>& a, const std::optional<Shared<T>>& b) {
    return a.has_value() == b.has_value() && (!a || a->sameAs(*b));
}

bool isSoftwareDevice(std::string_view device) {
    return std::ranges::any_of(std::array{"llvmpipe", "softpipe", "SWR"},
                               [&](std::string_view name) { return device.find(name) != std::string_view::npos; });
}

ShadowMap createShadowMap(const GlFunctions& gl, int size) {
    ShadowMap map{.size = size};
    gl.GenTextures(1, &map.texture);
    gl.ActiveTexture(GL_TEXTURE0);
    gl.BindTexture(GL_TEXTURE_2D, map.texture);
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, size, size, 0, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, nullptr);
    for (const auto& [name, value] : {std::pair{GL_TEXTURE_MIN_FILTER, GL_LINEAR},
                                      {GL_TEXTURE_MAG_FILTER, GL_LINEAR},
                                      {GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE},
                                      {GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE},
                                      {GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE},
                                      {GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL}})
        gl.TexParameteri(GL_TEXTURE_2D, static_cast<GLenum>(name), value);
    GLint bound = 0;
    gl.GetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &bound);
    gl.GenFramebuffers(1, &map.framebuffer);
    gl.BindFramebuffer(GL_FRAMEBUFFER, map.framebuffer);
    gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, map.texture, 0);
    gl.DrawBuffer(GL_NONE);
    gl.ReadBuffer(GL_NONE);
    gl.BindFramebuffer(GL_FRAMEBUFFER, static_cast<GLuint>(bound));
    return map;
}

} // namespace

Renderer::Renderer(std::unique_ptr<State> state) : state_(std::move(state)) {}
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;
Renderer::~Renderer() = default;

Result<Renderer> Renderer::create(const GlFunctions& gl) {
    GLint major = 0, minor = 0;
    gl.GetIntegerv(GL_MAJOR_VERSION, &major);
    gl.GetIntegerv(GL_MINOR_VERSION, &minor);
    if (std::pair(major, minor) < std::pair(3, 3))
        return fail(ErrorCode::unsupported, "The graphics driver offers OpenGL " + std::to_string(major) + '.' +
                                                std::to_string(minor) + "; 3.3 is needed.");
    auto state = std::make_unique<State>();
    state->gl = gl;
    for (const auto& [program, sources] : {std::pair{&state->programs.background, &shaders::background},
                                           {&state->programs.shadow, &shaders::shadow},
                                           {&state->programs.surface, &shaders::surface},
                                           {&state->programs.floor, &shaders::floor},
                                           {&state->programs.line, &shaders::line}}) {
        const auto linked = linkedProgram(gl, *sources);
        if (!linked) return tl::unexpected(linked.error());
        *program = *linked;
    }
    if (const GLubyte* name = gl.GetString(GL_RENDERER)) state->device = reinterpret_cast<const char*>(name);
    state->shadowMap = createShadowMap(gl, isSoftwareDevice(state->device) ? softwareShadowMapSize : shadowMapSize);
    gl.GenVertexArrays(1, &state->emptyArray);
    state->body = createMesh(gl);
    state->cloth = createMesh(gl);
    state->strokes = createMesh(gl);
    gl.GenBuffers(1, &state->colourBuffer);
    gl.GenTextures(1, &state->colourTexture);
    return Renderer(std::move(state));
}

void Renderer::release() {
    const GlFunctions& gl = state_->gl;
    const Programs& p = state_->programs;
    for (const GLuint program : {p.background, p.shadow, p.surface, p.floor, p.line}) gl.DeleteProgram(program);
    for (const GlMesh* mesh : {&state_->body, &state_->cloth, &state_->strokes}) deleteMesh(gl, *mesh);
    gl.DeleteVertexArrays(1, &state_->emptyArray);
    gl.DeleteFramebuffers(1, &state_->shadowMap.framebuffer);
    gl.DeleteTextures(1, &state_->shadowMap.texture);
    gl.DeleteTextures(1, &state_->colourTexture);
    gl.DeleteBuffers(1, &state_->colourBuffer);
}

bool Renderer::isSoftware() const {
    return isSoftwareDevice(state_->device);
}

std::string Renderer::deviceName() const {
    return state_->device;
}

void Renderer::draw(const RenderScene& scene, const Camera& camera, Viewport viewport, double lineScale) {
    State& s = *state_;
    const GlFunctions& gl = s.gl;
    s.send(scene);

    const auto box = boundsOf(scene);
    const Vec3 centre = box ? (box->low + box->high) * 0.5 : camera.target;
    const double radius = box ? std::max(distance(box->low, box->high) / 2, 0.01) : 1;
    const Vec3 eye = eyeOf(camera);
    const double far = std::max(distance(eye, centre) + radius, distance(eye, {}) + floorRadius) + 1;
    View view{viewMatrix(camera),
              projectionMatrix(camera, viewport, std::clamp(camera.distance * 0.02, 0.002, 0.1), far),
              {},
              camera,
              eye,
              lightsOf(camera),
              viewport,
              lineScale,
              scene.options.shadows && box};
    view.shadow = shadowMatrix(view.lights.key, centre, radius);

    gl.Disable(GL_CULL_FACE);
    gl.Disable(GL_BLEND);
    gl.Enable(GL_DEPTH_TEST);
    gl.DepthFunc(GL_LEQUAL);
    gl.DepthMask(GL_TRUE);
    gl.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    if (view.shadows) s.drawShadowMap(scene, view);
    gl.Viewport(0, 0, viewport.width, viewport.height);
    gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    s.drawBackground();
    s.drawSurfaces(scene, view);

    gl.Enable(GL_BLEND); // the rest is translucent and hides nothing
    gl.BlendEquation(GL_FUNC_ADD);
    gl.BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    gl.DepthMask(GL_FALSE);
    if (scene.options.floor && view.eye.y > 0) s.drawFloor(camera, view);
    if (s.showsCloth(scene.options)) s.drawClothLines(scene, view);
    s.drawOverlay(scene.overlay, view);

    gl.DepthMask(GL_TRUE);
    gl.Disable(GL_BLEND);
    gl.Disable(GL_DEPTH_TEST);
    gl.BindVertexArray(0);
    gl.UseProgram(0);
}

void Renderer::State::send(const RenderScene& scene) {
    if (!same(sentBody, scene.body)) {
        if (scene.body) {
            uploadVertices(gl, body, surfaceVertices((*scene.body)->mesh.vertices, (*scene.body)->mesh.triangles));
            uploadTriangles(gl, body, (*scene.body)->mesh.triangles);
        }
        sentBody = scene.body;
    }
    if (!scene.frame) {
        sentFrame.reset();
        return;
    }
    const simulation::Frame& frame = **scene.frame;
    const simulation::FrameTopology& topology = *frame.topology;
    expects(topology.pieces.empty() || topology.pieces.back().firstVertex + topology.pieces.back().vertexCount <=
                                           static_cast<int>(frame.positions.size()),
            "a frame has a position for every vertex of its topology");
    if (!sentTopology || !sentTopology->sameAs(frame.topology)) {
        sendTopology(topology);
        sentTopology = frame.topology;
    }
    if (!same(sentFrame, scene.frame)) {
        uploadVertices(gl, cloth, surfaceVertices(frame.positions, topology.triangles, topology.seams));
        meanLineLength = meanLength(topology.meshLines, frame.positions);
    }
    sentFrame = scene.frame;
    auto colours = triangleColours(scene, topology);
    if (colours != sentColours) sendColours(std::move(colours));
}

void Renderer::State::sendTopology(const simulation::FrameTopology& topology) {
    uploadTriangles(gl, cloth, topology.triangles);
    std::vector<std::array<int, 2>> lines = topology.meshLines;
    const auto append = [&](const std::vector<std::array<int, 2>>& more) {
        const auto first = static_cast<GLsizei>(lines.size() * 2);
        lines.insert(lines.end(), more.begin(), more.end());
        return LineRange{first, static_cast<GLsizei>(more.size() * 2)};
    };
    meshLines = {0, static_cast<GLsizei>(lines.size() * 2)};
    seams.clear();
    for (const SeamLines& seam : seamLines(topology)) {
        const LineRange along = append(seam.along);
        seams.push_back({along, append(seam.across)});
    }
    borders.clear();
    const auto pieceEdges = pieceBorders(topology);
    for (std::size_t i = 0; i < pieceEdges.size(); ++i) borders[topology.pieces[i].id] = append(pieceEdges[i]);
    uploadLines(gl, cloth, lines);
}

void Renderer::State::sendColours(std::vector<std::array<std::uint8_t, 4>> colours) {
    gl.BindBuffer(GL_TEXTURE_BUFFER, colourBuffer);
    gl.BufferData(GL_TEXTURE_BUFFER, static_cast<GLsizeiptr>(colours.size() * 4), colours.data(), GL_STATIC_DRAW);
    sentColours = std::move(colours);
}

} // namespace toile::picture
