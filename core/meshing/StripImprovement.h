// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/meshing/DelaunayFlips.h"
#include "core/meshing/FoldNodes.h"
#include "core/meshing/Strip.h"

namespace toile::meshing {

struct ImprovementSettings {
    double wantedAngle = 28; ///< [degrees]; the smallest angle of strip triangles away from the input's own corners
    int passes = 8;          ///< of moving nodes, freeing nodes and triangulating again
    bool anew = false;       ///< triangulate all after each pass, not only what it has changed: slow and obvious
};

/// Triangulates the strip; then moves free nodes, frees bad staircase nodes by giving up their rectangles, and puts
/// nodes beside bad triangles of border nodes alone until the wanted angle is reached. Keeps the best of all passes.
/// Works on grid points alone, so that mirror images stay mirror images. Buffers are kept between calls.
class StripImprover {
public:
    void run(const PieceFrame& frame, const BoundaryNodes& boundary, const Lattice& lattice, const NodePlaces& places,
             GridFill& fill, CellLayer& layer, Strip& strip, const ImprovementSettings& settings = {});

private:
    /// How good a strip is: first the number of triangles below the wanted angle, then the smallest angle.
    struct Grade {
        int bad = 0;
        double sharpest = 0; ///< cotangent of the smallest angle

        [[nodiscard]] bool betterThan(const Grade& other) const {
            return bad != other.bad ? bad < other.bad : sharpest < other.sharpest;
        }
    };

    void collect();
    void triangulate();
    void follow(bool freed);
    void gradeAll();
    void gradeEach();
    void turnFlatOnes();
    void listBad();
    void keepAsBest();
    void restoreBest();
    void finish(const PieceFrame& frame);
    void collectStars();
    bool moveNodes();
    bool moveNode(int vertex);
    bool freeNodes();
    bool addNodes();
    bool addNodeBeside(int triangle);
    [[nodiscard]] int unusedCornerNear(GridPoint place) const;
    [[nodiscard]] bool canFillLocally() const;
    void fillDropped();
    void addVertexOf(int latticeNode);
    void matchNewSides(int firstSide);
    void listMixedCells();
    void listCells(int vertex);
    [[nodiscard]] bool isBorderAngle(int side) const;
    [[nodiscard]] double sharpness(int triangle) const;
    void collectRim(int vertex);
    [[nodiscard]] double starSharpness(GridPoint middle, double limit) const;
    [[nodiscard]] std::span<const int> star(int vertex) const;
    [[nodiscard]] GridPoint point(int vertex) const { return strip_->points[static_cast<std::size_t>(vertex)]; }
    [[nodiscard]] int nodeOf(int vertex) const { return layer_->stripNodes[static_cast<std::size_t>(vertex)]; }
    [[nodiscard]] bool isBorder(int vertex) const { return nodeOf(vertex) < places_->borderCount(); }

    const BoundaryNodes* boundary_ = nullptr;
    const Lattice* lattice_ = nullptr;
    const NodePlaces* places_ = nullptr;
    GridFill* fill_ = nullptr;
    CellLayer* layer_ = nullptr;
    Strip* strip_ = nullptr;
    ImprovementSettings settings_;
    double wanted_ = 0; ///< cotangent of the wanted angle

    CellCollector collector_;
    StripSweep sweep_;
    DelaunayFlips flips_;
    Grade grade_;
    std::vector<double> sharpness_; ///< of each triangle
    std::vector<int> bad_;          ///< triangles below the wanted angle
    std::vector<int> after_;        ///< of each border node in its ring; −1 inside a fold
    FoldSides folds_;
    std::vector<std::pair<int, GridPoint>> moved_;   ///< nodes that were moved, and where to
    std::vector<int> dropped_;                       ///< cells given up, in order
    std::vector<int> added_;                         ///< lattice nodes taken into use
    std::size_t droppedBefore_ = 0;                  ///< how many of them before the pass in hand
    std::vector<int> changed_;                       ///< sides that a pass has touched
    std::vector<char> touched_;                      ///< of each strip node: on a cell that the pass gave up
    std::vector<std::array<int, 3>> openSides_;      ///< start, end and number of sides without a twin
    std::vector<int> firstOfStar_, stars_, movable_; ///< the triangles of each strip node
    std::vector<std::array<GridPoint, 2>> rim_;      ///< sides across from the node in hand, of the triangles at it
    std::vector<int> cells_;                         ///< at the node in hand
    std::vector<char> asked_;                        ///< of each node: on a bad triangle
    std::vector<std::pair<int, int>> mixedAt_;       ///< such a node and a mixed cell that has it; rising
    struct {
        Grade grade;
        std::vector<GridPoint> points;
        TriangleSides sides;
        std::vector<int> stripNodes;
        std::vector<char> isFree;
        bool collected = true;              ///< the layer still lists its mixed cells
        std::size_t dropped = 0, added = 0; ///< how many cells were given up, and nodes taken, by then
    } best_;
};

} // namespace toile::meshing
