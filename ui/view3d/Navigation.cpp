// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view3d/Navigation.h"

#include <cmath>

namespace toile::ui {

namespace {

constexpr double distancePerNotch = 0.88; // of the wheel
constexpr double notchesPerPixel = 0.05;  // of a drag that zooms

} // namespace

CameraMotion motionFor(CameraHabits habits, const PointerPress& press) {
    switch (habits) {
    case CameraHabits::clo:
        return press.right ? CameraMotion::orbit : press.middle ? CameraMotion::pan : CameraMotion::none;
    case CameraHabits::blender:
        if (!press.middle) return CameraMotion::none;
        return press.shift ? CameraMotion::pan : press.control ? CameraMotion::zoom : CameraMotion::orbit;
    case CameraHabits::maya:
        if (!press.alt) return CameraMotion::none;
        return press.left ? CameraMotion::orbit : press.middle ? CameraMotion::pan : CameraMotion::zoom;
    }
    return CameraMotion::none;
}

picture::Camera moved(const picture::Camera& camera, picture::Viewport viewport, CameraMotion motion, Vec2 from,
                      Vec2 to) {
    switch (motion) {
    case CameraMotion::none: return camera;
    case CameraMotion::orbit: return orbited(camera, viewport, to - from);
    case CameraMotion::pan: return panned(camera, viewport, from, to);
    case CameraMotion::zoom: {
        const Vec2 middle{viewport.width / 2.0, viewport.height / 2.0};
        return wheeled(camera, viewport, middle, (from.y - to.y) * notchesPerPixel);
    }
    }
    return camera;
}

picture::Camera wheeled(const picture::Camera& camera, picture::Viewport viewport, Vec2 pixel, double notches) {
    return zoomedTo(camera, viewport, pixel, std::pow(distancePerNotch, notches));
}

} // namespace toile::ui
