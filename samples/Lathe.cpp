// SPDX-License-Identifier: GPL-3.0-or-later
#include "samples/Lathe.h"

#include "core/base/Contracts.h"

#include <cmath>
#include <numbers>

namespace toile::samples {

geometry::TriangleMesh lathed(const std::vector<Vec2>& profile, int around) {
    expects(profile.size() >= 3 && around >= 3 && profile.front().x == 0 && profile.back().x == 0,
            "a profile starts and ends on the axis");
    geometry::TriangleMesh mesh;
    const int rings = static_cast<int>(profile.size()) - 2, first = 0, last = 1 + rings * around;
    mesh.vertices.push_back({0, profile.front().y, 0});
    for (int r = 1; r <= rings; ++r)
        for (int k = 0; k < around; ++k) {
            const double angle = 2 * std::numbers::pi * k / around;
            const Vec2 p = profile[static_cast<std::size_t>(r)];
            mesh.vertices.push_back({p.x * std::sin(angle), p.y, p.x * std::cos(angle)});
        }
    mesh.vertices.push_back({0, profile.back().y, 0});
    const auto at = [&](int ring, int k) { return 1 + ring * around + k % around; };
    for (int k = 0; k < around; ++k) {
        mesh.triangles.push_back({first, at(0, k + 1), at(0, k)});
        for (int r = 0; r + 1 < rings; ++r) {
            mesh.triangles.push_back({at(r, k), at(r, k + 1), at(r + 1, k + 1)});
            mesh.triangles.push_back({at(r, k), at(r + 1, k + 1), at(r + 1, k)});
        }
        mesh.triangles.push_back({at(rings - 1, k), at(rings - 1, k + 1), last});
    }
    return mesh;
}

} // namespace toile::samples
