// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view3d/GraphicsGate.h"

#include <QGuiApplication>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFunctions>

namespace toile::ui {

namespace {

QSurfaceFormat wantedFormat() {
    QSurfaceFormat format = QSurfaceFormat::defaultFormat();
    format.setRenderableType(QSurfaceFormat::OpenGL);
    format.setVersion(3, 3);
    format.setProfile(QSurfaceFormat::CoreProfile);
    format.setDepthBufferSize(24);
    return format;
}

/// Multisampling on the processor costs three times the picture itself.
int samplesFor(const QByteArray& device) {
    return device.contains("llvmpipe") || device.contains("softpipe") ? 0 : 4;
}

} // namespace

Graphics probeGraphics() {
    const QString platform = QGuiApplication::platformName();
    const bool drawsWidgets =
        platform == "xcb" || platform.startsWith("wayland") || platform == "windows" || platform == "cocoa";
    if (!drawsWidgets) return {};
    QOpenGLContext context;
    context.setFormat(wantedFormat());
    if (!context.create() || context.isOpenGLES() || context.format().version() < qMakePair(3, 3)) return {};
    QOffscreenSurface surface;
    surface.setFormat(context.format());
    surface.create();
    if (!surface.isValid() || !context.makeCurrent(&surface)) return {};
    const auto* device = reinterpret_cast<const char*>(context.functions()->glGetString(GL_RENDERER));
    QSurfaceFormat format = wantedFormat();
    format.setSamples(samplesFor(device));
    context.doneCurrent();
    return {GraphicsPath::window, format};
}

} // namespace toile::ui
