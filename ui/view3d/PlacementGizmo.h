// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/Vec.h"
#include "core/picture/Camera.h"
#include "core/picture/RenderScene.h"

#include <vector>

namespace toile::ui {

/// The parts of a gizmo: arrows that move along an axis of the world, rings that turn about one.
enum class GizmoHandle { none, moveX, moveY, moveZ, turnX, turnY, turnZ };

/// How the pointer's positions are to be read.
struct GizmoView {
    picture::Camera camera;
    picture::Viewport viewport;
};

/// Moves and turns a placement with the pointer. A value and a state machine without widgets: press, drag,
/// then release or cancel. Its size on the screen does not depend on the distance.
class PlacementGizmo {
public:
    PlacementGizmo() = default;
    /// `pivot`: where the gizmo stands and what rings turn about [m, world]; it moves along with the
    /// placement.
    PlacementGizmo(const Transform& placement, const Vec3& pivot) : placement_(placement), pivot_(pivot) {}

    [[nodiscard]] const Transform& placement() const { return placement_; }
    [[nodiscard]] const Vec3& pivot() const { return pivot_; }
    [[nodiscard]] GizmoHandle held() const { return held_; }
    [[nodiscard]] GizmoHandle hovered() const { return hovered_; }
    [[nodiscard]] bool isDragging() const { return held_ != GizmoHandle::none; }

    /// The handle under a pixel position; where two are touched alike an arrow rather than a ring, then the
    /// one nearer to the eye.
    [[nodiscard]] GizmoHandle handleAt(const GizmoView& view, Vec2 pixel) const;
    /// The handle under the pointer lights up; true when that changed.
    bool hover(const GizmoView& view, Vec2 pixel);

    /// True when a handle was grabbed.
    bool press(const GizmoView& view, Vec2 pixel);
    /// The placement as dragged so far. In steps: whole centimetres and multiples of 5° from where the drag
    /// began.
    const Transform& drag(const GizmoView& view, Vec2 pixel, bool inSteps = false);
    /// Ends the drag and keeps the placement.
    void release();
    /// Ends the drag; the placement is what it was before.
    void cancel();

    /// What to draw: the gizmo over the scene.
    [[nodiscard]] std::vector<picture::Stroke> strokes(const GizmoView& view) const;

private:
    void apply(double amount);
    [[nodiscard]] double amountAt(const GizmoView& view, Vec2 pixel) const;

    Transform placement_, before_;
    Vec3 pivot_, pivotBefore_;
    GizmoHandle held_ = GizmoHandle::none, hovered_ = GizmoHandle::none;
    double grabbedAt_ = 0; ///< amount under the pointer when the drag began [m or rad]
    double lastTurn_ = 0;  ///< so that turns go on past half a circle [rad]
    Vec2 grabbedPixel_;
    Vec2 turnPerPixel_; ///< rings seen edge-on turn by the way along their line [rad/px]; zero = seen well
                        ///< enough
};

/// The map that turns about an axis through a point, counter-clockwise seen against the axis.
[[nodiscard]] Transform turnedAbout(const Vec3& point, const Vec3& unitAxis, double angle);

} // namespace toile::ui
