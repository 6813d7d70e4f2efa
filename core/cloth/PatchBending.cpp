// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cloth/PatchBending.h"

#include "core/base/Contracts.h"
#include "core/cloth/NodeIndex.h"
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
    Combination() = default;
    Combination(int node) { add(node, 1); }

    void add(int node, double coefficient) {
        if (coefficient == 0) return;
        std::size_t place = 0;
        while (place < count_ && terms_[place].first < node) ++place;
        if (place < count_ && terms_[place].first == node) {
            terms_[place].second += coefficient;
            return;
        }
        expects(count_ < terms_.size(), "a combination has few places");
        for (std::size_t i = count_++; i > place; --i) terms_[i] = terms_[i - 1];
        terms_[place] = {node, coefficient};
    }
    void add(const Combination& other, double factor) {
        for (const auto& [node, coefficient] : other.terms()) add(node, factor * coefficient);
    }

    using Term = std::pair<int, double>;
    [[nodiscard]] std::span<const Term> terms() const { return {terms_.data(), count_}; }

private:
    std::array<Term, 6> terms_; ///< a node and a blend of two on either side are five
    std::size_t count_ = 0;
};

/// Collects stencils of nodes; equal ones become one. Written out as stencils of particles.
class StencilCollector {
public:
    explicit StencilCollector(std::size_t expected) : byNodes_(expected) { collected_.reserve(expected); }

    void add(const Combination& combination, double stiffness) {
        if (stiffness <= 0 || combination.terms().empty()) return;
        expects(combination.terms().size() <= 4, "a stencil has at most four places");
        std::array<int, 4> key{-1, -1, -1, -1};
        for (std::size_t i = 0; i < combination.terms().size(); ++i) key[i] = combination.terms()[i].first;
        const int next = static_cast<int>(collected_.size()), first = byNodes_.findOrAdd(key, next);
        if (first != next) {
            for (int index = first; index >= 0; index = collected_[index].nextOfNodes)
                if (sameCoefficients(collected_[index].combination, combination)) {
                    collected_[index].stiffness += stiffness;
                    return;
                }
            collected_.push_back({combination, stiffness, std::exchange(collected_[first].nextOfNodes, next)});
            return;
        }
        collected_.push_back({combination, stiffness, -1});
    }

    void writeTo(std::vector<Stencil>& stencils, std::span<const int> particles) const {
        for (const Collected& collected : collected_) {
            Stencil stencil{.stiffness = collected.stiffness};
            int used = 0;
            for (const auto& [node, coefficient] : collected.combination.terms()) {
                const auto end = stencil.particles.begin() + used;
                const auto it = std::find(stencil.particles.begin(), end, particles[node]);
                if (it == end) stencil.particles[used++] = particles[node];
                stencil.coefficients[it - stencil.particles.begin()] += coefficient;
            }
            if (used > 1) stencils.push_back(stencil);
        }
    }

private:
    struct Collected {
        Combination combination;
        double stiffness;
        int nextOfNodes; ///< another stencil of the same nodes; −1 = none
    };

    static bool sameCoefficients(const Combination& a, const Combination& b) {
        return std::ranges::equal(a.terms(), b.terms(), [](const auto& p, const auto& q) {
            return p.first == q.first && std::abs(p.second - q.second) <= 1e-9 * std::abs(p.second);
        });
    }

    std::vector<Collected> collected_;
    NodeIndex<4> byNodes_;
};

class BendingBuilder {
public:
    BendingBuilder(const Patch& patch, const material::Fabric& fabric)
        : patch_(patch), fabric_(fabric), stencils_(2 * patch.rectangles.size() + 6 * patch.triangles.size()) {}

    void appendTo(ClothModel& model) {
        for (const PatchEdge& edge : edgesOf(patch_)) {
            if (!edge.isInner()) continue;
            if (edge.first.rectangle && edge.second.rectangle) addRow(edge);
            else addHinge(edge);
        }
        stencils_.writeTo(model.bending, patch_.particles);
    }

private:
    /// Curvature across an edge between two rectangles, at both of its ends, each for half the edge's width.
    void addRow(const PatchEdge& edge) {
        const Vec2 along = patch_.material[edge.b] - patch_.material[edge.a];
        const double width = 0.5 * geometry::length(along);
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
        const double fromWarp = std::atan2(std::abs(along.y), std::abs(along.x)); // of the edge's normal
        const double factor = 0.5 * (factorOf(edge.first) + factorOf(edge.second));
        return factor * std::max(0.0, material::bendingStiffness(fabric_, fromWarp));
    }
    [[nodiscard]] double factorOf(const EdgeSide& side) const {
        return side.rectangle ? patch_.rectangles[side.cell].factors.bending
                              : patch_.triangles[side.cell].factors.bending;
    }
    [[nodiscard]] double extentAcross(const EdgeSide& side) const {
        const auto& nodes = patch_.rectangles[side.cell].nodes;
        return distance(patch_.material[nodes[(side.side + 1) % 4]], patch_.material[nodes[(side.side + 2) % 4]]);
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
};

/// ½·k·|x₀₀ − x₁₀ − x₀₁ + x₁₁|², k = (4·B45 − B1 − B2)/(a·b).
bool appendTwist(ClothModel& model, const Patch& patch, const material::Fabric& fabric) {
    const double constant = 4 * fabric.biasBending - fabric.warpBending - fabric.weftBending;
    if (constant <= 0) return constant < 0;
    StencilCollector stencils(patch.rectangles.size());
    for (const PatchRectangle& cell : patch.rectangles) {
        const Vec2 sides = patch.material[cell.nodes[2]] - patch.material[cell.nodes[0]];
        Combination twist;
        for (int corner = 0; corner < 4; ++corner) twist.add(cell.nodes[corner], corner % 2 == 0 ? 1 : -1);
        stencils.add(twist, cell.factors.bending * constant / (sides.x * sides.y));
    }
    stencils.writeTo(model.twist, patch.particles);
    return false;
}

} // namespace

bool appendBending(ClothModel& model, const Patch& patch, const material::Fabric& fabric) {
    BendingBuilder(patch, fabric).appendTo(model);
    return appendTwist(model, patch, fabric);
}

Hinge seamHinge(const SeamEdge& edge) {
    expects(edge.length > 0 && edge.heightC > 0 && edge.heightD > 0, "a seam edge and its cells have an extent");
    const double areas = 0.5 * edge.length * (edge.heightC + edge.heightD);
    return {edge.particles[0], edge.particles[1], edge.particles[2],
            edge.particles[3], edge.restAngle,    edge.bending * edge.length * edge.length / areas};
}

void doubleBendingAtClampedRows(ClothModel& model) {
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
