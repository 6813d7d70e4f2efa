// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/body/ArmLift.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace toile::body {
namespace {

using Neighbours = std::vector<std::vector<int>>;

Neighbours neighboursOf(const geometry::TriangleMesh& mesh) {
    Neighbours neighbours(mesh.vertices.size());
    for (const auto& triangle : mesh.triangles)
        for (std::size_t k = 0; k < 3; ++k) neighbours[triangle[k]].push_back(triangle[(k + 1) % 3]);
    return neighbours;
}

/// Where a point lies along a polyline and beside it.
struct Beside {
    double along = 0, away = 0; ///< [m]
};

Beside besideOf(const Vec3& p, const std::vector<Vec3>& line) {
    Beside best{0, std::numeric_limits<double>::infinity()};
    double gone = 0;
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        const Vec3 way = line[i + 1] - line[i];
        const double l = length(way), t = std::clamp(dot(p - line[i], way) / (l * l), 0.0, 1.0);
        const double away = geometry::distance(p, line[i] + way * t);
        if (away < best.away) best = {gone + t * l, away};
        gone += l;
    }
    return best;
}

/// The vertices of an arm beyond a place on its axis: those that hang together with its end there. Empty if they hang
/// together with the trunk.
std::vector<int> armBeyond(double place, const std::vector<Beside>& beside, const Neighbours& neighbours) {
    constexpr double thickest = 0.13; // of an arm and its hand, from the axis [m]
    const auto end =
        std::ranges::max_element(beside, {}, [](const Beside& b) { return b.away < thickest ? b.along : -1.0; });
    std::vector<int> arm{static_cast<int>(end - beside.begin())};
    std::vector<char> taken(beside.size(), 0);
    taken[arm[0]] = 1;
    for (std::size_t i = 0; i < arm.size(); ++i)
        for (const int next : neighbours[arm[i]]) {
            if (taken[next] || beside[next].along < place) continue;
            if (beside[next].away > thickest) return {};
            taken[next] = 1;
            arm.push_back(next);
        }
    return arm;
}

/// The whole arm, up to where it leaves the trunk.
std::vector<int> armOf(const std::vector<Vec3>& axis, const geometry::TriangleMesh& mesh,
                       const Neighbours& neighbours) {
    constexpr double nearest = 0.02, farthest = 0.25, step = 0.005; // along the axis [m]
    std::vector<Beside> beside;
    beside.reserve(mesh.vertices.size());
    for (const Vec3& v : mesh.vertices) beside.push_back(besideOf(v, axis));
    for (double place = nearest; place < farthest; place += step)
        if (auto arm = armBeyond(place, beside, neighbours); !arm.empty()) return arm;
    return {};
}

/// Each value becomes the mean of its neighbours', again and again: a step becomes a slope.
void smooth(std::vector<double>& values, const Neighbours& neighbours, int rounds) {
    std::vector<double> next(values.size());
    for (int round = 0; round < rounds; ++round) {
        for (std::size_t v = 0; v < values.size(); ++v) {
            double sum = values[v];
            for (const int n : neighbours[v]) sum += values[n];
            next[v] = sum / static_cast<double>(1 + neighbours[v].size());
        }
        std::swap(values, next);
    }
}

Vec3 turnedAboutForward(const Vec3& p, const Vec3& centre, double angle) {
    const double c = std::cos(angle), s = std::sin(angle), x = p.x - centre.x, y = p.y - centre.y;
    return {centre.x + c * x - s * y, centre.y + s * x + c * y, p.z};
}

} // namespace

Result<std::vector<double>> armShares(const Body& body) {
    constexpr double slope = 0.05; // to each side of where an arm begins [m]
    constexpr double nothing = 1e-6;
    const Neighbours neighbours = neighboursOf(body.mesh);
    double edges = 0, count = 0;
    for (std::size_t v = 0; v < neighbours.size(); ++v)
        for (const int n : neighbours[v]) {
            edges += geometry::distance(body.mesh.vertices[v], body.mesh.vertices[n]);
            ++count;
        }
    const double edge = count > 0 ? edges / count : slope;
    const int rounds = static_cast<int>(std::ceil(slope * slope / (edge * edge) * 2)); // a walk of √(rounds/2) edges
    std::vector<double> shares(body.mesh.vertices.size(), 0);
    for (const Limb limb : {Limb::leftArm, Limb::rightArm}) {
        const LimbAxis* axis = axisOf(body, limb);
        const std::vector<int> arm = axis ? armOf(axis->points, body.mesh, neighbours) : std::vector<int>{};
        if (arm.empty())
            return fail(ErrorCode::unsupported,
                        "The body has no arms that stand off from its trunk and could be lifted.");
        std::vector<double> share(shares.size(), 0);
        for (const int v : arm) share[v] = 1;
        smooth(share, neighbours, rounds);
        for (std::size_t v = 0; v < shares.size(); ++v)
            if (share[v] > nothing) shares[v] += limb == Limb::leftArm ? share[v] : -share[v];
    }
    return shares;
}

Result<geometry::VertexMotion> armLift(const Body& body, double angle, double seconds) {
    constexpr double poseTurn = 0.025; // at most, from pose to pose: a hand leaves its circle by 0.1 mm [rad]
    constexpr double fastest = 1.875;  // of the motion, over its mean
    if (!(std::abs(angle) <= std::numbers::pi))
        return fail(ErrorCode::invalidInput, "Arms are lifted by no more than a half turn.");
    if (!(seconds > 0)) return fail(ErrorCode::invalidInput, "Lifting the arms takes time.");
    const auto shares = armShares(body);
    if (!shares) return tl::unexpected(shares.error());
    const Vec3 left = axisOf(body, Limb::leftArm)->points.front(), right = axisOf(body, Limb::rightArm)->points.front();
    const int steps = std::max(2, static_cast<int>(std::ceil(fastest * std::abs(angle) / poseTurn)));
    geometry::VertexMotion motion{seconds / steps, {}};
    for (int i = 0; i <= steps; ++i) {
        const double t = static_cast<double>(i) / steps;
        const double turned = angle * t * t * t * (10 - 15 * t + 6 * t * t); // no jump of speed or force
        std::vector<Vec3> pose;
        pose.reserve(shares->size());
        for (std::size_t v = 0; v < shares->size(); ++v) {
            const double share = (*shares)[v];
            const Vec3& p = body.mesh.vertices[v];
            pose.push_back(share * turned == 0 ? p : turnedAboutForward(p, share > 0 ? left : right, share * turned));
        }
        motion.poses.push_back(std::move(pose));
    }
    return motion;
}

} // namespace toile::body
