// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cloth/Patch.h"

#include "core/base/Contracts.h"
#include "core/cloth/DrawnSides.h"
#include "core/cloth/NodeChains.h"
#include "core/cloth/PatchBending.h"

#include <algorithm>
#include <fmt/format.h>
#include <optional>

namespace toile::cloth {
namespace {

using material::Fabric;
using material::MembraneStiffness;

Fabric scaled(Fabric fabric, const StiffnessFactors& factors) {
    fabric.warpStiffness *= factors.stretch;
    fabric.weftStiffness *= factors.stretch;
    fabric.coupling *= factors.stretch;
    fabric.shearStiffness *= factors.shear;
    return fabric;
}

/// Membrane constants of one form of cell, solved once per set of factors.
class Constants {
public:
    Constants(const Fabric& fabric, bool springs) : fabric_(fabric), springs_(springs) {}

    [[nodiscard]] Result<MembraneStiffness> of(const StiffnessFactors& factors) {
        if (last_ && factors == lastFactors_) return *last_;
        const Fabric local = scaled(fabric_, factors);
        auto constants = material::membraneStiffness(local, springs_ ? local.shearStiffness : local.coupling);
        if (!constants) return constants;
        last_ = *constants;
        lastFactors_ = factors;
        return *last_;
    }

private:
    const Fabric& fabric_;
    bool springs_;
    std::optional<MembraneStiffness> last_;
    StiffnessFactors lastFactors_;
};

/// Spring constants of one rectangle [N/m]; along weft and warp for one side each.
struct CellSprings {
    double diagonal = 0, weft = 0, warp = 0;
    [[nodiscard]] bool isNegative() const { return weft < 0 || warp < 0; }
};

CellSprings cellSprings(const MembraneStiffness& c, double a, double b) {
    const double g = c.c33;
    return {.diagonal = g * (a * a + b * b) / (2 * a * b),
            .weft = 0.5 * (c.c11 - g * a * a / (b * b)) * b / a,
            .warp = 0.5 * (c.c22 - g * b * b / (a * a)) * a / b};
}

/// Collects springs between nodes of a patch at the end of a list; those of neighbouring cells become one.
class SpringCollector {
public:
    SpringCollector(std::vector<Spring>& springs, std::size_t nodes, std::size_t expected)
        : springs_(springs), first_(springs.size()), byNode_(nodes, expected) {
        springs.reserve(first_ + expected);
    }

    void add(int a, int b, double restLength, double stiffness) {
        if (stiffness == 0) return;
        const int low = std::min(a, b), high = std::max(a, b);
        const int known = byNode_.find(low, [&](int entry) {
            const Spring& spring = springs_[first_ + entry];
            return std::max(spring.a, spring.b) == high;
        });
        if (known >= 0) {
            springs_[first_ + known].stiffness += stiffness;
            return;
        }
        springs_.push_back({a, b, restLength, stiffness});
        byNode_.add(low);
    }
    /// Nodes become particles; what has only one of them is no spring.
    void finish(std::span<const int> particles) {
        const auto own = springs_.begin() + static_cast<std::ptrdiff_t>(first_);
        for (auto spring = own; spring != springs_.end(); ++spring) {
            spring->a = particles[spring->a];
            spring->b = particles[spring->b];
        }
        springs_.erase(std::remove_if(own, springs_.end(), [](const Spring& spring) { return spring.a == spring.b; }),
                       springs_.end());
    }

private:
    std::vector<Spring>& springs_;
    std::size_t first_;
    NodeChains byNode_; ///< the smaller of both
};

class PatchBuilder {
public:
    PatchBuilder(ClothModel& model, const Patch& patch, const Fabric& fabric)
        : model_(model), patch_(patch), fabric_(fabric) {}

