// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/dynamics/SelfContact.h"

#include "core/base/UnionFind.h"

#include <algorithm>
#include <cmath>
#include <map>

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
    findWhatWentThrough();
}

/// Cutting all edges that pierce cuts what has gone through off from the cloth it belongs to, where the line of the
/// crossing goes from border to border or closes on itself: less hangs together there.
void SelfContact::findWhatWentThrough() {
    hanging_.clear();
    if (piercings_.empty()) return;
    const std::vector<collision::SurfaceEdge>& edges = proximity_->edges();
    std::vector<char> isCut(edges.size(), 0);
    for (const collision::Piercing& piercing : piercings_) isCut[piercing.edge] = 1;

    UnionFind parts(model_.mass.size());
    for (std::size_t e = 0; e < edges.size(); ++e)
        if (isCut[e] == 0) parts.join(edges[e].vertices[0], edges[e].vertices[1]);
    std::vector<int> count(model_.mass.size(), 0);
    for (int p = 0; p < model_.particleCount(); ++p) ++count[parts.rootOf(p)];
    for (int p = 0; p < model_.particleCount(); ++p) hanging_.push_back(count[parts.rootOf(p)]);
}

std::vector<Vec3> SelfContact::crossingPlaces(std::span<const Vec3> positions) const {
    std::vector<Vec3> places;
    for (const auto& [edge, triangle] : piercings_) {
        const auto& [p, q] = proximity_->edges()[edge].vertices;
        places.push_back(lerp(positions[p], positions[q], 0.5));
    }
    return places;
}

void SelfContact::findTrianglesOfEdges() {
    std::map<std::array<int, 2>, std::array<int, 2>> triangles;
    for (std::size_t t = 0; t < surface_.triangles.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k) {
            const int a = surface_.triangles[t][k], b = surface_.triangles[t][(k + 1) % 3];
            const auto triangle = static_cast<int>(t);
            const auto [edge, isNew] =
                triangles.try_emplace({std::min(a, b), std::max(a, b)}, std::array{triangle, triangle});
            if (!isNew) edge->second[1] = triangle;
        }
    edgeTriangles_.clear();
    for (const collision::SurfaceEdge& edge : proximity_->edges())
        edgeTriangles_.push_back(
            triangles.at({std::min(edge.vertices[0], edge.vertices[1]), std::max(edge.vertices[0], edge.vertices[1])}));
}

Vec3 SelfContact::normalOf(int triangle, std::span<const Vec3> x) const {
    const auto& [a, b, c] = surface_.triangles[triangle];
    return normalized(cross(x[b] - x[a], x[c] - x[a]));
}

/// The higher goes to the right side of the lower, whichever side of its own it turns to it: a collar lies face to face
/// on its stand. Nowhere where neither is higher.
Vec3 SelfContact::orderlyWay(const collision::Piercing& piercing, const Vec3& normal, std::span<const Vec3> x) const {
    if (edgeTriangles_.empty()) return {};
    const auto& [first, second] = edgeTriangles_[piercing.edge];
    if (surface_.layers[first] != surface_.layers[second]) return {};
    const int higher = surface_.layers[first] - surface_.layers[piercing.triangle];
    if (higher >= 0) return higher > 0 ? normal : Vec3{};
    return dot(normalOf(first, x) + normalOf(second, x), normal) > 0 ? -normal : normal;
}

/// The way on which less of the cloth comes back through the other: of an edge that is cut towards its end on which
/// more hangs; of an edge through a triangle that is, towards the corners on which less hangs. Nowhere where both hang
/// together still.
Vec3 SelfContact::wayBack(const collision::Piercing& piercing, const Vec3& normal, std::span<const Vec3> x) const {
    const auto& [p, q] = proximity_->edges()[piercing.edge].vertices;
    if (hanging_[p] != hanging_[q]) {
        const Vec3 out = hanging_[p] < hanging_[q] ? x[q] - x[p] : x[p] - x[q];
        return dot(normal, out) > 0 ? normal : -normal;
    }
    const auto& corners = proximity_->triangles()[piercing.triangle];
    const int most = std::max({hanging_[corners[0]], hanging_[corners[1]], hanging_[corners[2]]});
    Vec3 through, behind;
    int passed = 0;
    for (const int corner : corners) {
        const bool isThrough = hanging_[corner] < most;
        (isThrough ? through : behind) += x[corner];
        passed += isThrough;
    }
    return passed > 0 ? normalized(through / passed - behind / (3 - passed)) : Vec3{};
}

