// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/picture/Camera.h"
#include "core/picture/GlFunctions.h"
#include "core/picture/RenderScene.h"

#include <memory>

namespace toile::picture {

/// Draws a scene into whatever framebuffer is bound, with OpenGL 3.3 core or later. Knows nothing of windows
/// and contexts: every member function needs the context current that `create` saw.
///
/// What has not changed since the last draw (the same Shared body, frame or topology) is not sent again.
class Renderer {
public:
    [[nodiscard]] static Result<Renderer> create(const GlFunctions& gl);
    Renderer(Renderer&&) noexcept;
    Renderer& operator=(Renderer&&) noexcept;
    ~Renderer(); ///< frees no GL objects: see release()

    /// Fills the viewport from (0, 0). `lineScale` widens lines, for dense screens [–].
    void draw(const RenderScene& scene, const Camera& camera, Viewport viewport, double lineScale = 1);

    /// Deletes the GL objects; the renderer must not draw afterwards. Not needed when the context dies
    /// anyway.
    void release();

    /// The driver draws on the processor: multisampling would cost more than it is worth.
    [[nodiscard]] bool isSoftware() const;
    /// Name of the graphics card or driver, for bug reports.
    [[nodiscard]] std::string deviceName() const;

private:
    struct State;
    explicit Renderer(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

} // namespace toile::picture
