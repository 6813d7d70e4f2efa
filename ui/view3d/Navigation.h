// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/picture/Camera.h"

namespace toile::ui {

/// Whose habits the camera follows.
enum class CameraHabits {
    clo,     ///< right drag orbits, middle drag pans
    blender, ///< middle drag orbits, with Shift it pans, with Ctrl it zooms
    maya,    ///< with Alt: left drag orbits, middle drag pans, right drag zooms
};

enum class CameraMotion { none, orbit, pan, zoom };

/// A pressed pointer button with the keys held.
struct PointerPress {
    bool left = false, middle = false, right = false;
    bool shift = false, control = false, alt = false;
};

/// What a drag does that begins with this press.
[[nodiscard]] CameraMotion motionFor(CameraHabits habits, const PointerPress& press);

/// The camera after the pointer moved from one pixel position to another.
[[nodiscard]] picture::Camera moved(const picture::Camera& camera, picture::Viewport viewport, CameraMotion motion,
                                    Vec2 from, Vec2 to);
/// The camera after the wheel turned away from the user by so many notches: nearer to what is under the
/// pointer.
[[nodiscard]] picture::Camera wheeled(const picture::Camera& camera, picture::Viewport viewport, Vec2 pixel,
                                      double notches);

} // namespace toile::ui
