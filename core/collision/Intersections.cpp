// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/collision/Intersections.h"

#include "core/base/Contracts.h"
#include "core/collision/ExactGeometry.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace toile::collision {
namespace {

/// Step of the grid [m]: 2⁻³⁰ (about 1 nm), more only where a coordinate is beyond 512 m.
double gridStep(const geometry::TriangleMesh& a, const geometry::TriangleMesh& b) {
    double largest = 0;
    for (const auto* mesh : {&a, &b})
        for (const Vec3& v : mesh->vertices) {
            expects(isFinite(v), "positions are finite");
            largest = std::max({largest, std::abs(v.x), std::abs(v.y), std::abs(v.z)});
        }
    double step = std::ldexp(1.0, -30);
    while (largest / step > static_cast<double>(exact::largestCoordinate)) step *= 2;
    return step;
}

/// A triangle on the grid in its box, and where it stands in its mesh.
struct Boxed {
    exact::Triangle corners;
    exact::Point low, high;
    int index = 0;
};

exact::Point snapped(const Vec3& v, double step) {
    return {std::llround(v.x / step), std::llround(v.y / step), std::llround(v.z / step)};
}

std::vector<Boxed> boxedTriangles(const geometry::TriangleMesh& mesh, double step) {
    std::vector<Boxed> result;
    result.reserve(mesh.triangles.size());
    for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
        Boxed boxed;
        boxed.index = static_cast<int>(f);
        for (int k = 0; k < 3; ++k) boxed.corners[k] = snapped(mesh.vertices[mesh.triangles[f][k]], step);
        for (int axis = 0; axis < 3; ++axis) {
            const auto [low, high] =
                std::minmax({boxed.corners[0][axis], boxed.corners[1][axis], boxed.corners[2][axis]});
            boxed.low[axis] = low;
            boxed.high[axis] = high;
        }
        result.push_back(boxed);
    }
    return result;
}

bool boxesMeet(const Boxed& a, const Boxed& b) {
    for (int axis = 0; axis < 3; ++axis)
        if (a.high[axis] < b.low[axis] || b.high[axis] < a.low[axis]) return false;
    return true;
}

/// The axis along which the boxes are spread farthest.
int longestAxis(const std::vector<Boxed>& boxes) {
    std::array<double, 3> extent{};
    for (int axis = 0; axis < 3; ++axis) {
        const auto [least, most] = std::ranges::minmax_element(boxes, {}, [&](const Boxed& b) { return b.low[axis]; });
        extent[axis] = static_cast<double>(most->low[axis]) - static_cast<double>(least->low[axis]);
    }
    return static_cast<int>(std::ranges::max_element(extent) - extent.begin());
}

/// Calls visit(a, b) once for each pair of boxes that meet, a from the first list and b from the second: both are
/// walked in the order of their low ends, each box meeting those of the other list that begin while it lasts.
template <class Visit>
void forBoxPairs(std::vector<Boxed>& as, std::vector<Boxed>& bs, const Visit& visit) {
    if (as.empty() || bs.empty()) return;
    const int axis = longestAxis(as);
    const auto low = [axis](const Boxed& b) { return b.low[axis]; };
    std::ranges::sort(as, {}, low);
    std::ranges::sort(bs, {}, low);
    std::size_t a = 0, b = 0;
    while (a < as.size() && b < bs.size()) {
        if (low(as[a]) <= low(bs[b])) {
            for (std::size_t k = b; k < bs.size() && low(bs[k]) <= as[a].high[axis]; ++k)
                if (boxesMeet(as[a], bs[k])) visit(as[a], bs[k]);
            ++a;
        } else {
            for (std::size_t k = a; k < as.size() && low(as[k]) <= bs[b].high[axis]; ++k)
                if (boxesMeet(as[k], bs[b])) visit(as[k], bs[b]);
            ++b;
        }
    }
}

bool shareACorner(const Boxed& a, const Boxed& b) {
    return std::ranges::any_of(a.corners, [&](const exact::Point& p) { return std::ranges::count(b.corners, p) > 0; });
}

} // namespace

std::vector<std::pair<int, int>> intersectingTriangles(const geometry::TriangleMesh& a,
                                                       const geometry::TriangleMesh& b) {
    const double step = gridStep(a, b);
    auto as = boxedTriangles(a, step), bs = boxedTriangles(b, step);
    std::vector<std::pair<int, int>> pairs;
    forBoxPairs(as, bs, [&](const Boxed& s, const Boxed& t) {
        if (exact::trianglesMeet(s.corners, t.corners)) pairs.emplace_back(s.index, t.index);
    });
    std::ranges::sort(pairs);
    return pairs;
}

std::vector<std::pair<int, int>> selfIntersectingTriangles(const geometry::TriangleMesh& mesh) {
    auto boxes = boxedTriangles(mesh, gridStep(mesh, mesh));
    std::vector<std::pair<int, int>> pairs;
    if (boxes.empty()) return pairs;
    const int axis = longestAxis(boxes);
    std::ranges::sort(boxes, {}, [axis](const Boxed& b) { return b.low[axis]; });
    for (std::size_t i = 0; i < boxes.size(); ++i)
        for (std::size_t j = i + 1; j < boxes.size() && boxes[j].low[axis] <= boxes[i].high[axis]; ++j)
            if (boxesMeet(boxes[i], boxes[j]) && !shareACorner(boxes[i], boxes[j]) &&
                exact::trianglesMeet(boxes[i].corners, boxes[j].corners))
                pairs.push_back(std::minmax(boxes[i].index, boxes[j].index));
    std::ranges::sort(pairs);
    return pairs;
}

} // namespace toile::collision
