// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/collision/BoxTree.h"

#include "core/base/Contracts.h"

#include <fcl/geometry/bvh/BVH_model.h>

namespace toile::collision {
namespace {

using Model = fcl::BVHModel<fcl::AABB<double>>;

void load(Model& model, const geometry::TriangleMesh& mesh) {
    std::vector<fcl::Vector3<double>> points;
    points.reserve(mesh.vertices.size());
    for (const Vec3& v : mesh.vertices) points.emplace_back(v.x, v.y, v.z);
    std::vector<fcl::Triangle> triangles;
    triangles.reserve(mesh.triangles.size());
    for (const auto& [a, b, c] : mesh.triangles) triangles.emplace_back(a, b, c);

    const int counts[]{static_cast<int>(triangles.size()), static_cast<int>(points.size())};
    expects(model.beginModel(counts[0], counts[1]) == fcl::BVH_OK, "FCL begins a model");
    expects(model.addSubModel(points, triangles) == fcl::BVH_OK, "FCL takes the triangles");
    expects(model.endModel() == fcl::BVH_OK, "FCL builds the tree");
}

Vec3 fromFcl(const fcl::Vector3<double>& v) {
    return {v[0], v[1], v[2]};
}

} // namespace

std::vector<BoxNode> boxTreeOf(const geometry::TriangleMesh& mesh) {
    expects(!mesh.triangles.empty(), "a box tree needs a triangle");
    Model model;
    load(model, mesh);
    std::vector<BoxNode> nodes;
    nodes.reserve(model.getNumBVs());
    for (int i = 0; i < model.getNumBVs(); ++i) {
        const auto& node = model.getBV(i);
        nodes.push_back({fromFcl(node.bv.min_), fromFcl(node.bv.max_), node.isLeaf() ? 0 : node.leftChild(),
                         node.isLeaf() ? node.primitiveId() : -1});
    }
    return nodes;
}

} // namespace toile::collision
