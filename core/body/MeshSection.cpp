// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/body/MeshSection.h"

#include "core/geometry/Polygon.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <unordered_map>

namespace toile::body {

namespace {

using geometry::TriangleMesh;

struct PlaneAxes {
    Vec3 u, v;
};

PlaneAxes axesOf(const Vec3& normal) {
    const Vec3 helper = std::abs(normal.x) < 0.9 ? Vec3{1, 0, 0} : Vec3{0, 0, -1};
    const Vec3 v = normalized(cross(normal, helper));
    return {cross(v, normal), v};
}

std::uint64_t edgeKey(int a, int b) {
    const auto [low, high] = std::minmax(a, b);
    return static_cast<std::uint64_t>(static_cast<std::uint32_t>(low)) << 32 | static_cast<std::uint32_t>(high);
}

/// The crossing of each cut triangle: from the edge it enters through to the edge it leaves through.
struct Crossings {
    std::unordered_map<std::uint64_t, std::uint64_t> next; ///< edge → edge, the body on the same side throughout
    std::unordered_map<std::uint64_t, Vec3> at;
    std::vector<std::uint64_t> starts; ///< in the order of the triangles
};

Crossings crossingsOf(const TriangleMesh& mesh, const Plane& plane) {
    std::vector<double> height(mesh.vertices.size());
    for (std::size_t v = 0; v < height.size(); ++v) height[v] = dot(mesh.vertices[v] - plane.origin, plane.normal);
    Crossings result;
    for (const auto& t : mesh.triangles) {
        std::uint64_t in = 0, out = 0;
        int found = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            const int a = t[i], b = t[(i + 1) % 3];
            if ((height[a] < 0) == (height[b] < 0)) continue;
            const int low = std::min(a, b), high = std::max(a, b);
            const std::uint64_t key = edgeKey(a, b);
            result.at[key] = lerp(mesh.vertices[low], mesh.vertices[high], height[low] / (height[low] - height[high]));
            (height[a] < 0 ? in : out) = key;
            ++found;
        }
        if (found != 2) continue;
        result.next[in] = out;
        result.starts.push_back(in);
    }
    return result;
}

} // namespace

std::vector<SectionLoop> sectionsOf(const TriangleMesh& mesh, const Plane& plane) {
    Crossings crossings = crossingsOf(mesh, plane);
    std::unordered_map<std::uint64_t, std::uint64_t> before;
    for (const auto& [from, to] : crossings.next) before[to] = from;
    std::vector<SectionLoop> loops;
    for (const std::uint64_t start : crossings.starts) {
        if (!crossings.next.contains(start)) continue; // already part of a loop
        std::uint64_t first = start;
        for (auto back = before.find(first);
             back != before.end() && crossings.next.contains(back->second) && back->second != start;
             back = before.find(first))
            first = back->second; // an open curve begins at its end
        SectionLoop loop{plane, {crossings.at[first]}};
        for (auto step = crossings.next.find(first); step != crossings.next.end(); step = crossings.next.find(first)) {
            first = step->second;
            crossings.next.erase(step);
            if (crossings.next.contains(first) || !before.contains(first)) loop.points.push_back(crossings.at[first]);
        }
        if (loop.points.size() >= 3) loops.push_back(std::move(loop));
    }
    return loops;
}

std::optional<SectionLoop> sectionRound(const TriangleMesh& mesh, const Plane& plane) {
    std::optional<SectionLoop> best;
    for (SectionLoop& loop : sectionsOf(mesh, plane)) {
        if (geometry::windingNumber(inPlane(loop), {0, 0}) == 0) continue;
        if (!best || perimeter(loop) < perimeter(*best)) best = std::move(loop);
    }
    return best;
}

std::vector<Vec2> inPlane(const SectionLoop& loop) {
    const auto [u, v] = axesOf(loop.plane.normal);
    std::vector<Vec2> result;
    result.reserve(loop.points.size());
    for (const Vec3& p : loop.points) result.push_back({dot(p - loop.plane.origin, u), dot(p - loop.plane.origin, v)});
    return result;
}

double perimeter(const std::vector<Vec2>& polygon) {
    double sum = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) sum += distance(polygon[i], polygon[(i + 1) % polygon.size()]);
    return sum;
}

double perimeter(const SectionLoop& loop) {
    return perimeter(inPlane(loop));
}

double tapeGirth(const SectionLoop& loop) {
    return perimeter(convexHull(inPlane(loop)));
}

Vec3 centreOf(const SectionLoop& loop) {
    const std::vector<Vec2> p = inPlane(loop);
    const Vec2 base = p.front();
    double area = 0;
    Vec2 moment;
    for (std::size_t i = 0; i < p.size(); ++i) {
        const Vec2 a = p[i] - base, b = p[(i + 1) % p.size()] - base;
        area += cross(a, b) / 2;
        moment += (a + b) * (cross(a, b) / 6);
    }
    const Vec2 centre = area == 0 ? base : base + moment / area;
    const auto [u, v] = axesOf(loop.plane.normal);
    return loop.plane.origin + u * centre.x + v * centre.y;
}

std::vector<Vec2> convexHull(std::vector<Vec2> points) {
    std::ranges::sort(points, [](Vec2 a, Vec2 b) { return a.x < b.x || (a.x == b.x && a.y < b.y); });
    std::vector<Vec2> hull;
    const auto add = [&](Vec2 p, std::size_t keep) {
        while (hull.size() >= keep + 2 && cross(hull.back() - hull[hull.size() - 2], p - hull.back()) <= 0)
            hull.pop_back();
        hull.push_back(p);
    };
    for (const Vec2 p : points) add(p, 0);
    const std::size_t lower = hull.size() - 1;
    for (std::size_t i = points.size() - 1; i-- > 0;) add(points[i], lower);
    if (hull.size() > 1) hull.pop_back();
    return hull;
}

} // namespace toile::body
