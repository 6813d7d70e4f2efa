// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/Tacks.h"

#include "core/base/Contracts.h"
#include "core/geometry/Polygon.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace toile::simulation {
namespace {

std::array<double, 3> barycentric(const std::array<Vec2, 3>& corners, Vec2 point) {
    const auto& [a, b, c] = corners;
    const double whole = geometry::cross(b - a, c - a);
    const double wb = geometry::cross(point - a, c - a) / whole, wc = geometry::cross(b - a, point - a) / whole;
    return {1 - wb - wc, wb, wc};
}

/// The point of a triangle that is nearest to a point outside it.
Vec2 nearestOnBorder(const std::array<Vec2, 3>& corners, Vec2 point) {
    Vec2 nearest = corners[0];
    for (std::size_t k = 0; k < 3; ++k) {
        const Vec2 on = geometry::closestOnSegment(corners[k], corners[(k + 1) % 3], point);
        if (distance(on, point) < distance(nearest, point)) nearest = on;
    }
    return nearest;
}

Vec3 placeOf(const MeshPoint& point, const ParticleMap& particles, std::span<const Vec3> positions) {
    Vec3 place;
    for (std::size_t k = 0; k < 3; ++k)
        place += point.weights[k] * positions[particles.particle({point.piece, point.nodes[k]})];
    return place;
}

} // namespace

MeshPoint meshPointAt(const meshing::GarmentMesh& mesh, int piece, Vec2 point) {
    constexpr double rounding = 1e-9;
    const meshing::PieceMesh& of = mesh.pieces[piece];
    expects(!of.display.empty(), "a mesh has triangles");
    MeshPoint best{.piece = piece};
    double nearest = std::numeric_limits<double>::infinity();
    for (const auto& nodes : of.display) {
        const std::array<Vec2, 3> corners{of.nodes[nodes[0]], of.nodes[nodes[1]], of.nodes[nodes[2]]};
        if (geometry::cross(corners[1] - corners[0], corners[2] - corners[0]) == 0) continue;
        const bool holds = std::ranges::min(barycentric(corners, point)) >= -rounding;
        const Vec2 on = holds ? point : nearestOnBorder(corners, point);
        if (const double far = distance(on, point); far < nearest) {
            nearest = far;
            best.nodes = nodes;
            best.weights = barycentric(corners, on);
        }
        if (holds) break;
    }
    return best;
}

std::vector<TackState> tacksOf(const pattern::Pattern& pattern, const meshing::GarmentMesh& mesh,
                               const TackSettings& settings) {
    std::vector<TackState> tacks;
    for (const pattern::Tack& tack : pattern.tacks) {
        TackState state{
            .name = tack.name.empty() ? tack.id.value : tack.name, .length = settings.play, .order = tack.order};
        for (std::size_t end = 0; end < 2; ++end) {
            const auto& [id, point] = tack.ends[end];
            const auto piece =
                std::ranges::find_if(pattern.pieces, [&](const auto& candidate) { return candidate->id == id; });
            expects(piece != pattern.pieces.end(), "checkPattern finds tacks of pieces that there are not");
            state.ends[end] = meshPointAt(mesh, static_cast<int>(piece - pattern.pieces.begin()), point);
            if (const auto* fabric = pattern::findFabric(pattern, (*piece)->fabric))
                state.length += 0.5 * fabric->thickness;
        }
        tacks.push_back(std::move(state));
    }
    return tacks;
}

Vec3 wayBetween(const TackState& tack, const ParticleMap& particles, std::span<const Vec3> positions) {
    return placeOf(tack.ends[1], particles, positions) - placeOf(tack.ends[0], particles, positions);
}

double gapBetween(const TackState& tack, const ParticleMap& particles, std::span<const Vec3> positions) {
    return std::max(0.0, length(wayBetween(tack, particles, positions)) - tack.length);
}

Tacks::Tacks(std::span<const TackState> tacks, const ParticleMap& particles, double duration,
             std::span<const double> mass, TackSettings settings)
    : duration_(duration), settings_(settings) {
    std::vector<double> rows(mass.size(), 0.0); // Gershgorin's
    for (const TackState& tack : tacks) {
        if (tack.start < 0) continue;
        threads_.push_back(threadOf(tack, particles, settings));
        const Thread& thread = threads_.back();
        for (int i = 0; i < thread.count; ++i)
            rows[thread.particles[i]] += 2 * thread.stiffness * std::abs(thread.coefficients[i]);
    }
    for (std::size_t p = 0; p < mass.size(); ++p)
        if (mass[p] > 0) frequencySquared_ = std::max(frequencySquared_, rows[p] / mass[p]);
}

