// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Result.h"
#include "core/cloth/ClothModel.h"
#include "core/material/Fabric.h"

#include <array>
#include <span>
#include <utility>
#include <vector>

namespace toile::cloth {

/// By how much a region is stiffer than its fabric [–].
struct StiffnessFactors {
    double stretch = 1, shear = 1, bending = 1;
    friend bool operator==(const StiffnessFactors&, const StiffnessFactors&) = default;
};

/// Grain-parallel; corners (−weft,−warp), (+weft,−warp), (+weft,+warp), (−weft,+warp).
struct PatchRectangle {
    std::array<int, 4> nodes{};
    StiffnessFactors factors;
};

/// Counter-clockwise in material coordinates.
struct PatchTriangle {
    std::array<int, 3> nodes{};
    StiffnessFactors factors;
};

/// x = Σ weight · x(master); masters are no slaves, weights sum to 1.
struct PatchSlave {
    int node = 0;
    std::vector<std::pair<int, double>> masters;
};

/// A side of a cell that stitching draws up: at rest it is `factor` times as long as it was cut. Ends: the smaller node
/// first.
struct DrawnSide {
    std::pair<int, int> ends;
    double factor = 1;
    friend auto operator<=>(const DrawnSide&, const DrawnSide&) = default;
};

/// One piece of mesh as plain numbers. Nodes are its own; several nodes may be the same particle (a sewn seam, a
/// closed dart): each side keeps its own rest lengths.
struct Patch {
    std::vector<Vec2> material; ///< u weft, v warp of each node [m]
    std::vector<int> particles; ///< particle of each node
    std::vector<PatchRectangle> rectangles;
    std::vector<PatchTriangle> triangles;
    std::vector<PatchSlave> slaves;
    std::vector<std::pair<int, int>> creases; ///< sides that nothing keeps flat: the smaller node first, sorted
    std::vector<DrawnSide> drawn;             ///< sides that a thread draws up, sorted
};

enum class CellForm {
    automatic, ///< springs for woven fabrics unless a cell would need a negative one; membrane cells otherwise
    springs,   ///< springs always, negative constants clamped at 0 and counted (the paper's mode)
    membrane,  ///< membrane cells always
};

struct PatchSettings {
    CellForm form = CellForm::automatic;
};

/// What appendPatch did.
struct PatchReport {
    double area = 0;            ///< [m²]
    bool membraneCells = false; ///< membrane cells instead of springs
    int clampedCells = 0;       ///< only with CellForm::springs
    bool twistLeftOut = false;  ///< 4·B45 − B1 − B2 ≤ 0: no twist element
};

/// Appends masses, slaves and elements of one patch. Grows `model.mass` up to the patch's largest particle.
///
/// Rectangles get cell springs (or membrane cells), three-point bending along their rows and columns and twist;
/// triangles get a membrane element, every edge with a triangle on either side a flat hinge stencil. Arrays the
/// fabric does not need stay empty. Ref: docs/physics/springs.md, docs/physics/bending.md
[[nodiscard]] Result<PatchReport> appendPatch(ClothModel& model, const Patch& patch, const material::Fabric& fabric,
                                              const PatchSettings& settings = {});

/// An edge along which two cells are joined after a merge.
struct SeamEdge {
    std::array<int, 4>
        particles{};   ///< ends a, b; c opposite in the cell where a→b runs counter-clockwise; d in the other
    double length = 0; ///< rest length of the edge [m]
    double heightC = 0, heightD = 0; ///< rest distance of c and d from the edge [m]
    double bending = 0;              ///< B across the edge, factor included [N·m]
    double restAngle = 0;            ///< [rad], see Hinge
};

/// k = B·e²/(A_c + A_d) with the areas of the triangles abc and bad.
[[nodiscard]] Hinge seamHinge(const SeamEdge& edge);

/// Makes clamped rows as stiff as a clamp is: every three-point element whose centre and exactly one outer particle
/// are pinned gets twice its stiffness. Call once, after `pinned` is set. Ref: docs/physics/bending.md
void doubleBendingAtClampedRows(ClothModel& model);

} // namespace toile::cloth
