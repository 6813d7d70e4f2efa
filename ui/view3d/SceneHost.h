// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/picture/Camera.h"
#include "core/picture/RenderScene.h"

#include <QString>
#include <QSurfaceFormat>

#include <functional>
#include <memory>

class QWidget;

namespace toile::ui {

/// What a host draws, asked for at each paint.
struct Shown {
    const picture::RenderScene& scene;
    const picture::Camera& camera;
};
using ShownNow = std::function<Shown()>;
/// Told once, from the event loop, when a host finds that it cannot draw; the sentence is for the user.
using HostFailed = std::function<void(const QString& why)>;

/// A widget that shows a scene by one of the ways of GraphicsPath. It takes no input.
class SceneHost {
public:
    virtual ~SceneHost() = default;
    [[nodiscard]] virtual QWidget* widget() = 0;
    /// Draws anew at the next repaint.
    virtual void changed() = 0;
    /// Name of the graphics card or driver; empty until the first picture.
    [[nodiscard]] virtual QString deviceName() const = 0;
};

/// A QOpenGLWidget; only where the gate allows it. The parent owns the widget.
[[nodiscard]] std::unique_ptr<SceneHost> makeWindowHost(const QSurfaceFormat& format, ShownNow shown, HostFailed failed,
                                                        QWidget* parent);
/// A plain widget that shows pictures drawn without a window.
[[nodiscard]] std::unique_ptr<SceneHost> makeRasterHost(ShownNow shown, HostFailed failed, QWidget* parent);
/// Says in the view's place why there is no picture.
[[nodiscard]] std::unique_ptr<SceneHost> makeMessageHost(const QString& why, QWidget* parent);

} // namespace toile::ui
