// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/picture/OffscreenGl.h"

#include "core/picture/Renderer.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <array>
#include <cstdio>
#include <cstring>
#include <optional>

namespace toile::picture {

namespace {

constexpr int largestSide = 16384; // [px]; what today's drivers offer

tl::unexpected<Error> eglFailure(const char* what) {
    std::array<char, 16> number{};
    std::snprintf(number.data(), number.size(), "0x%04x", static_cast<unsigned>(eglGetError()));
    return fail(ErrorCode::unsupported, std::string("No picture can be drawn without a window: ") + what +
                                            " (EGL error " + number.data() +
                                            "). On Debian the package libgl1-mesa-dri draws on any machine.");
}

/// Mesa's platform without surfaces; elsewhere (other vendors) the default display.
EGLDisplay surfacelessDisplay() {
    const char* extensions = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
    const auto getDisplay =
        reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(eglGetProcAddress("eglGetPlatformDisplayEXT"));
    if (extensions && getDisplay && std::strstr(extensions, "EGL_MESA_platform_surfaceless"))
        return getDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    return eglGetDisplay(EGL_DEFAULT_DISPLAY);
}

/// Makes a context current for a scope, and what was current before again afterwards.
class Current {
public:
    Current(EGLDisplay display, EGLContext context)
        : display_(display), before_(eglGetCurrentContext()), displayBefore_(eglGetCurrentDisplay()),
          draw_(eglGetCurrentSurface(EGL_DRAW)), read_(eglGetCurrentSurface(EGL_READ)) {
        good_ = eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context) == EGL_TRUE;
    }
    ~Current() {
        eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        if (before_ != EGL_NO_CONTEXT) eglMakeCurrent(displayBefore_, draw_, read_, before_);
    }
    Current(const Current&) = delete;
    Current& operator=(const Current&) = delete;
    [[nodiscard]] bool good() const { return good_; }

private:
    EGLDisplay display_;
    EGLContext before_;
    EGLDisplay displayBefore_;
    EGLSurface draw_, read_;
    bool good_ = false;
};

/// Colour and depth of one picture's size.
struct Target {
    GLuint framebuffer = 0, colour = 0, depth = 0;
    Viewport size{0, 0};
};

Target createTarget(const GlFunctions& gl, Viewport size) {
    Target target{.size = size};
    gl.GenFramebuffers(1, &target.framebuffer);
    gl.BindFramebuffer(GL_FRAMEBUFFER, target.framebuffer);
    gl.GenRenderbuffers(1, &target.colour);
    gl.BindRenderbuffer(GL_RENDERBUFFER, target.colour);
    gl.RenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, size.width, size.height);
    gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, target.colour);
    gl.GenRenderbuffers(1, &target.depth);
    gl.BindRenderbuffer(GL_RENDERBUFFER, target.depth);
    gl.RenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, size.width, size.height);
    gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, target.depth);
    return target;
}

void deleteTarget(const GlFunctions& gl, const Target& target) {
    gl.DeleteFramebuffers(1, &target.framebuffer);
    gl.DeleteRenderbuffers(1, &target.colour);
    gl.DeleteRenderbuffers(1, &target.depth);
}

/// OpenGL's rows run upward, an image's downward.
Image readPixels(const GlFunctions& gl, Viewport size) {
    Image upward{size.width, size.height,
                 std::vector<std::uint8_t>(static_cast<std::size_t>(size.width) * size.height * 4)};
    gl.PixelStorei(GL_PACK_ALIGNMENT, 1);
    gl.ReadPixels(0, 0, size.width, size.height, GL_RGBA, GL_UNSIGNED_BYTE, upward.rgba.data());
    Image image = upward;
    const std::size_t row = static_cast<std::size_t>(size.width) * 4;
    for (int y = 0; y < size.height; ++y)
        std::memcpy(image.rgba.data() + y * row, upward.rgba.data() + (size.height - 1 - y) * row, row);
    return image;
}

} // namespace

struct OffscreenGl::State {
    EGLDisplay display = EGL_NO_DISPLAY;
    EGLContext context = EGL_NO_CONTEXT;
    GlFunctions gl;
    std::optional<Renderer> renderer;
    Target target;

