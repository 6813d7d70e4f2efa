// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/PieceBoxes.h"

#include "bench/FclBox.h"
#include "bench/NearestWays.h"

#include <algorithm>

namespace toile::bench {
namespace {

/// What the broad phase knows by its box.
struct Thing {
    explicit Thing(std::size_t i) : index(i) { object.setUserData(this); }
    void fit(geometry::Box3 box, double reach) {
        const Vec3 wider{reach, reach, reach};
        shape->fit({box.low - wider, box.high + wider});
        object.computeAABB();
    }
    std::size_t index;
    std::shared_ptr<FclBox> shape = std::make_shared<FclBox>();
    fcl::CollisionObjectd object{shape};
};

/// The boxes of points that belong to things.
class Boxes {
public:
    explicit Boxes(std::size_t count) {
        for (std::size_t i = 0; i < count; ++i) things_.push_back(std::make_unique<Thing>(i));
    }
    void fit(std::span<const Vec3> points, std::span<const int> thingOf, double reach) {
        boxes_.assign(things_.size(), {{1e9, 1e9, 1e9}, {-1e9, -1e9, -1e9}});
        for (std::size_t i = 0; i < points.size(); ++i) {
            auto& [low, high] = boxes_[thingOf[i]];
            for (int axis = 0; axis < 3; ++axis) {
                low[axis] = std::min(low[axis], points[i][axis]);
                high[axis] = std::max(high[axis], points[i][axis]);
            }
        }
        for (std::size_t i = 0; i < things_.size(); ++i) things_[i]->fit(boxes_[i], reach);
        if (tree.empty()) {
            for (const auto& thing : things_) tree.registerObject(&thing->object);
            tree.setup();
        } else tree.update();
    }

    fcl::DynamicAABBTreeCollisionManagerd tree;

private:
    std::vector<std::unique_ptr<Thing>> things_;
    std::vector<geometry::Box3> boxes_;
};

std::size_t kindsIn(std::span<const int> of) {
    return static_cast<std::size_t>(std::ranges::max(of) + 1);
}

} // namespace

struct PieceBoxes::Trees {
    std::vector<int> pieceOf;
    Boxes limbs, pieces;
    std::vector<int> particles; ///< of each piece
};

PieceBoxes::PieceBoxes(const body::Body& body, std::span<const int> pieceOf) {
    const std::vector<int> limbOf = limbOfTriangles(body);
    trees_.reset(new Trees{{pieceOf.begin(), pieceOf.end()},
                           Boxes(kindsIn(limbOf)),
                           Boxes(kindsIn(pieceOf)),
                           std::vector<int>(kindsIn(pieceOf))});
    for (const int piece : pieceOf) ++trees_->particles[piece];
    std::vector<Vec3> corners;
    std::vector<int> limbOfCorner;
    for (std::size_t t = 0; t < limbOf.size(); ++t)
        for (const int v : body.mesh.triangles[t]) {
            corners.push_back(body.mesh.vertices[v]);
            limbOfCorner.push_back(limbOf[t]);
        }
    trees_->limbs.fit(corners, limbOfCorner, 0);
}

PieceBoxes::~PieceBoxes() = default;

int PieceBoxes::farParticles(std::span<const Vec3> positions, double reach) {
    trees_->pieces.fit(positions, trees_->pieceOf, reach);
    std::vector<char> near(trees_->particles.size(), 0);
    trees_->pieces.tree.collide(&trees_->limbs.tree, &near,
                                [](fcl::CollisionObjectd* piece, fcl::CollisionObjectd*, void* data) {
                                    const auto* thing = static_cast<const Thing*>(piece->getUserData());
                                    (*static_cast<std::vector<char>*>(data))[thing->index] = 1;
                                    return false;
                                });
    int far = 0;
    for (std::size_t piece = 0; piece < near.size(); ++piece)
        if (!near[piece]) far += trees_->particles[piece];
    return far;
}

} // namespace toile::bench
