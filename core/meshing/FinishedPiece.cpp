// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/meshing/FinishedPiece.h"

#include "core/base/Contracts.h"

#include <algorithm>
#include <cstring>

namespace toile::meshing {
namespace {

std::size_t at(int i) {
    return static_cast<std::size_t>(i);
}

/// None of eight flags is set.
bool noneOfEight(const char* flags) {
    std::uint64_t all = 0;
    std::memcpy(&all, flags, sizeof all);
    return all == 0;
}

} // namespace

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
    addRectangles();
    addTriangles();
    addDisplay(places);
    addSlaves();
    mesh.loops = boundary.loops;
    for (auto& loop : mesh.loops)
        for (EdgeNodes& edge : loop)
            for (EdgeNode& node : edge) node.node = borderNumbers_[at(node.node)];
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

std::uint64_t PieceFinisher::keyOf(GridPoint point) const {
    const auto coordinate = [](const IntegerAxis& lines, std::int32_t value) {
        const int i = lines.interval(value);
        const std::int64_t width = std::max<std::int64_t>(1, std::int64_t{lines[i + 1]} - lines[i]);
        const std::int64_t part = 256 * (std::int64_t{value} - lines[i]) / width;
        return static_cast<int>(256 * i + std::clamp<std::int64_t>(part, 0, 255));
    };
    return square_.key(coordinate(fill_->lines.x, point.x), coordinate(fill_->lines.y, point.y));
}

/// The nodes that are no corners of main cells, and no slaves; and the slaves.
void PieceFinisher::listOthers() {
    const IntegerLines& lines = fill_->lines;
    square_ = MortonSquare(lines.x.count(), lines.y.count(), lines.x.firstFrom(0), lines.y.firstFrom(0));
    others_.clear();
    slaves_.clear();
    for (int node = 0; node < borderCount_; ++node) others_.emplace_back(keyOf(boundary_->grid[at(node)]), node);
    for (int latticeNode = lattice_->cornerCount(); latticeNode < lattice_->nodeCount(); ++latticeNode) {
        if (!fill_->inner[at(latticeNode)]) continue;
        const int node = fill_->node[at(latticeNode)];
        auto& list = hangingAt(node) ? slaves_ : others_;
        list.emplace_back(keyOf(fill_->gridAt(*lattice_, latticeNode)), node);
    }
    sortByKey(others_, othersBuffer_);
    sortByKey(slaves_, slavesBuffer_);
}

void PieceFinisher::place(int number, Vec2 inFrame) {
    const Vec2 material = frame_->materialFromFrame(inFrame);
    mesh_->material[at(number)] = material;
    mesh_->nodes[at(number)] = frame_->pointOf(material);
}

void PieceFinisher::numberNodes(const NodePlaces& places) {
    const std::size_t count = at(borderCount_) + fill_->latticeNode.size();
    mesh_->nodes.resize(count);
    mesh_->material.resize(count);
    borderNumbers_.resize(at(borderCount_));
    u_.clear();
    v_.clear();
    for (const double x : lattice_->mainX()) u_.push_back(frame_->materialFromFrame({x, 0}).x);
    for (const double y : lattice_->mainY()) v_.push_back(frame_->materialFromFrame({0, y}).y);

    const int width = lattice_->columns() + 1, height = lattice_->rows() + 1;
    const auto isEmpty = [&](int column, int row) {
        const char* inner = fill_->inner.data() + lattice_->corner(column, row);
        for (int r = 0; r < 8; ++r, inner += width)
            if (!noneOfEight(inner)) return false;
        return true;
    };
    const auto visitCorner = [width, inner = fill_->inner.data(), numbers = fill_->node.data(), u = u_.data(),
                              v = v_.data(), materials = mesh_->material.data(), points = mesh_->nodes.data(),
                              cosine = frame_->cosine, sine = frame_->sine](int number, int column, int row) {
        const int node = row * width + column;
        if (!inner[node]) return number;
        const Vec2 material{u[column], v[row]};
        materials[number] = material;
        points[number] = {cosine * material.x - sine * material.y, sine * material.x + cosine * material.y};
        numbers[node] = number;
        return number + 1;
    };
    const auto visitOther = [&](int number, int node) {
        place(number, places(node));
        if (node < borderCount_) {
            mesh_->nodes[at(number)] = boundary_->points[at(node)];
            borderNumbers_[at(node)] = number;
        } else {
            fill_->node[at(places.latticeNode(node))] = number;
        }
        return number + 1;
    };
    int next = MortonWalk(square_, width, height, others_, isEmpty, visitCorner, visitOther).run();
    for (const KeyedNode& slave : slaves_) next = visitOther(next, slave.second);
    for (const auto& [node, latticeNode] : fill_->aligned) fill_->node[at(latticeNode)] = borderNumbers_[at(node)];
    for (std::size_t v = 0; v < strip_->places.size(); ++v) // these may have been moved
        if (layer_->isFree[v]) place(numberOf(layer_->stripNodes[v]), strip_->places[v]);
}

int PieceFinisher::numberOf(int node) const {
    return node < borderCount_ ? borderNumbers_[at(node)]
                               : fill_->node[at(fill_->latticeNode[at(node - borderCount_)])];
}

std::array<int, 3> PieceFinisher::turned(std::array<int, 3> nodes) const {
    for (int& node : nodes) node = numberOf(node);
    if (mirrored_) std::swap(nodes[1], nodes[2]);
    return nodes;
}

/// Whole cells by rows, with their two triangles for display; then mixed ones.
void PieceFinisher::addRectangles() {
    std::size_t count = 0;
    const auto whole = at(lattice_->wholeCell(0, lattice_->rows()));
    for (std::size_t cell = 0; cell < whole; ++cell) count += static_cast<std::size_t>(fill_->filled[cell]);
    const bool uniform = lattice_->isUniform();
    mesh_->rectangles.resize(count + layer_->mixed.size()); // mixed ones that are whole are counted twice
    mesh_->display.resize(2 * count);
    Rectangle* rectangle = mesh_->rectangles.data();
    std::array<int, 3>* display = mesh_->display.data();
    const bool mirrored = mirrored_, hasRegions = !lattice_->region.empty();
    for (int row = 0, columns = lattice_->columns(); row < lattice_->rows(); ++row) {
        const char* filled = fill_->filled.data() + lattice_->wholeCell(0, row);
        const int* low = fill_->node.data() + lattice_->corner(0, row);
        const int* high = low + columns + 1;
        for (int column = 0; column < columns; ++column) {
            if (!filled[column] || (!uniform && lattice_->isMixed(column, row))) continue;
            const int a = low[column], b = low[column + 1], c = high[column + 1], d = high[column];
            const int region = hasRegions ? lattice_->regionOf(lattice_->cell(column, row)) : -1;
            rectangle->nodes = {mirrored ? b : a, mirrored ? a : b, mirrored ? d : c, mirrored ? c : d};
            rectangle->region = region;
            display[0] = {a, mirrored ? c : b, mirrored ? b : c};
            display[1] = {a, mirrored ? d : c, mirrored ? c : d};
            ++rectangle;
            display += 2;
        }
    }
    for (const MixedCell& cell : layer_->mixed) {
        std::array<int, 4> c{};
        for (std::size_t i = 0; i < 4; ++i) c[i] = numberOf(cell.corners[i]);
        if (mirrored_) c = {c[1], c[0], c[3], c[2]};
        *rectangle++ = {c, cell.region};
    }
    mesh_->rectangles.resize(static_cast<std::size_t>(rectangle - mesh_->rectangles.data()));
    mesh_->display.resize(static_cast<std::size_t>(display - mesh_->display.data()));
}

void PieceFinisher::addTriangles() {
    mesh_->triangles.clear();
    for (int t = 0; t < strip_->sides.triangles(); ++t) {
        std::array<int, 3> nodes = strip_->sides.corners(t);
        for (int& node : nodes) node = layer_->stripNodes[at(node)];
        mesh_->triangles.push_back({turned(nodes), strip_->region[at(t)], strip_->mergedWith[at(t)]});
    }
}

/// Mixed cells with the nodes on their sides, then the strip.
void PieceFinisher::addDisplay(const NodePlaces& places) {
    const std::size_t before = mesh_->display.size();
    for (const MixedCell& cell : layer_->mixed) cellTriangles_.append(*layer_, places, cell, mesh_->display);
    for (std::size_t t = before; t < mesh_->display.size(); ++t) mesh_->display[t] = turned(mesh_->display[t]);
    for (const Triangle& triangle : mesh_->triangles) mesh_->display.push_back(triangle.nodes);
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
