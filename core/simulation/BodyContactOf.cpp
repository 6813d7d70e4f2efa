// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/BodyContactOf.h"

#include "core/dynamics/BodyContact.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace toile::simulation {
namespace {

/// Cells smaller than this follow every limb by their corners: a chord of 15 mm over a radius of 30 mm dips in by
/// 15²/(8·30) = 0.9 mm, less than a third of the skin offset.
constexpr double followingSize = 0.015; // [m]

double longestSide(const meshing::PieceMesh& mesh, std::span<const int> corners) {
    double longest = 0;
    for (std::size_t i = 0; i < corners.size(); ++i)
        for (std::size_t k = i + 1; k < corners.size(); ++k)
            longest = std::max(longest, geometry::distance(mesh.nodes[corners[i]], mesh.nodes[corners[k]]));
    return longest;
}

/// Cells that lie near a bump: the cloth may still slip by so much before the plan is made anew.
class NearBumps {
public:
    explicit NearBumps(std::vector<Vec3> bumps) : bumps_(std::move(bumps)) { std::ranges::sort(bumps_, {}, &Vec3::y); }
    [[nodiscard]] bool operator()(const Vec3& p) const {
        constexpr double reach = 0.03; // [m]
        const auto first = std::ranges::lower_bound(bumps_, p.y - reach, {}, &Vec3::y);
        const auto last = std::ranges::upper_bound(bumps_, p.y + reach, {}, &Vec3::y);
        return std::any_of(first, last, [&](const Vec3& bump) { return squaredLength(bump - p) < reach * reach; });
    }

private:
    std::vector<Vec3> bumps_; ///< with rising y
};

/// The blend of a cell's corners with these weights, which sum to 1.
dynamics::ContactSample blendOf(const std::vector<dynamics::ContactSample>& samples, std::span<const int> corners,
                                std::span<const double> weights) {
    dynamics::ContactSample blend;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const dynamics::ContactSample& corner = samples[corners[i]];
        for (const auto& [particle, weight] : corner.particles) {
            const auto known = std::ranges::find(blend.particles, particle, &std::pair<int, double>::first);
            if (known != blend.particles.end()) known->second += weights[i] * weight;
            else blend.particles.emplace_back(particle, weights[i] * weight);
        }
        blend.halfThickness += weights[i] * corner.halfThickness;
        blend.friction += weights[i] * corner.friction;
        blend.mass += weights[i] * corner.mass;
    }
    return blend;
}

/// A net of samples over a rectangle or a triangle, its corners left out. A bump that cloth rests on is a few
/// millimetres across.
void appendNet(std::vector<dynamics::ContactSample>& samples, std::span<const int> corners, double size) {
    constexpr double mesh = 0.005; // [m]
    const int parts = static_cast<int>(std::ceil(size / std::numbers::sqrt2 / mesh));
    const bool rectangle = corners.size() == 4;
    for (int i = 0; i <= parts; ++i)
        for (int k = 0; k <= (rectangle ? parts : parts - i); ++k) {
            const double u = static_cast<double>(i) / parts, v = static_cast<double>(k) / parts;
            const std::array<double, 4> weights = rectangle
                                                      ? std::array{(1 - u) * (1 - v), u * (1 - v), u * v, (1 - u) * v}
                                                      : std::array{1 - u - v, u, v, 0.0};
            if (std::ranges::max(weights) > 1 - 1e-9) continue;
            dynamics::ContactSample sample = blendOf(samples, corners, std::span(weights).first(corners.size()));
            samples.push_back(std::move(sample)); // only now may the corners move
        }
}

void appendMiddle(std::vector<dynamics::ContactSample>& samples, std::span<const int> corners) {
    std::vector<const dynamics::ContactSample*> ends;
    for (const int particle : corners) ends.push_back(&samples[particle]);
    dynamics::ContactSample middle = dynamics::middleOf(ends);
    samples.push_back(std::move(middle)); // only now may the corners move
}

/// The two corners that are farthest apart.
std::array<int, 2> longestSideOf(const std::vector<int>& corners, const meshing::PieceMesh& mesh,
                                 std::span<const int> nodes) {
    std::array<int, 2> ends{corners[0], corners[1]};
    double longest = 0;
    for (std::size_t i = 0; i < nodes.size(); ++i)
        for (std::size_t k = i + 1; k < nodes.size(); ++k)
            if (const double d = geometry::distance(mesh.nodes[nodes[i]], mesh.nodes[nodes[k]]); d > longest) {
                longest = d;
                ends = {corners[i], corners[k]};
            }
    return ends;
}

/// bodyMoves: a limb may then strike the cloth from any side and at any speed, and twist a rectangle by more than
/// the skin offset. Its two triangles are looked at instead.
void appendInner(std::vector<dynamics::ContactSample>& samples, const Garment& garment, const NearBumps& nearBump,
                 std::span<const Vec3> positions, bool bodyMoves) {
    for (std::size_t piece = 0; piece < garment.mesh->pieces.size(); ++piece) {
        const meshing::PieceMesh& mesh = garment.mesh->pieces[piece];
        const int first = garment.particles.firstNode[piece];
        const auto append = [&](std::span<const int> nodes) {
            std::vector<int> corners;
            for (const int node : nodes) corners.push_back(garment.particles.particleOf[first + node]);
            const double size = longestSide(mesh, nodes);
            if (std::ranges::any_of(corners, [&](int particle) { return nearBump(positions[particle]); })) {
                appendNet(samples, corners, size);
            } else if (size > followingSize) {
                if (bodyMoves) appendMiddle(samples, longestSideOf(corners, mesh, nodes));
                appendMiddle(samples, corners);
            }
        };
        if (bodyMoves) {
            for (const auto& triangle : mesh.display) append(triangle);
            continue;
        }
        for (const meshing::Rectangle& cell : mesh.rectangles) append(cell.nodes);
        for (const meshing::Triangle& t : mesh.triangles) append(t.nodes);
    }
}

/// Particles of a garment whose dents statics takes back at most: of finer cloth it takes more than three times the
/// iterations.
constexpr int mostTakenBack = 25000;

} // namespace

std::unique_ptr<dynamics::Stage> bodyContactOf(const Scene& scene, const Garment& garment,
                                               const collision::BodySurface& body, std::span<const Vec3> positions,
                                               bool bearsLayers) {
    std::vector<dynamics::ContactSample> samples =
        dynamics::particleSamples(garment.model, garment.halfThickness, garment.friction, scene.settings.bodyFriction);
    appendInner(samples, garment, NearBumps(body.bumps()), positions, body.hasMoved());
    dynamics::BodyContactSettings settings{.skinOffset = scene.settings.skinOffset, .bearsLayers = bearsLayers};
    if (garment.model.particleCount() > mostTakenBack) settings.takings = 0;
    return std::make_unique<dynamics::BodyContact>(body, std::move(samples), settings, garment.model.pinned);
}

dynamics::BodyContact* bodyContactIn(const StepPlan& plan) {
    return dynamic_cast<dynamics::BodyContact*>(plan.find("body contact"));
}

} // namespace toile::simulation
