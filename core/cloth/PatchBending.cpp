// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cloth/PatchBending.h"

#include "core/base/Contracts.h"
#include "core/cloth/NodeChains.h"
#include "core/cloth/PatchEdges.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

namespace toile::cloth {
namespace {

/// Σ coefficient·x over nodes of a patch, which rise.
class Combination {
public:
    Combination() {} // terms are set as they come: millions of these are made
    Combination(int node) { add(node, 1); }

    void add(int node, double coefficient) {
        if (coefficient == 0) return;
        std::size_t place = 0;
        while (place < count_ && terms_[place].node < node) ++place;
        if (place < count_ && terms_[place].node == node) {
            terms_[place].coefficient += coefficient;
            return;
        }
        expects(count_ < terms_.size(), "a combination has few places");
        for (std::size_t i = count_++; i > place; --i) terms_[i] = terms_[i - 1];
        terms_[place] = {node, coefficient};
    }
    void add(const Combination& other, double factor) {
        for (const auto& [node, coefficient] : other.terms()) add(node, factor * coefficient);
    }

    struct Term {
        int node;
        double coefficient;
    };
    [[nodiscard]] std::span<const Term> terms() const { return {terms_.data(), count_}; }

private:
    std::array<Term, 6> terms_; ///< a node and a blend of two on either side are five
    std::size_t count_ = 0;
};

/// Collects stencils of nodes at the end of a list; equal ones become one.
class StencilCollector {
public:
    StencilCollector(std::vector<Stencil>& stencils, std::size_t nodes, std::size_t expected)
        : stencils_(stencils), first_(stencils.size()), byNode_(nodes, expected) {
        stencils.reserve(first_ + expected);
    }

    void add(const Combination& combination, double stiffness) {
        if (stiffness <= 0 || combination.terms().empty()) return;
        expects(combination.terms().size() <= 4, "a stencil has at most four places");
        Stencil stencil{.stiffness = stiffness};
        int used = 0;
        for (const auto& [node, coefficient] : combination.terms()) {
            stencil.particles[used] = node; // until finish()
            stencil.coefficients[used++] = coefficient;
        }
        const int known =
            byNode_.find(stencil.particles[0], [&](int entry) { return isAlike(stencils_[first_ + entry], stencil); });
        if (known >= 0) {
            stencils_[first_ + known].stiffness += stiffness;
            return;
        }
        stencils_.push_back(stencil);
        byNode_.add(stencil.particles[0]);
    }

    /// Nodes become particles; what has only one of them is no stencil.
    void finish(std::span<const int> particles) {
        auto kept = stencils_.begin() + static_cast<std::ptrdiff_t>(first_);
        for (auto collected = kept; collected != stencils_.end(); ++collected) {
            Stencil stencil{.stiffness = collected->stiffness};
            int used = 0;
            for (int i = 0; i < 4 && collected->particles[i] >= 0; ++i) {
                const int particle = particles[collected->particles[i]];
                const auto end = stencil.particles.begin() + used;
                const auto it = std::find(stencil.particles.begin(), end, particle);
                if (it == end) stencil.particles[used++] = particle;
                stencil.coefficients[it - stencil.particles.begin()] += collected->coefficients[i];
            }
            if (used > 1) *kept++ = stencil;
        }
        stencils_.erase(kept, stencils_.end());
    }

private:
    static bool isAlike(const Stencil& a, const Stencil& b) {
        for (int i = 0; i < 4; ++i)
            if (a.particles[i] != b.particles[i]) return false;
        for (int i = 0; i < 4; ++i)
            if (std::abs(a.coefficients[i] - b.coefficients[i]) > 1e-9 * std::abs(b.coefficients[i])) return false;
        return true;
    }

    std::vector<Stencil>& stencils_;
    std::size_t first_;
    NodeChains byNode_; ///< the smallest of them
};

/// hypot, which most often is asked for one coordinate alone.
double lengthOf(Vec2 way) {
    if (way.x == 0) return std::abs(way.y);
    return way.y == 0 ? std::abs(way.x) : geometry::length(way);
}

class BendingBuilder {
public:
    BendingBuilder(ClothModel& model, const Patch& patch, const material::Fabric& fabric)
        : patch_(patch), fabric_(fabric),
          stencils_(model.bending, patch.material.size(), 2 * patch.rectangles.size() + 6 * patch.triangles.size()) {}