    State() = default;
    State(const State&) = delete;
    State& operator=(const State&) = delete;
    // The display stays initialised: it is shared by all who asked for it, and terminating it would end their
    // contexts.
    ~State() {
        if (context != EGL_NO_CONTEXT) eglDestroyContext(display, context); // frees everything drawn with
    }
};

OffscreenGl::OffscreenGl(std::unique_ptr<State> state) : state_(std::move(state)) {}
OffscreenGl::OffscreenGl(OffscreenGl&&) noexcept = default;
OffscreenGl& OffscreenGl::operator=(OffscreenGl&&) noexcept = default;
OffscreenGl::~OffscreenGl() = default;

Result<OffscreenGl> OffscreenGl::create() {
    auto state = std::make_unique<State>();
    state->display = surfacelessDisplay();
    if (state->display == EGL_NO_DISPLAY) return eglFailure("there is no graphics driver");
    if (!eglInitialize(state->display, nullptr, nullptr)) return eglFailure("the graphics driver does not start");
    if (!eglBindAPI(EGL_OPENGL_API)) return eglFailure("the driver has no OpenGL");
    constexpr std::array<EGLint, 5> wanted{EGL_SURFACE_TYPE, 0, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    if (!eglChooseConfig(state->display, wanted.data(), &config, 1, &count) || count == 0)
        return eglFailure("the driver offers no configuration for OpenGL");
    constexpr std::array<EGLint, 7> version{
        EGL_CONTEXT_MAJOR_VERSION,           3,       EGL_CONTEXT_MINOR_VERSION, 3, EGL_CONTEXT_OPENGL_PROFILE_MASK,
        EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
    state->context = eglCreateContext(state->display, config, EGL_NO_CONTEXT, version.data());
    if (state->context == EGL_NO_CONTEXT) return eglFailure("the driver has no OpenGL 3.3 core profile");
    const Current current(state->display, state->context);
    if (!current.good()) return eglFailure("the driver cannot draw without a surface");
    const auto gl = loadGlFunctions([](const char* name) { return reinterpret_cast<void*>(eglGetProcAddress(name)); });
    if (!gl) return tl::unexpected(gl.error());
    state->gl = *gl;
    auto renderer = Renderer::create(*gl);
    if (!renderer) return tl::unexpected(renderer.error());
    state->renderer.emplace(std::move(*renderer));
    return OffscreenGl(std::move(state));
}

Result<Image> OffscreenGl::render(const RenderScene& scene, const Camera& camera, Viewport viewport, double lineScale) {
    if (viewport.width < 1 || viewport.height < 1 || viewport.width > largestSide || viewport.height > largestSide)
        return fail(ErrorCode::tooLarge, "A picture has 1 to " + std::to_string(largestSide) + " pixels a side, not " +
                                             std::to_string(viewport.width) + " × " + std::to_string(viewport.height) +
                                             '.');
    State& s = *state_;
    if (!eglBindAPI(EGL_OPENGL_API)) return eglFailure("the driver has no OpenGL"); // it is bound per thread
    const Current current(s.display, s.context);
    if (!current.good()) return eglFailure("the drawing context is in use elsewhere");
    if (s.target.size != viewport) {
        deleteTarget(s.gl, s.target);
        s.target = createTarget(s.gl, viewport);
        if (s.gl.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
            deleteTarget(s.gl, std::exchange(s.target, {}));
            return fail(ErrorCode::tooLarge, "The graphics driver cannot draw a picture of this size.");
        }
    }
    s.gl.BindFramebuffer(GL_FRAMEBUFFER, s.target.framebuffer);
    s.renderer->draw(scene, camera, viewport, lineScale);
    Image image = readPixels(s.gl, viewport);
    if (s.gl.GetError() != GL_NO_ERROR)
        return fail(ErrorCode::tooLarge, "The graphics driver could not draw the picture; its memory may be full.");
    return image;
}

std::string OffscreenGl::deviceName() const {
    return state_->renderer->deviceName();
}

} // namespace toile::picture