/// Ends may share particles: on one triangle, or beside a seam.
Tacks::Thread Tacks::threadOf(const TackState& tack, const ParticleMap& particles, const TackSettings& settings) {
    Thread thread{.length = tack.length,
                  .startGap = tack.startGap,
                  .start = tack.start,
                  .stiffness = tack.closed ? settings.stiffness : settings.openStiffness,
                  .maximumForce = tack.closed ? settings.strength : settings.maximumForce};
    for (std::size_t end = 0; end < 2; ++end)
        for (std::size_t k = 0; k < 3; ++k) {
            const int particle = particles.particle({tack.ends[end].piece, tack.ends[end].nodes[k]});
            const auto known = thread.particles.begin() + thread.count;
            const auto place = std::find(thread.particles.begin(), known, particle);
            if (place == known) {
                *place = particle;
                ++thread.count;
            }
            thread.coefficients[place - thread.particles.begin()] +=
                end == 0 ? -tack.ends[end].weights[k] : tack.ends[end].weights[k];
        }
    return thread;
}

Vec3 Tacks::wayOf(const Thread& thread, std::span<const Vec3> positions) {
    Vec3 way;
    for (int i = 0; i < thread.count; ++i) way += thread.coefficients[i] * positions[thread.particles[i]];
    return way;
}

/// Falls from the gap at the start to nothing, as a seam's does.
double Tacks::allowedGap(const Thread& thread, double time) const {
    const double duration = std::max(duration_, 1.5 * thread.startGap / settings_.maximumSpeed);
    const double s = std::clamp((time - thread.start) / duration, 0.0, 1.0);
    return thread.startGap * (1 - s * s * (3 - 2 * s));
}

void Tacks::project(dynamics::Substep& substep) {
    for (int iteration = 0; iteration < settings_.iterations; ++iteration)
        for (const Thread& thread : threads_) {
            const Vec3 way = wayOf(thread, substep.positions);
            const double far = length(way), excess = far - thread.length - allowedGap(thread, substep.time);
            double mobility = 0;
            for (int i = 0; i < thread.count; ++i)
                mobility += thread.coefficients[i] * thread.coefficients[i] * substep.inverseMass[thread.particles[i]];
            if (excess <= 0 || mobility <= 0) continue;
            const double impulse =
                std::min(excess / mobility, thread.maximumForce * substep.duration * substep.duration);
            for (int i = 0; i < thread.count; ++i)
                substep.positions[thread.particles[i]] -=
                    way * (impulse * thread.coefficients[i] * substep.inverseMass[thread.particles[i]] / far);
        }
}

double Tacks::energy(std::span<const Vec3> positions) const {
    double sum = 0;
    for (const Thread& thread : threads_) {
        const double yields = thread.maximumForce / thread.stiffness; // from this gap on the force is constant
        const double gap = std::max(0.0, length(wayOf(thread, positions)) - thread.length);
        sum += gap <= yields ? 0.5 * thread.stiffness * gap * gap : thread.maximumForce * (gap - 0.5 * yields);
    }
    return sum;
}

void Tacks::addForces(std::span<const Vec3> positions, std::span<Vec3> forces) const {
    for (const Thread& thread : threads_) {
        const Vec3 way = wayOf(thread, positions);
        const double far = length(way), gap = far - thread.length;
        if (gap <= 0) continue;
        const double pull = std::min(thread.stiffness * gap, thread.maximumForce);
        for (int i = 0; i < thread.count; ++i)
            forces[thread.particles[i]] -= way * (pull * thread.coefficients[i] / far);
    }
}

void Tacks::addHessian(std::span<const Vec3> positions, dynamics::HessianSink& sink) const {
    for (const Thread& thread : threads_) {
        const Vec3 way = wayOf(thread, positions);
        const double far = length(way), gap = far - thread.length;
        if (gap <= 0) continue;
        const bool yields = thread.stiffness * gap > thread.maximumForce;
        const double along = yields ? 0 : thread.stiffness;
        const double across = std::min(thread.stiffness * gap, thread.maximumForce) / far;
        const Vec3 n = way / far;
        for (int i = 0; i < thread.count; ++i)
            for (int j = 0; j < thread.count; ++j) {
                const double both = thread.coefficients[i] * thread.coefficients[j];
                double block[9];
                for (int r = 0; r < 3; ++r)
                    for (int c = 0; c < 3; ++c)
                        block[3 * r + c] = both * (across * (r == c ? 1 : 0) + (along - across) * n[r] * n[c]);
                sink.add(thread.particles[i], thread.particles[j], block);
            }
    }
}

} // namespace toile::simulation