    Result<PatchReport> append(const PatchSettings& settings) {
        checkIndices();
        auto membrane = wantsMembrane(settings.form);
        if (!membrane) return tl::unexpected(membrane.error());
        report_.membraneCells = *membrane && !patch_.rectangles.empty();
        appendTensionCurves(*membrane);
        if (auto done = *membrane ? appendCells() : appendSprings(); !done) return tl::unexpected(done.error());
        if (auto done = appendTriangles(*membrane); !done) return tl::unexpected(done.error());
        appendMasses();
        appendSlaves();
        report_.twistLeftOut = appendBending(model_, patch_, fabric_);
        return report_;
    }

private:
    void checkIndices() const {
        expects(patch_.material.size() == patch_.particles.size(), "a patch has one particle per node");
        const auto isNode = [&](int n) { return n >= 0 && n < static_cast<int>(patch_.material.size()); };
        for (const auto& cell : patch_.rectangles) expects(std::ranges::all_of(cell.nodes, isNode), "corner is a node");
        for (const auto& cell : patch_.triangles) expects(std::ranges::all_of(cell.nodes, isNode), "corner is a node");
        for (const auto& slave : patch_.slaves) {
            expects(isNode(slave.node) && !slave.masters.empty(), "a slave is a node and has masters");
            for (const auto& [node, weight] : slave.masters) expects(isNode(node), "a master is a node");
        }
    }

    [[nodiscard]] double width(const PatchRectangle& cell) const {
        return patch_.material[cell.nodes[1]].x - patch_.material[cell.nodes[0]].x;
    }
    [[nodiscard]] double height(const PatchRectangle& cell) const {
        return patch_.material[cell.nodes[3]].y - patch_.material[cell.nodes[0]].y;
    }
    [[nodiscard]] double doubleArea(const PatchTriangle& cell) const {
        const auto& [a, b, c] = cell.nodes;
        return cross(patch_.material[b] - patch_.material[a], patch_.material[c] - patch_.material[a]);
    }

    /// One rule for the whole piece, so that no fold forms where the kind of cell changes.
    [[nodiscard]] Result<bool> wantsMembrane(CellForm form) const {
        if (form != CellForm::automatic) return form == CellForm::membrane;
        if (fabric_.kind == material::FabricKind::knit) return true;
        Constants constants(fabric_, true);
        for (const PatchRectangle& cell : patch_.rectangles) {
            auto c = constants.of(cell.factors);
            if (!c) return tl::unexpected(c.error());
            if (cellSprings(*c, width(cell), height(cell)).isNegative()) return true;
        }
        return false;
    }

    void appendTensionCurves(bool membrane) {
        if (!membrane || (fabric_.warpTension.empty() && fabric_.weftTension.empty())) return;
        tension_ = static_cast<int>(model_.tensionCurves.size());
        model_.tensionCurves.push_back({fabric_.warpTension, fabric_.weftTension});
    }

    Result<void> appendSprings() {
        Constants constants(fabric_, true);
        const std::size_t cells = patch_.rectangles.size(), nodes = patch_.material.size();
        SpringCollector sides(model_.structural, nodes, 2 * cells + 16), diagonals(model_.shear, nodes, 2 * cells);
        for (const PatchRectangle& cell : patch_.rectangles) {
            auto c = constants.of(cell.factors);
            if (!c) return tl::unexpected(c.error());
            const DrawnRectangle rest = drawnRectangle(patch_, cell);
            CellSprings springs = cellSprings(*c, width(cell), height(cell));
            if (springs.isNegative()) {
                ++report_.clampedCells;
                springs.weft = std::max(0.0, springs.weft);
                springs.warp = std::max(0.0, springs.warp);
            }
            const auto& n = cell.nodes;
            sides.add(n[0], n[1], rest.sides[0], springs.weft);
            sides.add(n[3], n[2], rest.sides[2], springs.weft);
            sides.add(n[0], n[3], rest.sides[3], springs.warp);
            sides.add(n[1], n[2], rest.sides[1], springs.warp);
            diagonals.add(n[0], n[2], rest.diagonal, springs.diagonal);
            diagonals.add(n[1], n[3], rest.diagonal, springs.diagonal);
        }
        model_.clampedCells += report_.clampedCells;
        sides.finish(patch_.particles);
        diagonals.finish(patch_.particles);
        return {};
    }

