// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/picture/Camera.h"
#include "core/picture/Image.h"
#include "core/picture/RenderScene.h"

#include <memory>

namespace toile::picture {

/// Draws pictures without a window, a display or Qt: an EGL context without a surface. The context is current
/// only inside a call, so any thread may call, one at a time.
class OffscreenGl {
public:
    /// Error where there is no driver, or none with OpenGL 3.3.
    [[nodiscard]] static Result<OffscreenGl> create();
    OffscreenGl(OffscreenGl&&) noexcept;
    OffscreenGl& operator=(OffscreenGl&&) noexcept;
    ~OffscreenGl();

    /// `lineScale` widens lines, for dense screens and for pictures that will be made smaller [–].
    [[nodiscard]] Result<Image> render(const RenderScene& scene, const Camera& camera, Viewport viewport,
                                       double lineScale = 1);

    /// Name of the graphics card or driver, for bug reports.
    [[nodiscard]] std::string deviceName() const;

private:
    struct State;
    explicit OffscreenGl(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

} // namespace toile::picture
