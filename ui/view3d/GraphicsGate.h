// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSurfaceFormat>

namespace toile::ui {

/// How pictures of the 3D view come to the screen.
enum class GraphicsPath {
    window, ///< OpenGL draws into the window
    raster, ///< OpenGL draws beside the window, a widget shows the picture
};

struct Graphics {
    GraphicsPath path = GraphicsPath::raster;
    QSurfaceFormat format; ///< for a QOpenGLWidget; meaningful for GraphicsPath::window
};

/// Decides before any QOpenGLWidget is constructed: on some platforms such a widget ends the program at its
/// first paint, and asking for a context alone does not tell which (docs/picture.md). Needs a
/// QGuiApplication.
[[nodiscard]] Graphics probeGraphics();

} // namespace toile::ui