    void append() {
        for (const PatchEdge& edge : edgesOf(patch_)) {
            if (!edge.isInner() || isCrease(edge)) continue;
            if (edge.first.rectangle && edge.second.rectangle) addRow(edge);
            else addHinge(edge);
        }
        stencils_.finish(patch_.particles);
    }

private:
    [[nodiscard]] bool isCrease(const PatchEdge& edge) const {
        return !patch_.creases.empty() &&
               std::ranges::binary_search(patch_.creases, std::pair<int, int>(std::minmax(edge.a, edge.b)));
    }

    /// Curvature across an edge between two rectangles, at both of its ends, each for half the edge's width.
    void addRow(const PatchEdge& edge) {
        const Vec2 along = patch_.material[edge.b] - patch_.material[edge.a];
        const double width = 0.5 * lengthOf(along);
        const double l1 = extentAcross(edge.first), l2 = extentAcross(edge.second), both = l1 + l2;
        const double stiffness = stiffnessAcross(edge) * width * both / 2;
        const auto addAt = [&](int node, double tFirst, double tSecond) {
            Combination curvature;
            curvature.add(node, -2 / both * (1 / l1 + 1 / l2));
            curvature.add(beyond(edge.first, tFirst), 2 / (both * l1));
            curvature.add(beyond(edge.second, tSecond), 2 / (both * l2));
            stencils_.add(curvature, stiffness);
        };
        addAt(edge.a, edge.first.from, edge.second.to);
        addAt(edge.b, edge.first.to, edge.second.from);
    }

    /// Flat hinge of two triangles. A rectangle takes part as two triangles of half the weight, to each of its two
    /// corners beyond the edge.
    void addHinge(const PatchEdge& edge) {
        const double stiffness = stiffnessAcross(edge);
        const auto cs = cornersBeyond(edge.first), ds = cornersBeyond(edge.second);
        const double share = 1.0 / static_cast<double>(cs.size() * ds.size());
        for (int c : cs)
            for (int d : ds) addHinge(edge.a, edge.b, c, d, share * stiffness);
    }

    void addHinge(int a, int b, int c, int d, double bending) {
        const auto& at = patch_.material;
        const auto cotangent = [&](int apex, int p, int q) {
            const Vec2 u = at[p] - at[apex], v = at[q] - at[apex];
            return dot(u, v) / std::abs(cross(u, v));
        };
        const auto doubleArea = [&](int p, int q, int r) { return std::abs(cross(at[q] - at[p], at[r] - at[p])); };
        const double areas = 0.5 * (doubleArea(a, b, c) + doubleArea(a, b, d));
        const double a1 = cotangent(a, b, c), b1 = cotangent(b, a, c), a2 = cotangent(a, b, d), b2 = cotangent(b, a, d);
        Combination fold; // |Σ c·x| = edge length · fold angle
        fold.add(a, b1 + b2);
        fold.add(b, a1 + a2);
        fold.add(c, -a1 - b1);
        fold.add(d, -a2 - b2);
        stencils_.add(fold, bending / areas);
    }

