// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/dynamics/SelfContact.h"

#include <cmath>

/// What has passed through itself already: found, and drawn apart.
namespace toile::dynamics {

void SelfContact::seekPiercings(std::span<const Vec3> positions) {
    piercings_ = proximity_->piercings(positions);
    std::erase_if(piercings_, [&](const collision::Piercing& piercing) {
        const auto& [p, q] = proximity_->edges()[piercing.edge].vertices;
        const auto& [a, b, c] = proximity_->triangles()[piercing.triangle];
        return isIgnored({{p, a, b, c}, 1}) || isIgnored({{q, a, b, c}, 1});
    });
    mayPierce_ = !piercings_.empty();
}

std::vector<Vec3> SelfContact::crossingPlaces(std::span<const Vec3> positions) const {
    std::vector<Vec3> places;
    for (const auto& [edge, triangle] : piercings_) {
        const auto& [p, q] = proximity_->edges()[edge].vertices;
        places.push_back(lerp(positions[p], positions[q], 0.5));
    }
    return places;
}

/// Draws edges out of triangles they pass through: each pair goes apart the way that shortens the line along
/// which the layers meet. Ref: Volino & Magnenat-Thalmann 2006, Resolving Surface Collisions through
/// Intersection Contour Minimization
void SelfContact::uncross(Substep& substep) const {
    const auto& x = substep.positions;
    for (const auto& [edge, triangle] : piercings_) {
        const auto& [p, q] = proximity_->edges()[edge].vertices;
        const auto& corners = proximity_->triangles()[triangle];
        const Vec3 &a = x[corners[0]], &b = x[corners[1]], &c = x[corners[2]];
        if (!collision::segmentPierces(x[p], x[q], a, b, c)) continue;
        const Vec3 normal = normalized(cross(b - a, c - a)), along = normalized(x[q] - x[p]);
        const double steepness = dot(along, normal);
        Vec3 shortening; // where the edge should go
        for (const int across : proximity_->edges()[edge].opposite) {
            if (across < 0) continue;
            const Vec3 inward = x[across] - x[p], faceNormal = cross(x[q] - x[p], inward);
            Vec3 line = cross(normal, faceNormal);
            const double size = length(line);
            if (size == 0) continue;
            line = line / (dot(line, inward - along * dot(inward, along)) > 0 ? size : -size);
            shortening += line - normal * (dot(along, line) / steepness);
        }
        const double size = length(shortening);
        if (!(size > 1e-6) || !std::isfinite(size)) continue; // the line would not become shorter
        const double t = dot(normal, a - x[p]) / dot(normal, x[q] - x[p]);
        const Vec3 at = lerp(x[p], x[q], t), whole = cross(b - a, c - a);
        const double ofA = dot(cross(b - at, c - at), whole) / squaredLength(whole);
        const double ofB = dot(cross(c - at, a - at), whole) / squaredLength(whole);
        const std::array<int, 5> particles{p, q, corners[0], corners[1], corners[2]};
        const std::array<double, 5> weights{1 - t, t, -ofA, -ofB, ofA + ofB - 1};
        double mobility = 0;
        for (int i = 0; i < 5; ++i) mobility += weights[i] * weights[i] * substep.inverseMass[particles[i]];
        if (mobility == 0) continue;
        const Vec3 way = shortening * (settings_.pushOutSpeed * substep.duration / size);
        for (int i = 0; i < 5; ++i)
            move(particles[i], way * (weights[i] * substep.inverseMass[particles[i]] / mobility), substep);
    }
}

} // namespace toile::dynamics
