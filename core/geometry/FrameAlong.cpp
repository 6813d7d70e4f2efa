// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/FrameAlong.h"

#include "core/base/Contracts.h"

#include <algorithm>
#include <limits>

namespace toile::geometry {
namespace {

/// The direction of the line at one of its points: between those of the stretches before and behind it.
Vec3 directionAt(std::span<const Vec3> line, std::size_t i) {
    const Vec3 before = i > 0 ? normalized(line[i] - line[i - 1]) : Vec3{};
    const Vec3 behind = i + 1 < line.size() ? normalized(line[i + 1] - line[i]) : Vec3{};
    return normalized(before + behind);
}

/// The direction at an arc length: steadily from that of one point to that of the next.
Vec3 directionBetween(std::span<const Vec3> line, double at) {
    if (at <= 0) return directionAt(line, 0);
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        const double stretch = distance(line[i], line[i + 1]);
        if (at <= stretch) return normalized(lerp(directionAt(line, i), directionAt(line, i + 1), at / stretch));
        at -= stretch;
    }
    return directionAt(line, line.size() - 1);
}

Vec3 madeSquare(const Vec3& direction, const Vec3& to) {
    return normalized(direction - to * dot(direction, to));
}

Vec3 pointAt(std::span<const Vec3> line, double at) {
    if (at <= 0) return line[0] + normalized(line[1] - line[0]) * at;
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        const double stretch = distance(line[i], line[i + 1]);
        if (at <= stretch) return lerp(line[i], line[i + 1], at / stretch);
        at -= stretch;
    }
    return line.back() + normalized(line.back() - line[line.size() - 2]) * at;
}

} // namespace

double arcLength(std::span<const Vec3> line) {
    double sum = 0;
    for (std::size_t i = 0; i + 1 < line.size(); ++i) sum += distance(line[i], line[i + 1]);
    return sum;
}

Transform frameAlong(std::span<const Vec3> line, double at, const Vec3& up, double upAt) {
    expects(line.size() > 1, "a line has two ends");
    Vec3 z = madeSquare(up, directionBetween(line, upAt));
    const auto carryTo = [&](double station) { z = madeSquare(z, directionBetween(line, station)); };
    std::vector<double> between; // the line's points on the way
    double gone = 0;
    for (std::size_t i = 0; i < line.size(); ++i) {
        if (i > 0) gone += distance(line[i - 1], line[i]);
        if (gone > std::min(at, upAt) && gone < std::max(at, upAt)) between.push_back(gone);
    }
    if (at < upAt) std::ranges::reverse(between);
    std::ranges::for_each(between, carryTo);
    carryTo(at);
    const Vec3 y = directionBetween(line, at);
    return {cross(y, z), y, z, pointAt(line, at)};
}

double nearestArcLength(std::span<const Vec3> line, const Vec3& point) {
    double best = 0, least = std::numeric_limits<double>::infinity(), gone = 0;
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        const double stretch = distance(line[i], line[i + 1]);
        const Vec3 along = (line[i + 1] - line[i]) / stretch;
        const double low = i == 0 ? -std::numeric_limits<double>::infinity() : 0;
        const double high = i + 2 == line.size() ? std::numeric_limits<double>::infinity() : stretch;
        const double t = std::clamp(dot(point - line[i], along), low, high);
        const double away = squaredLength(point - (line[i] + along * t));
        if (away < least) {
            least = away;
            best = gone + t;
        }
        gone += stretch;
    }
    return best;
}

Polyline rounded(std::span<const Vec3> line, double step, double rounding) {
    constexpr double reach = 3; // of the bell, in standard deviations; beyond it lie 0.3 % of the weight
    const double whole = arcLength(line);
    const int parts = std::max(1, static_cast<int>(std::lround(whole / step)));
    const int width = static_cast<int>(std::ceil(reach * rounding / step));
    Polyline result;
    for (int i = 0; i <= parts; ++i) {
        Vec3 sum;
        double weights = 0;
        for (int k = -width; k <= width; ++k) {
            const double away = k * step / rounding, weight = std::exp(-0.5 * away * away);
            sum += pointAt(line, whole * i / parts + k * step) * weight;
            weights += weight;
        }
        result.push_back(sum / weights);
    }
    return result;
}

} // namespace toile::geometry
