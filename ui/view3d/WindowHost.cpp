// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view3d/SceneHost.h"

#include "core/picture/Renderer.h"

#include <QOpenGLContext>
#include <QOpenGLWidget>
#include <QTimer>

#include <optional>

namespace toile::ui {

namespace {

/// The renderer lives as long as the widget's context, which may be replaced when the widget changes windows.
class GlCanvas : public QOpenGLWidget {
public:
    GlCanvas(const QSurfaceFormat& format, ShownNow shown, HostFailed failed, QWidget* parent)
        : QOpenGLWidget(parent), shown_(std::move(shown)), failed_(std::move(failed)) {
        setObjectName("view3dWindowHost");
        setFormat(format);
        setAttribute(Qt::WA_TransparentForMouseEvents);
    }
    ~GlCanvas() override {
        if (context()) disconnect(context(), nullptr, this, nullptr); // it dies after our members
        releaseRenderer();
    }

    [[nodiscard]] QString deviceName() const {
        return renderer_ ? QString::fromStdString(renderer_->deviceName()) : QString();
    }

protected:
    void initializeGL() override {
        connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, [this] { releaseRenderer(); });
        const auto gl = picture::loadGlFunctions(
            [this](const char* name) { return reinterpret_cast<void*>(context()->getProcAddress(name)); });
        if (!gl) return fail(gl.error());
        auto renderer = picture::Renderer::create(*gl);
        if (!renderer) return fail(renderer.error());
        renderer_.emplace(std::move(*renderer));
    }

    void paintGL() override {
        if (!renderer_) return;
        const Shown now = shown_();
        const double ratio = devicePixelRatioF();
        renderer_->draw(now.scene, now.camera, {qRound(width() * ratio), qRound(height() * ratio)}, ratio);
    }

private:
    void releaseRenderer() {
        if (!renderer_) return;
        makeCurrent();
        renderer_->release();
        renderer_.reset();
        doneCurrent();
    }
    void fail(const Error& error) {
        QTimer::singleShot(0, this, [this, why = QString::fromStdString(error.text)] { failed_(why); });
    }

    ShownNow shown_;
    HostFailed failed_;
    std::optional<picture::Renderer> renderer_;
};

class WindowHost : public SceneHost {
public:
    WindowHost(const QSurfaceFormat& format, ShownNow shown, HostFailed failed, QWidget* parent)
        : canvas_(new GlCanvas(format, std::move(shown), std::move(failed), parent)) {}
    [[nodiscard]] QWidget* widget() override { return canvas_; }
    void changed() override { canvas_->update(); }
    [[nodiscard]] QString deviceName() const override { return canvas_->deviceName(); }

private:
    GlCanvas* canvas_;
};

} // namespace

std::unique_ptr<SceneHost> makeWindowHost(const QSurfaceFormat& format, ShownNow shown, HostFailed failed,
                                          QWidget* parent) {
    return std::make_unique<WindowHost>(format, std::move(shown), std::move(failed), parent);
}

} // namespace toile::ui