Vec3 SelfContact::shorteningWay(const collision::Piercing& piercing, const Vec3& normal,
                                std::span<const Vec3> x) const {
    const collision::SurfaceEdge& edge = proximity_->edges()[piercing.edge];
    const auto& [p, q] = edge.vertices;
    const Vec3 along = normalized(x[q] - x[p]);
    const double steepness = dot(along, normal);
    Vec3 shortening;
    for (const int across : edge.opposite) {
        if (across < 0) continue;
        const Vec3 inward = x[across] - x[p], faceNormal = cross(x[q] - x[p], inward);
        Vec3 line = cross(normal, faceNormal);
        const double size = length(line);
        if (size == 0) continue;
        line = line / (dot(line, inward - along * dot(inward, along)) > 0 ? size : -size);
        shortening += line - normal * (dot(along, line) / steepness);
    }
    return shortening;
}

/// Draws edges out of triangles they pass through: each pair goes apart to the sides that their layers belong to or,
/// where these are alike, the way on which what has gone through comes back (Baraff, Witkin & Kass 2003, Untangling
/// Cloth); where the crossing cuts nothing off, the way that shortens the line along which the layers meet. Ref: Volino
/// & Magnenat-Thalmann 2006, Resolving Surface Collisions through Intersection Contour Minimization
void SelfContact::uncross(Substep& substep) const {
    const auto& x = substep.positions;
    for (const collision::Piercing& piercing : piercings_) {
        const auto& [p, q] = proximity_->edges()[piercing.edge].vertices;
        const auto& corners = proximity_->triangles()[piercing.triangle];
        const Vec3 &a = x[corners[0]], &b = x[corners[1]], &c = x[corners[2]];
        if (!collision::segmentPierces(x[p], x[q], a, b, c)) continue;
        const Vec3 normal = normalOf(piercing.triangle, x);
        Vec3 there = orderlyWay(piercing, normal, x); // where the edge should go
        if (there == Vec3{}) there = wayBack(piercing, normal, x);
        if (there == Vec3{}) there = shorteningWay(piercing, normal, x);
        const double size = length(there);
        if (!(size > 1e-6) || !std::isfinite(size)) continue; // the line would not become shorter
        const double t = dot(normal, a - x[p]) / dot(normal, x[q] - x[p]);
        const Vec3 at = lerp(x[p], x[q], t), whole = cross(b - a, c - a);
        const double ofA = dot(cross(b - at, c - at), whole) / squaredLength(whole);
        const double ofB = dot(cross(c - at, a - at), whole) / squaredLength(whole);
        const std::array<int, 5> particles{p, q, corners[0], corners[1], corners[2]};
        const std::array<double, 5> weights{1 - t, t, -ofA, -ofB, ofA + ofB - 1};
        double mobility = 0;
        Vec3 gone; // of the edge against the triangle
        for (int i = 0; i < 5; ++i) {
            mobility += weights[i] * weights[i] * substep.inverseMass[particles[i]];
            gone += weights[i] * (x[particles[i]] - substep.previous[particles[i]]);
        }
        const double missing = settings_.pushOutSpeed * substep.duration - dot(gone, there) / size;
        if (mobility == 0 || missing <= 0) continue;
        const Vec3 way = there * (missing / size);
        for (int i = 0; i < 5; ++i)
            move(particles[i], way * (weights[i] * substep.inverseMass[particles[i]] / mobility), substep);
    }
}

} // namespace toile::dynamics
