// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/meshing/CellWriter.h"
#include "core/meshing/DisplayTriangles.h"
#include "core/meshing/GarmentMesh.h"
#include "core/meshing/MortonWalk.h"
#include "core/meshing/Strip.h"

namespace toile::meshing {

/// Makes the mesh as consumers see it: numbers the nodes along a Morton curve, slaves last, and turns everything back
/// into the piece's coordinates. Buffers are kept between calls.
class PieceFinisher {
public:
    /// Overwrites `mesh`; and the numbers in `fill.node` by those of the finished mesh.
    void run(const PieceFrame& frame, const BoundaryNodes& boundary, const Lattice& lattice, const NodePlaces& places,
             GridFill& fill, const CellLayer& layer, const Strip& strip, PieceMesh& mesh);

private:
    /// A node that hangs on a side of a larger cell: at t of the way from one corner to the other, which may hang
    /// themselves.
    struct Hanging {
        int node, from, to;
        double t;
    };

    void listHanging(const NodePlaces& places);
    void listOthers();
    [[nodiscard]] std::size_t countNodes() const;
    void measureLines();
    void numberNodes(const NodePlaces& places);
    void place(int number, Vec2 inFrame);
    void addRectangles(const NodePlaces& places);
    [[nodiscard]] CellWriter addedWhole(CellWriter to) const;
    void addDivided(const NodePlaces& places, CellWriter& to);
    void addPlain(int main, CellWriter& to);
    void addTriangles();
    void addSlaves();
    void collectMasters(int node, double weight, int depth);
    [[nodiscard]] std::uint64_t keyOf(GridPoint point) const;
    [[nodiscard]] const Hanging* hangingAt(int node) const;
    [[nodiscard]] int numberOf(int node) const;
    [[nodiscard]] std::array<int, 3> turned(std::array<int, 3> nodes) const;

    const PieceFrame* frame_ = nullptr;
    const BoundaryNodes* boundary_ = nullptr;
    const Lattice* lattice_ = nullptr;
    GridFill* fill_ = nullptr;
    const CellLayer* layer_ = nullptr;
    const Strip* strip_ = nullptr;
    PieceMesh* mesh_ = nullptr;
    int borderCount_ = 0;
    bool mirrored_ = false;
    bool streamed_ = false;        ///< the mesh is larger than the caches
    std::size_t displayed_ = 0;    ///< triangles that rectangles are cut in
    std::vector<Hanging> hanging_; ///< by node, rising
    MortonSquare square_;
    std::vector<KeyedNode> others_, slaves_, othersBuffer_, slavesBuffer_;
    std::vector<int> borderNumbers_;
    std::vector<double> u_, v_; ///< material coordinates of the main lines
    std::vector<Vec2> alongWeft_,
        alongWarp_;                  ///< their parts of the piece's coordinates: a corner's are the sum of both
    std::vector<int> row_, nextRow_; ///< nodes of a main cell
    std::vector<std::pair<int, double>> masters_;
    CellTriangulator cellTriangles_;
};

} // namespace toile::meshing
