// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/collision/SmoothDistance.h"

#include "core/base/Contracts.h"

#include <cmath>
#include <limits>

namespace toile::collision {
namespace {

/// Weights of four nodes in a row at 0 ≤ t ≤ 1 between the middle two, and their derivatives by t.
struct Weights {
    std::array<double, 4> value, slope, curvature;
};

Weights weightsAt(double t) {
    const double u = 1 - t;
    return {{u * u * u / 6, (3 * t * t * t - 6 * t * t + 4) / 6, (3 * u * u * u - 6 * u * u + 4) / 6, t * t * t / 6},
            {-u * u / 2, (3 * t * t - 4 * t) / 2, (4 * u - 3 * u * u) / 2, t * t / 2},
            {u, 3 * t - 2, 3 * u - 2, t}};
}

/// One number for a place of the lattice; 21 bits an axis.
std::uint64_t keyOf(const std::array<std::int32_t, 3>& place) {
    constexpr std::int64_t half = 1 << 20;
    std::uint64_t key = 0;
    for (const std::int32_t i : place) key = key << 21 | static_cast<std::uint64_t>(i + half);
    return key;
}

} // namespace

void SmoothDistance::fill(Patch& patch) {
    double radius = std::numeric_limits<double>::infinity();
    std::size_t n = 0;
    for (int i = -1; i < 3; ++i)
        for (int j = -1; j < 3; ++j)
            for (int k = -1; k < 3; ++k) {
                const std::array place{patch.cell[0] + i, patch.cell[1] + j, patch.cell[2] + k};
                const auto [node, isNew] = nodes_.try_emplace(keyOf(place), 0.0);
                if (isNew) {
                    const Vec3 p = Vec3{double(place[0]), double(place[1]), double(place[2])} * spacing_;
                    node->second = body_.nearest(p, radius)->signedDistance;
                }
                radius = std::abs(node->second) + 6 * spacing_; // the nodes of a patch are no farther from each other
                patch.nodes[n++] = node->second;
            }
    patch.known = true;
}

SmoothValue SmoothDistance::at(const Vec3& p, Patch& patch) {
    const Vec3 place = p / spacing_;
    const std::array cell{static_cast<std::int32_t>(std::floor(place.x)),
                          static_cast<std::int32_t>(std::floor(place.y)),
                          static_cast<std::int32_t>(std::floor(place.z))};
    if (!patch.known || patch.cell != cell) {
        patch.cell = cell;
        fill(patch);
    }
    const Weights x = weightsAt(place.x - cell[0]), y = weightsAt(place.y - cell[1]), z = weightsAt(place.z - cell[2]);
    double v = 0, vx = 0, vy = 0, vz = 0, vxx = 0, vyy = 0, vzz = 0, vxy = 0, vxz = 0, vyz = 0;
    const double* node = patch.nodes.data();
    for (std::size_t i = 0; i < 4; ++i) {
        double a = 0, ay = 0, az = 0, ayy = 0, azz = 0, ayz = 0;
        for (std::size_t j = 0; j < 4; ++j, node += 4) {
            double b = 0, bz = 0, bzz = 0;
            for (std::size_t k = 0; k < 4; ++k) {
                b += z.value[k] * node[k];
                bz += z.slope[k] * node[k];
                bzz += z.curvature[k] * node[k];
            }
            a += y.value[j] * b;
            ay += y.slope[j] * b;
            ayy += y.curvature[j] * b;
            az += y.value[j] * bz;
            ayz += y.slope[j] * bz;
            azz += y.value[j] * bzz;
        }
        v += x.value[i] * a;
        vx += x.slope[i] * a;
        vxx += x.curvature[i] * a;
        vy += x.value[i] * ay;
        vxy += x.slope[i] * ay;
        vyy += x.value[i] * ayy;
        vz += x.value[i] * az;
        vxz += x.slope[i] * az;
        vyz += x.value[i] * ayz;
        vzz += x.value[i] * azz;
    }
    const double one = 1 / spacing_, two = one * one;
    return {v,
            {vx * one, vy * one, vz * one},
            {vxx * two, vxy * two, vxz * two, vxy * two, vyy * two, vyz * two, vxz * two, vyz * two, vzz * two}};
}

std::size_t SmoothDistance::bytes() const {
    return nodes_.size() * (sizeof(decltype(nodes_)::value_type) + 2 * sizeof(void*)) +
           nodes_.bucket_count() * sizeof(void*);
}

} // namespace toile::collision
