// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/picture/Lights.h"

namespace toile::picture {

namespace {

Vec3 fromAngles(double yaw, double pitch) {
    return {std::sin(yaw) * std::cos(pitch), std::sin(pitch), std::cos(yaw) * std::cos(pitch)};
}

} // namespace

Lights lightsOf(const Camera& camera) {
    return {fromAngles(camera.yaw - 0.95, 0.80), fromAngles(camera.yaw + 1.1, 0.15), fromAngles(camera.yaw + 2.6, 0.6)};
}

Matrix4 shadowMatrix(const Vec3& towardsLight, const Vec3& centre, double radius) {
    const Vec3 right = normalized(cross({0, 1, 0}, towardsLight)), up = cross(towardsLight, right);
    constexpr double depths = 4; // radii from the front of the sphere to the end of the cube
    const double perDepth = 2 / (depths * radius);
    const auto f = [](double x) { return static_cast<float>(x); };
    return {f(right.x / radius),
            f(up.x / radius),
            f(-towardsLight.x * perDepth),
            0,
            f(right.y / radius),
            f(up.y / radius),
            f(-towardsLight.y * perDepth),
            0,
            f(right.z / radius),
            f(up.z / radius),
            f(-towardsLight.z * perDepth),
            0,
            f(-dot(right, centre) / radius),
            f(-dot(up, centre) / radius),
            f(dot(towardsLight, centre) * perDepth - 1 + 2 / depths),
            1};
}

} // namespace toile::picture
