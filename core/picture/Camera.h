// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/TriangleMesh.h"
#include "core/geometry/Vec.h"

#include <array>
#include <optional>

namespace toile::picture {

/// Looks at a target from a distance. Yaw 0, pitch 0 looks along −z: at the face of a body, from the front.
struct Camera {
    Vec3 target{0, 1, 0};
    double distance = 3; ///< eye to target [m]
    double yaw = 0;      ///< of the eye round the target, positive towards +x, the body's left [rad]
    double pitch = 0;    ///< of the eye above the target's level, within ±π/2 [rad]
    double fovY = 0.5;   ///< whole vertical angle of view [rad]
    friend bool operator==(const Camera&, const Camera&) = default;
};

/// Size of a picture in pixels. Points of it are counted from the top left corner, x right, y down.
struct Viewport {
    int width = 1, height = 1;
    friend bool operator==(const Viewport&, const Viewport&) = default;
};

struct Ray {
    Vec3 origin;
    Vec3 direction; ///< of unit length
};

/// Where a point of space is seen.
struct ScreenPoint {
    Vec2 pixel;
    double depth = 0; ///< distance from the eye along the viewing direction, positive [m]
};

/// Unit vectors of the camera: the right and the top of the picture, and from the target to the eye.
struct CameraAxes {
    Vec3 right, up, back;
};
[[nodiscard]] CameraAxes axesOf(const Camera& camera);
[[nodiscard]] Vec3 eyeOf(const Camera& camera);

/// Absent for points on or behind the plane of the eye.
[[nodiscard]] std::optional<ScreenPoint> worldToScreen(const Camera& camera, Viewport viewport, const Vec3& point);
/// From the eye through a pixel position.
[[nodiscard]] Ray pickRay(const Camera& camera, Viewport viewport, Vec2 pixel);
/// The point seen at a pixel position that lies in the plane through `through` parallel to the picture.
[[nodiscard]] Vec3 screenToWorld(const Camera& camera, Viewport viewport, Vec2 pixel, const Vec3& through);
/// Length that one pixel covers at a point [m].
[[nodiscard]] double pixelSize(const Camera& camera, Viewport viewport, const Vec3& point);

/// Turns the eye round the target as if the pointer dragged the surface of the scene: half a turn per picture
/// height.
[[nodiscard]] Camera orbited(const Camera& camera, Viewport viewport, Vec2 movedBy);
/// What lay under `from`, at the target's depth, lies under `to`.
[[nodiscard]] Camera panned(const Camera& camera, Viewport viewport, Vec2 from, Vec2 to);
/// The distance is multiplied by factor; what lies under the pixel, at the target's depth, stays there.
[[nodiscard]] Camera zoomedTo(const Camera& camera, Viewport viewport, Vec2 pixel, double factor);

enum class ViewDirection { front, back, left, right, top };
/// The same target and distance, seen from the body's front, back, left, right, or from above.
[[nodiscard]] Camera lookingFrom(ViewDirection direction, Camera camera);
/// The same direction; a box is centred and fills the picture but for a margin [fraction of the picture].
[[nodiscard]] Camera fitted(const Camera& camera, Viewport viewport, const geometry::Box3& box, double margin = 0.05);

/// Column by column, as OpenGL takes it.
using Matrix4 = std::array<float, 16>;
[[nodiscard]] Matrix4 viewMatrix(const Camera& camera);
/// Depths between `near` and `far` [m] are kept.
[[nodiscard]] Matrix4 projectionMatrix(const Camera& camera, Viewport viewport, double near, double far);

} // namespace toile::picture
