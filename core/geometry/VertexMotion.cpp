// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/VertexMotion.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace toile::geometry {
namespace {

double farthestBetween(const std::vector<Vec3>& from, const std::vector<Vec3>& to) {
    double farthest = 0;
    for (std::size_t v = 0; v < from.size(); ++v) farthest = std::max(farthest, squaredLength(to[v] - from[v]));
    return std::sqrt(farthest);
}

/// On the way between two poses.
struct Between {
    const std::vector<Vec3>&from, &to;
    double share; ///< of the way that is done

    [[nodiscard]] Vec3 vertex(std::size_t v) const { return from[v] * (1 - share) + to[v] * share; }
};

Between betweenPoses(const VertexMotion& motion, double time) {
    constexpr double rounding = 1e-9; // of a sum of times, in poses
    const std::vector<std::vector<Vec3>>& poses = motion.poses;
    const double last = static_cast<double>(poses.size() - 1), asked = std::clamp(time / motion.step, 0.0, last);
    const double place = asked > last - rounding ? last : asked;
    const auto pose = std::min(static_cast<std::size_t>(place), poses.size() - 2);
    return {poses[pose], poses[pose + 1], place - static_cast<double>(pose)};
}

} // namespace

void VertexMotion::at(double time, std::vector<Vec3>& vertices) const {
    const Between now = betweenPoses(*this, time);
    vertices.resize(now.from.size());
    for (std::size_t v = 0; v < vertices.size(); ++v) vertices[v] = now.vertex(v);
}

Vec3 VertexMotion::vertexAt(std::size_t vertex, double time) const {
    return betweenPoses(*this, time).vertex(vertex);
}

double VertexMotion::farthest(double from, double to) const {
    const auto last = static_cast<double>(poses.size() - 1);
    const double begin = std::clamp(from / step, 0.0, last), end = std::clamp(to / step, 0.0, last);
    double way = 0;
    for (auto pose = static_cast<std::size_t>(begin); static_cast<double>(pose) < end; ++pose) {
        const double first = std::max(begin, static_cast<double>(pose));
        const double share = std::min(end, static_cast<double>(pose + 1)) - first;
        way += share * farthestBetween(poses[pose], poses[pose + 1]);
    }
    return way;
}

Result<void> checkedMotion(const VertexMotion& motion, const TriangleMesh& mesh, double tolerance) {
    if (motion.poses.size() < 2) return fail(ErrorCode::invalidInput, "A motion needs two poses at least.");
    if (!(motion.step > 0)) return fail(ErrorCode::invalidInput, "From pose to pose a motion takes time.");
    for (std::size_t i = 0; i < motion.poses.size(); ++i) {
        const std::vector<Vec3>& pose = motion.poses[i];
        if (pose.size() != mesh.vertices.size())
            return fail(ErrorCode::invalidInput, fmt::format("Pose {} has {} vertices, the body has {}.", i + 1,
                                                             pose.size(), mesh.vertices.size()));
        if (!std::ranges::all_of(pose, [](const Vec3& v) { return isFinite(v); }))
            return fail(ErrorCode::invalidInput, fmt::format("A coordinate of pose {} is not a finite number.", i + 1));
    }
    const double off = farthestBetween(motion.poses.front(), mesh.vertices);
    if (off > tolerance)
        return fail(
            ErrorCode::invalidInput,
            fmt::format("The first pose is not the body as it stands: a vertex is off by {:.1f} mm.", 1000 * off));
    return {};
}

} // namespace toile::geometry
