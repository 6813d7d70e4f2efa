// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

namespace toile::geometry {

/// A point or direction of the plane: x weft, y warp [m].
struct Vec2 {
    double x = 0, y = 0;

    constexpr Vec2& operator+=(Vec2 b) {
        x += b.x;
        y += b.y;
        return *this;
    }
    constexpr Vec2& operator-=(Vec2 b) {
        x -= b.x;
        y -= b.y;
        return *this;
    }
    constexpr Vec2& operator*=(double s) {
        x *= s;
        y *= s;
        return *this;
    }
    friend constexpr bool operator==(Vec2, Vec2) = default;
};

constexpr Vec2 operator+(Vec2 a, Vec2 b) {
    return {a.x + b.x, a.y + b.y};
}
constexpr Vec2 operator-(Vec2 a, Vec2 b) {
    return {a.x - b.x, a.y - b.y};
}
constexpr Vec2 operator-(Vec2 a) {
    return {-a.x, -a.y};
}
constexpr Vec2 operator*(Vec2 a, double s) {
    return {a.x * s, a.y * s};
}
constexpr Vec2 operator*(double s, Vec2 a) {
    return a * s;
}
constexpr Vec2 operator/(Vec2 a, double s) {
    return {a.x / s, a.y / s};
}
constexpr double dot(Vec2 a, Vec2 b) {
    return a.x * b.x + a.y * b.y;
}
/// z of the cross product; positive when b lies to the left of a.
constexpr double cross(Vec2 a, Vec2 b) {
    return a.x * b.y - a.y * b.x;
}
/// a turned left by 90 degrees.
constexpr Vec2 leftOf(Vec2 a) {
    return {-a.y, a.x};
}
constexpr double squaredLength(Vec2 a) {
    return dot(a, a);
}
inline double length(Vec2 a) {
    return std::hypot(a.x, a.y);
}
inline double distance(Vec2 a, Vec2 b) {
    return length(b - a);
}
inline Vec2 normalized(Vec2 a) {
    return a / length(a);
}
constexpr Vec2 lerp(Vec2 a, Vec2 b, double t) {
    return a * (1 - t) + b * t;
}
/// a turned counter-clockwise by an angle [rad].
inline Vec2 rotated(Vec2 a, double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    return {c * a.x - s * a.y, s * a.x + c * a.y};
}

/// A point or direction of space: right-handed, y up [m].
struct Vec3 {
    double x = 0, y = 0, z = 0;

    constexpr Vec3& operator+=(const Vec3& b) {
        x += b.x;
        y += b.y;
        z += b.z;
        return *this;
    }
    constexpr Vec3& operator-=(const Vec3& b) {
        x -= b.x;
        y -= b.y;
        z -= b.z;
        return *this;
    }
    constexpr Vec3& operator*=(double s) {
        x *= s;
        y *= s;
        z *= s;
        return *this;
    }
    constexpr double& operator[](int i) { return i == 0 ? x : i == 1 ? y : z; }
    constexpr double operator[](int i) const { return i == 0 ? x : i == 1 ? y : z; }
    friend constexpr bool operator==(const Vec3&, const Vec3&) = default;
};

constexpr Vec3 operator+(const Vec3& a, const Vec3& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
constexpr Vec3 operator-(const Vec3& a, const Vec3& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
constexpr Vec3 operator-(const Vec3& a) {
    return {-a.x, -a.y, -a.z};
}
constexpr Vec3 operator*(const Vec3& a, double s) {
    return {a.x * s, a.y * s, a.z * s};
}
constexpr Vec3 operator*(double s, const Vec3& a) {
    return a * s;
}
constexpr Vec3 operator/(const Vec3& a, double s) {
    return {a.x / s, a.y / s, a.z / s};
}
constexpr double dot(const Vec3& a, const Vec3& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
constexpr Vec3 cross(const Vec3& a, const Vec3& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
constexpr double squaredLength(const Vec3& a) {
    return dot(a, a);
}
inline double length(const Vec3& a) {
    return std::sqrt(squaredLength(a));
}
inline double distance(const Vec3& a, const Vec3& b) {
    return length(b - a);
}
inline Vec3 normalized(const Vec3& a) {
    return a / length(a);
}
constexpr Vec3 lerp(const Vec3& a, const Vec3& b, double t) {
    return a * (1 - t) + b * t;
}
inline bool isFinite(const Vec3& a) {
    return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z);
}
inline bool isFinite(Vec2 a) {
    return std::isfinite(a.x) && std::isfinite(a.y);
}

/// A rigid or affine map of space: p ↦ axisX·p.x + axisY·p.y + axisZ·p.z + origin.
struct Transform {
    Vec3 axisX{1, 0, 0}, axisY{0, 1, 0}, axisZ{0, 0, 1}, origin{};

    [[nodiscard]] constexpr Vec3 direction(const Vec3& d) const { return axisX * d.x + axisY * d.y + axisZ * d.z; }
    [[nodiscard]] constexpr Vec3 point(const Vec3& p) const { return direction(p) + origin; }
    friend constexpr bool operator==(const Transform&, const Transform&) = default;
};

/// The map that does `inner` first, then `outer`.
constexpr Transform composed(const Transform& outer, const Transform& inner) {
    return {outer.direction(inner.axisX), outer.direction(inner.axisY), outer.direction(inner.axisZ),
            outer.point(inner.origin)};
}

} // namespace toile::geometry

namespace toile {
using geometry::Transform;
using geometry::Vec2;
using geometry::Vec3;
} // namespace toile
