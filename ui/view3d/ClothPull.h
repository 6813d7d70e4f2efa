// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/picture/Camera.h"
#include "core/picture/RenderScene.h"

#include <optional>
#include <string>
#include <vector>

namespace toile::ui {

/// A place of the cloth, named by its material, and where in space it is held.
struct HeldPlace {
    std::string piece; ///< id
    Vec2 material;     ///< u weft, v warp [m]
    Vec3 target;       ///< [m]
    friend bool operator==(const HeldPlace&, const HeldPlace&) = default;
};

/// A pull at the cloth under way. A value and a state machine without widgets: made at the press, dragged, kept as a
/// pin or let go. The place follows the pointer at the depth in which it was grabbed.
class ClothPull {
public:
    /// pin: index of the pin that is grabbed, absent for loose cloth.
    ClothPull(HeldPlace place, std::optional<std::size_t> pin) : place_(std::move(place)), pin_(pin) {}

    [[nodiscard]] const HeldPlace& place() const { return place_; }
    [[nodiscard]] std::optional<std::size_t> pin() const { return pin_; }
    void drag(const picture::Camera& camera, picture::Viewport viewport, Vec2 pixel);

private:
    HeldPlace place_;
    std::optional<std::size_t> pin_;
};

/// The place of the cloth a ray of the pointer meets first, if the body does not hide it.
[[nodiscard]] std::optional<HeldPlace> placeUnder(const picture::RenderScene& scene, const picture::Ray& ray);
/// The pin whose mark is seen at a pixel; the nearest to the eye.
[[nodiscard]] std::optional<std::size_t> pinUnder(const std::vector<HeldPlace>& pins, const picture::Camera& camera,
                                                  picture::Viewport viewport, Vec2 pixel);
/// A ring that faces the eye and is as large from everywhere, thick in the hand, thin for a pin; and a line from there
/// to the cloth, where that has not come so far.
[[nodiscard]] std::vector<picture::Stroke> marksOf(const HeldPlace& place, bool inHand,
                                                   const picture::RenderScene& scene, const picture::Camera& camera,
                                                   picture::Viewport viewport);

/// What the pattern pins: a ring round each vertex, two round one that is pinned to the body.
[[nodiscard]] std::vector<picture::Stroke> marksOfPins(const simulation::Frame& frame, const picture::Camera& camera,
                                                       picture::Viewport viewport);

} // namespace toile::ui
