// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/NearestWays.h"

#include "bench/FclBox.h"
#include "bench/SparseGrid.h"
#include "core/collision/NearestTree.h"
#include "core/collision/SmoothDistance.h"
#include "core/collision/SurfaceNormals.h"

#include <algorithm>
#include <cstdlib>
#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/narrowphase/distance.h>
#include <limits>

namespace toile::bench {
namespace {

using geometry::TriangleMesh;

collision::BodySurface surfaceOf(const TriangleMesh& mesh) {
    auto surface = collision::BodySurface::create(mesh);
    if (!surface) std::abort();
    return std::move(*surface);
}

struct Product final : NearestWay {
    explicit Product(const TriangleMesh& mesh) : surface(surfaceOf(mesh)) {}
    std::optional<Nearest> nearest(const Vec3& p, double radius) override {
        const auto found = surface.nearest(p, radius);
        return found ? std::optional(Nearest{found->signedDistance, found->normal}) : std::nullopt;
    }
    void moveTo(std::span<const Vec3> vertices) override { surface.moveTo(vertices); }
    std::size_t bytes() const override { return surface.bytes(); }

    collision::BodySurface surface;
};

/// The smooth distance of statics, as it is filled when it is asked.
struct Smooth final : NearestWay {
    explicit Smooth(const TriangleMesh& mesh) : surface(surfaceOf(mesh)) { distance.emplace(surface, spacing); }
    std::optional<Nearest> nearest(const Vec3& p, double) override {
        collision::SmoothDistance::Patch patch;
        const auto found = distance->at(p, patch);
        return Nearest{found.value, normalized(found.gradient)};
    }
    void moveTo(std::span<const Vec3> vertices) override {
        surface.moveTo(vertices);
        distance.emplace(surface, spacing);
    }
    std::size_t bytes() const override { return distance->bytes(); }

    static constexpr double spacing = 0.0025; // [m]
    collision::BodySurface surface;
    std::optional<collision::SmoothDistance> distance;
};

/// What ways share that find a triangle: the body's normals tell the sign.
class TriangleWay : public NearestWay {
public:
    explicit TriangleWay(const TriangleMesh& mesh) : mesh_(mesh), normals_(mesh) {}
    void moveTo(std::span<const Vec3> vertices) override {
        std::ranges::copy(vertices, mesh_.vertices.begin());
        if (!moved_) moved_.emplace(mesh_);
    }
    std::size_t bytes() const override {
        return normals_.bytes() + mesh_.vertices.size() * sizeof(Vec3) +
               mesh_.triangles.size() * sizeof(mesh_.triangles[0]);
    }

protected:
    [[nodiscard]] std::optional<Nearest> answer(const Vec3& p, int triangle) const {
        if (triangle < 0) return std::nullopt;
        const auto& [a, b, c] = mesh_.triangles[triangle];
        const auto at = collision::closestOnTriangle(p, mesh_.vertices[a], mesh_.vertices[b], mesh_.vertices[c]);
        const Vec3 normal = moved_ ? moved_->at(mesh_.vertices, triangle, at.part) : normals_.at(triangle, at.part);
        const Vec3 away = p - at.point;
        const double gap = length(away), sign = dot(away, normal) < 0 ? -1 : 1;
        return Nearest{sign * gap, at.part == collision::TrianglePart::inside ? normal : away * (sign / gap)};
    }