    Result<void> appendCells() {
        Constants constants(fabric_, false);
        for (const PatchRectangle& cell : patch_.rectangles) {
            auto c = constants.of(cell.factors);
            if (!c) return tl::unexpected(c.error());
            if (drawnRectangle(patch_, cell).drawn) {
                appendHalves(cell, *c);
                continue;
            }
            MembraneCell element{.width = width(cell), .height = height(cell), .stiffness = *c, .tension = tension_};
            std::ranges::transform(cell.nodes, element.particles.begin(), [&](int n) { return patch_.particles[n]; });
            model_.cells.push_back(element);
        }
        return {};
    }

    /// A membrane cell is a rectangle at rest; one that is drawn up becomes two triangles.
    void appendHalves(const PatchRectangle& cell, const MembraneStiffness& stiffness) {
        const auto corners = drawnCorners(patch_, cell.nodes);
        for (const auto& [a, b, c] : {std::array{0, 1, 2}, std::array{2, 3, 0}})
            appendTriangle({cell.nodes[a], cell.nodes[b], cell.nodes[c]}, {corners[a], corners[b], corners[c]},
                           stiffness);
    }

    void appendTriangle(const std::array<int, 3>& nodes, const std::array<Vec2, 3>& rest,
                        const MembraneStiffness& stiffness) {
        const Vec2 u = rest[1] - rest[0], v = rest[2] - rest[0];
        const double twice = cross(u, v);
        expects(twice > 0, "triangles run counter-clockwise and have an area");
        MembraneTriangle element{.inverseRest = {v.y / twice, -v.x / twice, -u.y / twice, u.x / twice},
                                 .area = 0.5 * twice,
                                 .stiffness = stiffness,
                                 .tension = tension_};
        std::ranges::transform(nodes, element.particles.begin(), [&](int n) { return patch_.particles[n]; });
        model_.triangles.push_back(element);
    }

    Result<void> appendTriangles(bool membrane) {
        Constants constants(fabric_, !membrane);
        for (const PatchTriangle& cell : patch_.triangles) {
            auto c = constants.of(cell.factors);
            if (!c) return tl::unexpected(c.error());
            appendTriangle(cell.nodes, drawnCorners(patch_, cell.nodes), *c);
        }
        return {};
    }

    void appendMasses() {
        std::vector<double> nodeMass(patch_.material.size(), 0);
        for (const PatchRectangle& cell : patch_.rectangles) {
            const double area = width(cell) * height(cell);
            expects(width(cell) > 0 && height(cell) > 0, "rectangles have an extent and their corners in order");
            report_.area += area;
            for (int n : cell.nodes) nodeMass[n] += 0.25 * fabric_.arealDensity * area;
        }
        for (const PatchTriangle& cell : patch_.triangles) {
            report_.area += 0.5 * doubleArea(cell);
            for (int n : cell.nodes) nodeMass[n] += fabric_.arealDensity * doubleArea(cell) / 6;
        }
        for (const PatchSlave& slave : patch_.slaves) {
            for (const auto& [master, weight] : slave.masters) nodeMass[master] += weight * nodeMass[slave.node];
            nodeMass[slave.node] = 0;
        }
        const int largest = patch_.particles.empty() ? -1 : std::ranges::max(patch_.particles);
        if (model_.particleCount() <= largest) model_.mass.resize(largest + 1, 0.0);
        for (std::size_t n = 0; n < nodeMass.size(); ++n) model_.mass[patch_.particles[n]] += nodeMass[n];
    }

    void appendSlaves() {
        for (const PatchSlave& slave : patch_.slaves) {
            Slave out{.particle = patch_.particles[slave.node], .masters = {}};
            for (const auto& [node, weight] : slave.masters) {
                const int particle = patch_.particles[node];
                expects(particle != out.particle, "a slave is a particle of its own");
                const auto it = std::ranges::find(out.masters, particle, &std::pair<int, double>::first);
                if (it != out.masters.end()) it->second += weight;
                else out.masters.emplace_back(particle, weight);
            }
            model_.slaves.push_back(std::move(out));
        }
    }

    ClothModel& model_;
    const Patch& patch_;
    const Fabric& fabric_;
    PatchReport report_;
    int tension_ = -1;
};

} // namespace

Result<PatchReport> appendPatch(ClothModel& model, const Patch& patch, const Fabric& fabric,
                                const PatchSettings& settings) {
    return PatchBuilder(model, patch, fabric).append(settings);
}

} // namespace toile::cloth
