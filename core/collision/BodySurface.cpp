// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/collision/BodySurface.h"

#include "core/base/Contracts.h"
#include "core/collision/Bumps.h"
#include "core/collision/NearestTree.h"
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
    NearestTree nearest;
    std::vector<int> bumps;               ///< vertices
    std::optional<NormalsOnDemand> moved; ///< instead of the normals, once it has moved

    explicit Tree(geometry::TriangleMesh given)
        : mesh(std::move(given)), normals(mesh), nearest(mesh, normals), bumps(bumpsOf(mesh, sharp)) {}
};

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
std::vector<Vec3> BodySurface::bumps() const {
    std::vector<Vec3> places;
    for (const int v : tree_->bumps) places.push_back(tree_->mesh.vertices[v]);
    return places;
}
bool BodySurface::isClosed() const {
    return tree_->normals.isClosed();
}

std::size_t BodySurface::bytes() const {
    const auto& [vertices, triangles] = tree_->mesh;
    return sizeof(Tree) + vertices.capacity() * sizeof(vertices[0]) + triangles.capacity() * sizeof(triangles[0]) +
           tree_->nearest.bytes() + tree_->normals.bytes() + (tree_->moved ? tree_->moved->bytes() : 0);
}

void BodySurface::moveTo(std::span<const Vec3> vertices) {
    expects(vertices.size() == tree_->mesh.vertices.size(), "one place for each vertex");
    if (!tree_->moved) tree_->moved.emplace(tree_->mesh);
    std::ranges::copy(vertices, tree_->mesh.vertices.begin());
    tree_->nearest.moveTo(tree_->mesh);
}

bool BodySurface::hasMoved() const {
    return tree_->moved.has_value();
}

std::optional<SurfacePoint> BodySurface::nearest(const Vec3& point, double searchRadius) const {
    const auto found = tree_->nearest.nearest(point, searchRadius);
    if (found.triangle < 0) return std::nullopt;

    const Vec3 away = point - found.nearest.point;
    const double gap = length(away);
    const Vec3 outward = tree_->moved ? tree_->moved->at(tree_->mesh.vertices, found.triangle, found.nearest.part)
                                      : tree_->normals.at(found.triangle, found.nearest.part);
    const double sign = dot(away, outward) < 0 ? -1 : 1;
    const bool steady = found.nearest.part == TrianglePart::inside || gap < onSurface;
    const Vec3 direction = gap > 0 ? away * (sign / gap) : Vec3{0, 1, 0};
    return SurfacePoint{sign * gap, found.nearest.point, steady && outward != Vec3{} ? outward : direction,
                        found.triangle};
}

} // namespace toile::collision
