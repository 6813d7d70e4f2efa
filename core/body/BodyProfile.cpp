// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/body/BodyProfile.h"

#include <algorithm>
#include <utility>

namespace toile::body {

namespace {

template <class Accept>
std::optional<SectionLoop> longestLoop(const geometry::TriangleMesh& mesh, double y, const Accept& accept) {
    std::optional<SectionLoop> best;
    for (SectionLoop& loop : sectionsOf(mesh, {{0, y, 0}, {0, 1, 0}}))
        if (accept(boundsOf(loop)) && (!best || perimeter(loop) > perimeter(*best))) best = std::move(loop);
    return best;
}

} // namespace

BodyProfile profileOf(const geometry::TriangleMesh& mesh) {
    const geometry::Box3 box = geometry::boundsOf(mesh.vertices);
    return {box.low.y, box.high.y - box.low.y, (box.low.x + box.high.x) / 2};
}

std::optional<SectionLoop> trunkAt(const geometry::TriangleMesh& mesh, const BodyProfile& profile, double y) {
    const double margin = 0.015 * profile.height; // a thigh that touches the middle does not span it
    return longestLoop(mesh, y, [&](const geometry::Box3& box) {
        return box.low.x < profile.middle - margin && box.high.x > profile.middle + margin;
    });
}

std::optional<SectionLoop> leftLegAt(const geometry::TriangleMesh& mesh, const BodyProfile& profile, double y) {
    const double margin = 0.01 * profile.height, reach = 0.2 * profile.height; // not a hand
    return longestLoop(mesh, y, [&](const geometry::Box3& box) {
        return box.low.x > profile.middle - margin && box.low.x < profile.middle + reach;
    });
}

geometry::Box3 boundsOf(const SectionLoop& loop) {
    return geometry::boundsOf(loop.points);
}

Vec3 farthest(const SectionLoop& loop, const Vec3& direction) {
    return *std::ranges::max_element(loop.points, {}, [&](const Vec3& p) { return dot(p, direction); });
}

std::optional<BackAndFront> crossingsAt(const SectionLoop& loop, double x) {
    std::optional<BackAndFront> result;
    for (std::size_t i = 0; i < loop.points.size(); ++i) {
        const Vec3 a = loop.points[i], b = loop.points[(i + 1) % loop.points.size()];
        if ((a.x < x) == (b.x < x)) continue;
        const Vec3 p = lerp(a, b, (x - a.x) / (b.x - a.x));
        if (!result) result = BackAndFront{p, p};
        if (p.z < result->back.z) result->back = p;
        if (p.z > result->front.z) result->front = p;
    }
    return result;
}

geometry::TriangleMesh mirrored(const geometry::TriangleMesh& mesh, double middle) {
    geometry::TriangleMesh result = mesh;
    for (Vec3& p : result.vertices) p.x = 2 * middle - p.x;
    for (auto& t : result.triangles) std::swap(t[1], t[2]);
    return result;
}

} // namespace toile::body