    TriangleMesh mesh_;
    collision::SurfaceNormals normals_;

private:
    std::optional<collision::NormalsOnDemand> moved_;
};

struct BruteForce final : TriangleWay {
    using TriangleWay::TriangleWay;
    std::optional<Nearest> nearest(const Vec3& p, double radius) override {
        double best = radius * radius;
        int nearest = -1;
        for (int t = 0; t < std::ssize(mesh_.triangles); ++t) {
            const auto& [a, b, c] = mesh_.triangles[t];
            const double squared = squaredLength(
                p - collision::closestOnTriangle(p, mesh_.vertices[a], mesh_.vertices[b], mesh_.vertices[c]).point);
            if (squared < best) best = squared, nearest = t;
        }
        return answer(p, nearest);
    }
};

using FclModel = fcl::BVHModel<fcl::OBBRSS<double>>;

std::vector<fcl::Vector3d> toFcl(std::span<const Vec3> points) {
    std::vector<fcl::Vector3d> made;
    for (const Vec3& p : points) made.emplace_back(p.x, p.y, p.z);
    return made;
}

std::shared_ptr<FclModel> fclModelOf(const TriangleMesh& mesh) {
    auto model = std::make_shared<FclModel>();
    std::vector<fcl::Triangle> triangles;
    for (const auto& [a, b, c] : mesh.triangles) triangles.emplace_back(a, b, c);
    model->beginModel(static_cast<int>(triangles.size()), static_cast<int>(mesh.vertices.size()));
    if (model->addSubModel(toFcl(mesh.vertices), triangles) != fcl::BVH_OK || model->endModel() != fcl::BVH_OK)
        std::abort();
    return model;
}

void refit(FclModel& model, std::span<const Vec3> vertices) {
    model.beginReplaceModel();
    if (model.replaceSubModel(toFcl(vertices)) != fcl::BVH_OK || model.endReplaceModel() != fcl::BVH_OK) std::abort();
}

std::size_t bytesOf(const FclModel& model) {
    return static_cast<std::size_t>(model.getNumBVs()) * sizeof(fcl::BVNode<fcl::OBBRSS<double>>) +
           static_cast<std::size_t>(model.num_vertices) * sizeof(fcl::Vector3d) +
           static_cast<std::size_t>(model.num_tris) * sizeof(fcl::Triangle);
}

/// The triangle nearest to a ball too small to count, if it is nearer than `result` knows already.
void ask(const FclModel& model, const Vec3& p, fcl::DistanceResultd& result) {
    static const fcl::Sphered point(1e-9);
    const fcl::Transform3d here(fcl::Translation3d(p.x, p.y, p.z));
    fcl::distance(&model, fcl::Transform3d::Identity(), &point, here, fcl::DistanceRequestd(), result);
}

struct FclDistance final : TriangleWay {
    explicit FclDistance(const TriangleMesh& mesh) : TriangleWay(mesh), model(fclModelOf(mesh)) {}
    std::optional<Nearest> nearest(const Vec3& p, double radius) override {
        fcl::DistanceResultd result(radius);
        ask(*model, p, result);
        return answer(p, static_cast<int>(result.b1));
    }
    void moveTo(std::span<const Vec3> vertices) override {
        TriangleWay::moveTo(vertices);
        refit(*model, vertices);
    }
    std::size_t bytes() const override { return TriangleWay::bytes() + bytesOf(*model); }

    std::shared_ptr<FclModel> model;
};

/// The triangles of one limb, and which they are of the body.
struct Part {
    TriangleMesh mesh;
    std::vector<int> vertices, triangles;
};

std::vector<Part> partsOf(const body::Body& body) {
    const std::vector<int> limbs = limbOfTriangles(body);
    std::vector<Part> parts(static_cast<std::size_t>(std::ranges::max(limbs) + 1));
    std::vector<std::vector<int>> known(parts.size(), std::vector<int>(body.mesh.vertices.size(), -1));
    for (std::size_t t = 0; t < limbs.size(); ++t) {
        const auto limb = static_cast<std::size_t>(limbs[t]);
        geometry::TriangleIndices corners{};
        for (std::size_t k = 0; k < 3; ++k) {
            const int v = body.mesh.triangles[t][k];
            if (known[limb][v] < 0) {
                known[limb][v] = static_cast<int>(parts[limb].vertices.size());
                parts[limb].vertices.push_back(v);
                parts[limb].mesh.vertices.push_back(body.mesh.vertices[v]);
            }
            corners[k] = known[limb][v];
        }
        parts[limb].mesh.triangles.push_back(corners);
        parts[limb].triangles.push_back(static_cast<int>(t));
    }
    std::erase_if(parts, [](const Part& part) { return part.triangles.empty(); });
    return parts;
}

/// FCL's dynamic tree over limbs, in front of a narrow phase for each: FCL's own or the product's hierarchy.
template <class Narrow>
class Parts final : public TriangleWay {
public:
    explicit Parts(const body::Body& body) : TriangleWay(body.mesh) {
        for (Part& part : partsOf(body)) {
            limbs_.push_back(std::make_unique<Limb>(std::move(part)));
            tree_.registerObject(&limbs_.back()->object);
        }
        tree_.setup();
    }
    std::optional<Nearest> nearest(const Vec3& p, double radius) override {
        Search search{p, radius};
        ball_->around(p, radius);
        object_.computeAABB();
        tree_.collide(&object_, &search, [](fcl::CollisionObjectd* a, fcl::CollisionObjectd* b, void* data) {
            const auto* limb = static_cast<Limb*>(a->getUserData() ? a->getUserData() : b->getUserData());
            auto& asked = *static_cast<Search*>(data);
            if (const int found = limb->narrow.nearest(asked.point, asked.radius); found >= 0)
                asked.triangle = limb->part.triangles[found];
            return false;
        });
        return answer(p, search.triangle);
    }
    void moveTo(std::span<const Vec3> vertices) override {
        TriangleWay::moveTo(vertices);
        for (const auto& limb : limbs_) {
            for (std::size_t v = 0; v < limb->part.vertices.size(); ++v)
                limb->part.mesh.vertices[v] = vertices[limb->part.vertices[v]];
            limb->narrow.moveTo(limb->part.mesh);
            limb->object.computeAABB();
        }
        tree_.update();
    }
    std::size_t bytes() const override {
        std::size_t sum = TriangleWay::bytes();
        for (const auto& limb : limbs_) sum += limb->narrow.bytes();
        return sum;
    }

private:
    struct Limb {
        explicit Limb(Part given) : part(std::move(given)), narrow(part.mesh), object(narrow.geometry()) {
            object.setUserData(this);
        }
        Part part;
        Narrow narrow;
        fcl::CollisionObjectd object;
    };
    struct Search {
        Vec3 point;
        double radius; ///< of the best so far [m]
        int triangle = -1;
    };

