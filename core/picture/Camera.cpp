// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/picture/Camera.h"

#include <algorithm>
#include <numbers>

namespace toile::picture {

namespace {

constexpr double steepest = std::numbers::pi / 2;
constexpr double nearest = 0.02, farthest = 200; // of the eye to the target [m]

/// Pixels per unit of tangent.
double focalLength(const Camera& camera, Viewport viewport) {
    return viewport.height / (2 * std::tan(camera.fovY / 2));
}

/// Right, up and depth of a point as the eye has them [m].
Vec3 inEye(const Camera& camera, const Vec3& point) {
    const CameraAxes axes = axesOf(camera);
    const Vec3 fromTarget = point - camera.target;
    return {dot(fromTarget, axes.right), dot(fromTarget, axes.up), camera.distance - dot(fromTarget, axes.back)};
}

} // namespace

CameraAxes axesOf(const Camera& camera) {
    const double cy = std::cos(camera.yaw), sy = std::sin(camera.yaw);
    const double cp = std::cos(camera.pitch), sp = std::sin(camera.pitch);
    const Vec3 right{cy, 0, -sy}, back{sy * cp, sp, cy * cp};
    return {right, cross(back, right), back};
}

Vec3 eyeOf(const Camera& camera) {
    return camera.target + axesOf(camera).back * camera.distance;
}

std::optional<ScreenPoint> worldToScreen(const Camera& camera, Viewport viewport, const Vec3& point) {
    const Vec3 seen = inEye(camera, point);
    if (seen.z <= 0) return std::nullopt;
    const double scale = focalLength(camera, viewport) / seen.z;
    return ScreenPoint{{viewport.width / 2.0 + seen.x * scale, viewport.height / 2.0 - seen.y * scale}, seen.z};
}

Ray pickRay(const Camera& camera, Viewport viewport, Vec2 pixel) {
    const CameraAxes axes = axesOf(camera);
    const double focal = focalLength(camera, viewport);
    const Vec3 direction =
        axes.right * (pixel.x - viewport.width / 2.0) + axes.up * (viewport.height / 2.0 - pixel.y) - axes.back * focal;
    return {eyeOf(camera), normalized(direction)};
}

Vec3 screenToWorld(const Camera& camera, Viewport viewport, Vec2 pixel, const Vec3& through) {
    const Ray ray = pickRay(camera, viewport, pixel);
    const Vec3 back = axesOf(camera).back;
    return ray.origin + ray.direction * (dot(through - ray.origin, back) / dot(ray.direction, back));
}

double pixelSize(const Camera& camera, Viewport viewport, const Vec3& point) {
    return std::max(inEye(camera, point).z, nearest) / focalLength(camera, viewport);
}

Camera orbited(const Camera& camera, Viewport viewport, Vec2 movedBy) {
    const double perPixel = std::numbers::pi / viewport.height;
    Camera turned = camera;
    turned.yaw = std::remainder(camera.yaw - movedBy.x * perPixel, 2 * std::numbers::pi);
    turned.pitch = std::clamp(camera.pitch + movedBy.y * perPixel, -steepest, steepest);
    return turned;
}

Camera panned(const Camera& camera, Viewport viewport, Vec2 from, Vec2 to) {
    Camera moved = camera;
    moved.target +=
        screenToWorld(camera, viewport, from, camera.target) - screenToWorld(camera, viewport, to, camera.target);
    return moved;
}

Camera zoomedTo(const Camera& camera, Viewport viewport, Vec2 pixel, double factor) {
    const Vec3 fixed = screenToWorld(camera, viewport, pixel, camera.target);
    Camera zoomed = camera;
    zoomed.distance = std::clamp(camera.distance * factor, nearest, farthest);
    zoomed.target = lerp(fixed, camera.target, zoomed.distance / camera.distance);
    return zoomed;
}

Camera lookingFrom(ViewDirection direction, Camera camera) {
    camera.pitch = direction == ViewDirection::top ? steepest : 0;
    switch (direction) {
    case ViewDirection::front:
    case ViewDirection::top: camera.yaw = 0; break;
    case ViewDirection::back: camera.yaw = std::numbers::pi; break;
    case ViewDirection::left: camera.yaw = std::numbers::pi / 2; break;
    case ViewDirection::right: camera.yaw = -std::numbers::pi / 2; break;
    }
    return camera;
}

Camera fitted(const Camera& camera, Viewport viewport, const geometry::Box3& box, double margin) {
    const CameraAxes axes = axesOf(camera);
    const double tanY = std::tan(camera.fovY / 2) * (1 - 2 * margin);
    const double tanX = tanY * viewport.width / viewport.height;
    Camera fit = camera;
    fit.target = (box.low + box.high) * 0.5;
    fit.distance = nearest;
    for (int corner = 0; corner < 8; ++corner) { // every corner must be inside the narrowed pyramid of view
        const Vec3 fromTarget = Vec3{corner & 1 ? box.high.x : box.low.x, corner & 2 ? box.high.y : box.low.y,
                                     corner & 4 ? box.high.z : box.low.z} -
                                fit.target;
        const double needed =
            std::max(std::abs(dot(fromTarget, axes.right)) / tanX, std::abs(dot(fromTarget, axes.up)) / tanY);
        fit.distance = std::max(fit.distance, needed + dot(fromTarget, axes.back));
    }
    fit.distance = std::min(fit.distance, farthest);
    return fit;
}

Matrix4 viewMatrix(const Camera& camera) {
    const CameraAxes axes = axesOf(camera);
    const Vec3 eye = eyeOf(camera);
    const auto f = [](double x) { return static_cast<float>(x); };
    return {f(axes.right.x),          f(axes.up.x),          f(axes.back.x),          0,
            f(axes.right.y),          f(axes.up.y),          f(axes.back.y),          0,
            f(axes.right.z),          f(axes.up.z),          f(axes.back.z),          0,
            f(-dot(axes.right, eye)), f(-dot(axes.up, eye)), f(-dot(axes.back, eye)), 1};
}

Matrix4 projectionMatrix(const Camera& camera, Viewport viewport, double near, double far) {
    const double y = 1 / std::tan(camera.fovY / 2), x = y * viewport.height / viewport.width;
    Matrix4 m{};
    m[0] = static_cast<float>(x);
    m[5] = static_cast<float>(y);
    m[10] = static_cast<float>(-(far + near) / (far - near));
    m[11] = -1;
    m[14] = static_cast<float>(-2 * far * near / (far - near));
    return m;
}

} // namespace toile::picture
