// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/dynamics/Ways.h"

#include <algorithm>

namespace toile::dynamics {
namespace {

/// Round the start and the end of a way.
geometry::Box3 boxOf(const Vec3& way) {
    return {{std::min(way.x, 0.0), std::min(way.y, 0.0), std::min(way.z, 0.0)},
            {std::max(way.x, 0.0), std::max(way.y, 0.0), std::max(way.z, 0.0)}};
}

} // namespace

std::vector<geometry::Box3> waysOf(const cloth::ClothModel& model, std::span<const Vec3> from,
                                   std::span<const Vec3> to) {
    std::vector<geometry::Box3> ways(from.size());
    for (std::size_t p = 0; p < from.size(); ++p) ways[p] = boxOf(to[p] - from[p]);
    for (const cloth::Slave& slave : model.slaves) {
        geometry::Box3& way = ways[slave.particle] = {};
        for (const auto& [master, weight] : slave.masters) {
            const geometry::Box3 part = boxOf(weight * (to[master] - from[master]));
            way.low += part.low;
            way.high += part.high;
        }
    }
    return ways;
}

} // namespace toile::dynamics