    std::vector<std::unique_ptr<Limb>> limbs_;
    fcl::DynamicAABBTreeCollisionManagerd tree_;
    std::shared_ptr<FclBox> ball_ = std::make_shared<FclBox>();
    fcl::CollisionObjectd object_{ball_};
};

struct FclNarrow {
    explicit FclNarrow(const TriangleMesh& mesh) : model(fclModelOf(mesh)) {}
    [[nodiscard]] std::shared_ptr<fcl::CollisionGeometryd> geometry() const { return model; }
    int nearest(const Vec3& p, double& radius) const {
        fcl::DistanceResultd result(radius);
        ask(*model, p, result);
        radius = result.min_distance;
        return static_cast<int>(result.b1);
    }
    void moveTo(const TriangleMesh& mesh) const {
        refit(*model, mesh.vertices);
        model->computeLocalAABB();
    }
    [[nodiscard]] std::size_t bytes() const { return bytesOf(*model); }

    std::shared_ptr<FclModel> model;
};

struct TreeNarrow {
    explicit TreeNarrow(const TriangleMesh& mesh) : tree(mesh, collision::SurfaceNormals(mesh)) {
        box->fit(geometry::boundsOf(mesh.vertices));
    }
    [[nodiscard]] std::shared_ptr<fcl::CollisionGeometryd> geometry() const { return box; }
    int nearest(const Vec3& p, double& radius) const {
        const auto found = tree.nearest(p, radius);
        if (found.triangle >= 0) radius = length(p - found.nearest.point);
        return found.triangle;
    }
    void moveTo(const TriangleMesh& mesh) {
        tree.moveTo(mesh);
        box->fit(geometry::boundsOf(mesh.vertices));
    }
    [[nodiscard]] std::size_t bytes() const { return tree.bytes(); }

    collision::NearestTree tree;
    std::shared_ptr<FclBox> box = std::make_shared<FclBox>();
};

std::function<std::unique_ptr<NearestWay>(const body::Body&)> gridOf(double spacing) {
    return [spacing](const body::Body& body) {
        return std::make_unique<SparseGrid>(surfaceOf(body.mesh), spacing, gridBand);
    };
}

template <class Way>
std::unique_ptr<NearestWay> wayOf(const body::Body& body) {
    return std::make_unique<Way>(body.mesh);
}

double squaredDistance(const Vec3& p, const std::vector<Vec3>& line) {
    double best = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        const Vec3 along = line[i + 1] - line[i];
        const double t = std::clamp(dot(p - line[i], along) / squaredLength(along), 0.0, 1.0);
        best = std::min(best, squaredLength(p - line[i] - along * t));
    }
    return best;
}

} // namespace

std::unique_ptr<NearestWay> bruteForce(const body::Body& body) {
    return wayOf<BruteForce>(body);
}

std::vector<NamedWay> nearestWays() {
    return {{"`BodySurface`", wayOf<Product>},
            {"`fcl::distance`, OBBRSS", wayOf<FclDistance>},
            {"FCL's dynamic tree over limbs, `fcl::distance`",
             [](const body::Body& body) { return std::make_unique<Parts<FclNarrow>>(body); }},
            {"FCL's dynamic tree over limbs, `NearestTree`",
             [](const body::Body& body) { return std::make_unique<Parts<TreeNarrow>>(body); }},
            {"`SmoothDistance`, 2.5 mm, filled where it is asked", wayOf<Smooth>},
            {"sparse grid, 5 mm", gridOf(0.005)},
            {"sparse grid, 2.5 mm", gridOf(0.0025)}};
}

std::vector<int> limbOfTriangles(const body::Body& body) {
    std::vector<int> limbs(body.mesh.triangles.size(), 0);
    for (std::size_t t = 0; t < limbs.size() && !body.axes.empty(); ++t) {
        const auto& [a, b, c] = body.mesh.triangles[t];
        const Vec3 middle = (body.mesh.vertices[a] + body.mesh.vertices[b] + body.mesh.vertices[c]) / 3;
        const auto nearest = std::ranges::min_element(
            body.axes, {}, [&](const body::LimbAxis& axis) { return squaredDistance(middle, axis.points); });
        limbs[t] = static_cast<int>(nearest - body.axes.begin());
    }
    return limbs;
}

} // namespace toile::bench
