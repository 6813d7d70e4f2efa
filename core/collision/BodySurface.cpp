// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/collision/BodySurface.h"

#include "core/base/Contracts.h"
#include "core/collision/BoxTree.h"
#include "core/collision/Bumps.h"
#include "core/collision/ClosestPoint.h"
#include "core/collision/SurfaceNormals.h"

#include <algorithm>

namespace toile::collision {
namespace {

/// Nearer than this to the surface [m] the direction from the surface to the point is rounding; the normal of the
/// surface stands for it.
constexpr double onSurface = 1e-9;
/// A cell of 20 mm dips by 20²/(8·25) = 2 mm into a ball of this radius [m], which the skin offset allows.
constexpr double sharp = 0.025;

Result<void> check(const geometry::TriangleMesh& mesh) {
    if (mesh.triangles.empty()) return fail(ErrorCode::invalidInput, "The body has no triangles.");
    if (!std::ranges::all_of(mesh.vertices, [](const Vec3& v) { return isFinite(v); }))
        return fail(ErrorCode::invalidInput, "A coordinate of the body is not a finite number.");
    for (const auto& triangle : mesh.triangles)
        for (const int corner : triangle)
            if (corner < 0 || corner >= static_cast<int>(mesh.vertices.size()))
                return fail(ErrorCode::invalidInput, "A triangle of the body names a vertex that does not exist.");
    return {};
}

} // namespace

struct BodySurface::Tree {
    geometry::TriangleMesh mesh;
    SurfaceNormals normals;
    std::vector<BoxNode> boxes;
    std::vector<Vec3> bumps;

    explicit Tree(geometry::TriangleMesh given)
        : mesh(std::move(given)), normals(mesh), boxes(boxTreeOf(mesh)), bumps(bumpsOf(mesh, sharp)) {}

    [[nodiscard]] TrianglePoint closest(int triangle, const Vec3& p) const {
        const auto& [a, b, c] = mesh.triangles[triangle];
        const Vec3 &A = mesh.vertices[a], &B = mesh.vertices[b], &C = mesh.vertices[c];
        return normals.isSliver(triangle) ? closestOnSliver(p, A, B, C) : closestOnTriangle(p, A, B, C);
    }
};

namespace {

/// Depth first, the nearer box first; boxes farther than the best triangle so far are left out.
template <class Closest>
struct NearestSearch {
    const std::vector<BoxNode>& boxes;
    const Vec3& point;
    const Closest& closest; ///< (triangle) ↦ TrianglePoint
    double bestSquared;     ///< [m²]
    int triangle = -1;
    TrianglePoint best{};

    void visit(int index) {
        const BoxNode& node = boxes[index];
        if (node.triangle >= 0) {
            const TrianglePoint candidate = closest(node.triangle);
            const double squared = squaredLength(point - candidate.point);
            if (squared > bestSquared || (squared == bestSquared && triangle >= 0)) return;
            bestSquared = squared;
            triangle = node.triangle;
            best = candidate;
            return;
        }
        int near = node.firstChild, far = node.firstChild + 1;
        double nearSquared = squaredDistance(boxes[near], point), farSquared = squaredDistance(boxes[far], point);
        if (farSquared < nearSquared) {
            std::swap(near, far);
            std::swap(nearSquared, farSquared);
        }
        if (nearSquared <= bestSquared) visit(near);
        if (farSquared <= bestSquared) visit(far);
    }
};

} // namespace

Result<BodySurface> BodySurface::create(geometry::TriangleMesh mesh) {
    if (auto checked = check(mesh); !checked) return tl::unexpected(checked.error());
    return BodySurface(std::make_unique<Tree>(std::move(mesh)));
}

BodySurface::BodySurface(std::unique_ptr<Tree> tree) : tree_(std::move(tree)) {}
BodySurface::BodySurface(BodySurface&&) noexcept = default;
BodySurface& BodySurface::operator=(BodySurface&&) noexcept = default;
BodySurface::~BodySurface() = default;

const geometry::TriangleMesh& BodySurface::mesh() const {
    return tree_->mesh;
}
const std::vector<Vec3>& BodySurface::bumps() const {
    return tree_->bumps;
}
bool BodySurface::isClosed() const {
    return tree_->normals.isClosed();
}

std::size_t BodySurface::bytes() const {
    const auto& [vertices, triangles] = tree_->mesh;
    return sizeof(Tree) + vertices.capacity() * sizeof(vertices[0]) + triangles.capacity() * sizeof(triangles[0]) +
           tree_->boxes.capacity() * sizeof(BoxNode) + tree_->normals.bytes();
}

std::optional<SurfacePoint> BodySurface::nearest(const Vec3& point, double searchRadius) const {
    const auto closest = [&](int triangle) { return tree_->closest(triangle, point); };
    NearestSearch<decltype(closest)> search{tree_->boxes, point, closest, searchRadius * searchRadius};
    search.visit(0);
    if (search.triangle < 0) return std::nullopt;

    const Vec3 away = point - search.best.point;
    const double gap = length(away);
    const Vec3& outward = tree_->normals.at(search.triangle, search.best.part);
    const double sign = dot(away, outward) < 0 ? -1 : 1;
    const bool steady = search.best.part == TrianglePart::inside || gap < onSurface;
    const Vec3 direction = gap > 0 ? away * (sign / gap) : Vec3{0, 1, 0};
    return SurfacePoint{sign * gap, search.best.point, steady && outward != Vec3{} ? outward : direction,
                        search.triangle};
}

} // namespace toile::collision