    /// B of the fabric for a fold along the edge, with the mean factor of both cells [N·m].
    [[nodiscard]] double stiffnessAcross(const PatchEdge& edge) const {
        const Vec2 along = patch_.material[edge.b] - patch_.material[edge.a];
        const double factor = 0.5 * (factorOf(edge.first) + factorOf(edge.second));
        return factor * (along.y == 0 ? acrossWarp_ : along.x == 0 ? acrossWeft_ : stiffnessAcross(along));
    }
    [[nodiscard]] double stiffnessAcross(Vec2 along) const {
        const double fromWarp = std::atan2(std::abs(along.y), std::abs(along.x)); // of the fold's normal
        return std::max(0.0, material::bendingStiffness(fabric_, fromWarp));
    }
    [[nodiscard]] double factorOf(const EdgeSide& side) const {
        return side.rectangle ? patch_.rectangles[side.cell].factors.bending
                              : patch_.triangles[side.cell].factors.bending;
    }
    [[nodiscard]] double extentAcross(const EdgeSide& side) const {
        const auto& nodes = patch_.rectangles[side.cell].nodes;
        return lengthOf(patch_.material[nodes[(side.side + 2) % 4]] - patch_.material[nodes[(side.side + 1) % 4]]);
    }
    /// The point of the rectangle's other side that lies across from a point of this side.
    [[nodiscard]] Combination beyond(const EdgeSide& side, double t) const {
        const auto& nodes = patch_.rectangles[side.cell].nodes;
        Combination point;
        point.add(nodes[(side.side + 3) % 4], 1 - t);
        point.add(nodes[(side.side + 2) % 4], t);
        return point;
    }
    [[nodiscard]] std::vector<int> cornersBeyond(const EdgeSide& side) const {
        if (!side.rectangle) return {patch_.triangles[side.cell].nodes[(side.side + 2) % 3]};
        const auto& nodes = patch_.rectangles[side.cell].nodes;
        return {nodes[(side.side + 2) % 4], nodes[(side.side + 3) % 4]};
    }

    const Patch& patch_;
    const material::Fabric& fabric_;
    StencilCollector stencils_;
    double acrossWarp_ = stiffnessAcross(Vec2{1, 0}),
           acrossWeft_ = stiffnessAcross(Vec2{0, 1}); ///< of edges along the grain
};

/// ½·k·|x₀₀ − x₁₀ − x₀₁ + x₁₁|², k = (4·B45 − B1 − B2)/(a·b).
bool appendTwist(ClothModel& model, const Patch& patch, const material::Fabric& fabric) {
    const double constant = 4 * fabric.biasBending - fabric.warpBending - fabric.weftBending;
    if (constant <= 0) return constant < 0;
    StencilCollector stencils(model.twist, patch.material.size(), patch.rectangles.size());
    for (const PatchRectangle& cell : patch.rectangles) {
        const Vec2 sides = patch.material[cell.nodes[2]] - patch.material[cell.nodes[0]];
        Combination twist;
        for (int corner = 0; corner < 4; ++corner) twist.add(cell.nodes[corner], corner % 2 == 0 ? 1 : -1);
        stencils.add(twist, cell.factors.bending * constant / (sides.x * sides.y));
    }
    stencils.finish(patch.particles);
    return false;
}

} // namespace

bool appendBending(ClothModel& model, const Patch& patch, const material::Fabric& fabric) {
    const bool limp = fabric.warpBending == 0 && fabric.weftBending == 0 && fabric.biasBending == 0;
    if (limp) return false;
    BendingBuilder(model, patch, fabric).append();
    return appendTwist(model, patch, fabric);
}

Hinge seamHinge(const SeamEdge& edge) {
    expects(edge.length > 0 && edge.heightC > 0 && edge.heightD > 0, "a seam edge and its cells have an extent");
    const double areas = 0.5 * edge.length * (edge.heightC + edge.heightD);
    return {edge.particles[0], edge.particles[1], edge.particles[2],
            edge.particles[3], edge.restAngle,    edge.bending * edge.length * edge.length / areas};
}

void doubleBendingAtClampedRows(ClothModel& model) {
    if (model.pinned.empty()) return;
    std::vector<char> pinned(model.mass.size(), 0);
    for (int particle : model.pinned) pinned[particle] = 1;
    for (Stencil& stencil : model.bending) {
        const auto used = std::ranges::count_if(stencil.particles, [](int p) { return p >= 0; });
        if (used != 3) continue;
        int centre = 0;
        for (int i = 1; i < 3; ++i)
            if (std::abs(stencil.coefficients[i]) > std::abs(stencil.coefficients[centre])) centre = i;
        const int pins = pinned[stencil.particles[0]] + pinned[stencil.particles[1]] + pinned[stencil.particles[2]];
        if (pinned[stencil.particles[centre]] && pins == 2) stencil.stiffness *= 2;
    }
}

} // namespace toile::cloth
