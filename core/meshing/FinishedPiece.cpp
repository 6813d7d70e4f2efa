// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/meshing/FinishedPiece.h"
#include "core/base/Index.h"

#include "core/base/Contracts.h"
#include "core/meshing/Flags.h"

#include <algorithm>

namespace toile::meshing {
void PieceFinisher::run(const PieceFrame& frame, const BoundaryNodes& boundary, const Lattice& lattice,
                        const NodePlaces& places, GridFill& fill, const CellLayer& layer, const Strip& strip,
                        PieceMesh& mesh) {
    frame_ = &frame;
    boundary_ = &boundary;
    lattice_ = &lattice;
    fill_ = &fill;
    layer_ = &layer;
    strip_ = &strip;
    mesh_ = &mesh;
    borderCount_ = places.borderCount();
    mirrored_ = frame.side < 0;
    listHanging(places);
    listOthers();
    numberNodes(places);
    addRectangles(places);
    if (streamed_) endStreaming();
    addTriangles();
    addSlaves();
    mesh.loops = boundary.loops;
    for (auto& loop : mesh.loops)
        for (EdgeNodes& edge : loop)
            for (EdgeNode& node : edge) node.node = borderNumbers_[at(node.node)];
    mesh.folds = boundary.folds;
    for (auto& fold : mesh.folds)
        for (int& node : fold) node = borderNumbers_[at(node)];
}

void PieceFinisher::listHanging(const NodePlaces& places) {
    hanging_.clear();
    if (layer_->hangingNodes.empty()) return;
    for (const MixedCell& cell : layer_->mixed)
        for (std::size_t side = 0; side < 4; ++side) {
            const auto nodes = layer_->hangingOn(cell, side);
            if (nodes.empty()) continue;
            const int from = cell.corners[side], to = cell.corners[(side + 1) % 4];
            const Vec2 start = places(from), along = places(to) - start;
            for (const int node : nodes)
                if (node >= borderCount_)
                    hanging_.push_back({node, from, to, dot(places(node) - start, along) / squaredLength(along)});
        }
    std::sort(hanging_.begin(), hanging_.end(), [](const Hanging& a, const Hanging& b) { return a.node < b.node; });
}

const PieceFinisher::Hanging* PieceFinisher::hangingAt(int node) const {
    const auto found = std::lower_bound(hanging_.begin(), hanging_.end(), node,
                                        [](const Hanging& hanging, int wanted) { return hanging.node < wanted; });
    return found != hanging_.end() && found->node == node ? &*found : nullptr;
}

int PieceFinisher::numberOf(int node) const {
    return node < borderCount_ ? borderNumbers_[at(node)] : fill_->node[at(node - borderCount_)];
}

std::array<int, 3> PieceFinisher::turned(std::array<int, 3> nodes) const {
    for (int& node : nodes) node = numberOf(node);
    if (mirrored_) std::swap(nodes[1], nodes[2]);
    return nodes;
}

/// Whole cells by rows, then those in and beside divided ones; for display each cut in two, or between the nodes on its
/// sides. The strip's triangles are displayed as they are.
void PieceFinisher::addRectangles(const NodePlaces& places) {
    const auto whole = std::span(fill_->filled).first(at(lattice_->wholeCell(0, lattice_->rows())));
    std::size_t count = countOf(whole) + layer_->mixed.size(); // those that are both are counted twice
    for (const int main : layer_->plain) count += at(lattice_->divisionOf(main) * lattice_->divisionOf(main));
    mesh_->rectangles.resize(count);
    mesh_->display.resize(2 * count + layer_->hangingNodes.size() + at(strip_->sides.triangles()));
    CellWriter to(mesh_->rectangles.data(), mesh_->display.data(), mirrored_, streamed_);
    to = addedWhole(to);
    if (!lattice_->isUniform()) addDivided(places, to);
    mesh_->rectangles.resize(to.rectangles(mesh_->rectangles.data()));
    displayed_ = to.displayed(mesh_->display.data());
}

CellWriter PieceFinisher::addedWhole(CellWriter to) const {
    const int columns = lattice_->columns();
    const bool uniform = lattice_->isUniform(), hasRegions = !lattice_->region.empty();
    for (int row = 0; row < lattice_->rows(); ++row) {
        const char* filled = fill_->filled.data() + lattice_->wholeCell(0, row);
        const int* low = fill_->node.data() + lattice_->corner(0, row);
        const int* high = low + columns + 1;
        if (uniform && !hasRegions) {
            for (int column = 0; column < columns; ++column)
                if (filled[column]) to.add(low + column, high + column, -1);
        } else {
            for (int column = 0; column < columns; ++column)
                if (filled[column] && !lattice_->isMixed(column, row))
                    to.add(low + column, high + column, lattice_->regionOf(lattice_->cell(column, row)));
        }
    }
    return to;
}

/// By their main cells: plain ones, and the others.
void PieceFinisher::addDivided(const NodePlaces& places, CellWriter& to) {
    auto plain = layer_->plain.begin();
    for (const MixedCell& cell : layer_->mixed) {
        for (; plain != layer_->plain.end() && *plain < cell.main; ++plain) addPlain(*plain, to);
        std::array<int, 4> c{};
        for (std::size_t i = 0; i < 4; ++i) c[i] = numberOf(cell.corners[i]);
        const std::array<int, 2> low{c[0], c[1]}, high{c[3], c[2]};
        const int region = lattice_->regionOf(cell.main);
        if (!cell.hasHanging()) {
            to.add(low.data(), high.data(), region);
            continue;
        }
        to.addRectangle(low.data(), high.data(), region);
        for (const auto& triangle : cellTriangles_.of(*layer_, places, cell)) to.addTriangle(turned(triangle));
    }
    for (; plain != layer_->plain.end(); ++plain) addPlain(*plain, to);
}

void PieceFinisher::addPlain(int main, CellWriter& to) {
    const int column = main % lattice_->columns(), row = main / lattice_->columns(), u = lattice_->divisionOf(main);
    const auto listRow = [&](int b) {
        lattice_->nodesOfRow(column, row, b, nextRow_);
        for (int& node : nextRow_) node = fill_->node[at(node)];
    };
    listRow(0);
    for (int b = 0; b < u; ++b) {
        std::swap(row_, nextRow_);
        listRow(b + 1);
        for (int a = 0; a < u; ++a) to.add(row_.data() + a, nextRow_.data() + a, lattice_->regionOf(main));
    }
}

void PieceFinisher::addTriangles() {
    const int count = strip_->sides.triangles();
    mesh_->triangles.resize(at(count));
    mesh_->display.resize(displayed_ + at(count));
    for (int t = 0; t < count; ++t) {
        std::array<int, 3> nodes = strip_->sides.corners(t);
        for (int& node : nodes) node = layer_->stripNodes[at(node)];
        nodes = turned(nodes);
        mesh_->triangles[at(t)] = {nodes, strip_->region[at(t)], strip_->mergedWith[at(t)]};
        mesh_->display[displayed_ + at(t)] = nodes;
    }
}

/// Adds the free nodes that a node stands on, with weights.
void PieceFinisher::collectMasters(int node, double weight, int depth) {
    expects(depth < 64, "chains of hanging nodes end");
    if (const Hanging* hanging = hangingAt(node)) {
        collectMasters(hanging->from, weight * (1 - hanging->t), depth + 1);
        collectMasters(hanging->to, weight * hanging->t, depth + 1);
        return;
    }
    const int number = numberOf(node);
    for (auto& [master, share] : masters_)
        if (master == number) {
            share += weight;
            return;
        }
    masters_.emplace_back(number, weight);
}

void PieceFinisher::addSlaves() {
    mesh_->slaves.resize(slaves_.size());
    const int first = static_cast<int>(mesh_->nodes.size() - slaves_.size());
    for (std::size_t s = 0; s < slaves_.size(); ++s) {
        masters_.clear();
        collectMasters(slaves_[s].second, 1, 0);
        std::sort(masters_.begin(), masters_.end());
        mesh_->slaves[s].node = first + static_cast<int>(s);
        mesh_->slaves[s].masters.assign(masters_.begin(), masters_.end());
    }
}

} // namespace toile::meshing
