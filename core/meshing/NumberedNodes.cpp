// SPDX-License-Identifier: GPL-3.0-or-later
// The nodes of a finished piece: where they are, and in which order.
#include "core/meshing/FinishedPiece.h"

#include <algorithm>
#include <cstring>

namespace toile::meshing {
namespace {

std::size_t at(int i) {
    return static_cast<std::size_t>(i);
}

/// Eight flags at once, each 0 or 1.
std::uint64_t eight(const char* flags) {
    std::uint64_t all = 0;
    std::memcpy(&all, flags, sizeof all);
    return all;
}
constexpr std::uint64_t allEight = 0x0101010101010101ULL;

} // namespace

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
    auto hanging = hanging_.begin();
    for (int latticeNode = lattice_->cornerCount(); latticeNode < lattice_->nodeCount(); ++latticeNode) {
        if (!fill_->inner[at(latticeNode)]) continue;
        const int node = borderCount_ + latticeNode;
        while (hanging != hanging_.end() && hanging->node < node) ++hanging;
        auto& list = hanging != hanging_.end() && hanging->node == node ? slaves_ : others_;
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

std::size_t PieceFinisher::countNodes() const {
    std::size_t count = at(borderCount_);
    for (std::size_t node = 0; node + GridFill::margin < fill_->inner.size(); node += 8)
        count += (eight(fill_->inner.data() + node) * allEight) >> 56; // their sum
    return count;
}

void PieceFinisher::measureLines() {
    u_.clear();
    v_.clear();
    alongWeft_.clear();
    alongWarp_.clear();
    for (const double x : lattice_->mainX()) {
        u_.push_back(frame_->materialFromFrame({x, 0}).x);
        alongWeft_.push_back({frame_->cosine * u_.back(), frame_->sine * u_.back()});
    }
    for (const double y : lattice_->mainY()) {
        v_.push_back(frame_->materialFromFrame({0, y}).y);
        alongWarp_.push_back({-(frame_->sine * v_.back()), frame_->cosine * v_.back()});
    }
}

void PieceFinisher::numberNodes(const NodePlaces& places) {
    const std::size_t count = countNodes();
    mesh_->nodes.resize(count);
    mesh_->material.resize(count);
    borderNumbers_.resize(at(borderCount_));
    measureLines();
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
    int next = MortonWalk(
                   square_, lattice_->columns() + 1, lattice_->rows() + 1, others_,
                   [this](int number, int column, int row) { return numberBlock(number, column, row); },
                   [this](int number, int column, int row) { return numberCorner(number, column, row); }, visitOther)
                   .run();
    for (const KeyedNode& slave : slaves_) next = visitOther(next, slave.second);
    for (const auto& [node, latticeNode] : fill_->aligned) fill_->node[at(latticeNode)] = borderNumbers_[at(node)];
    for (std::size_t v = 0; v < strip_->places.size(); ++v) // these may have been moved
        if (layer_->isFree[v]) place(numberOf(layer_->stripNodes[v]), strip_->places[v]);
}

int PieceFinisher::numberCorner(int number, int column, int row) {
    const std::size_t node = at(lattice_->corner(column, row));
    if (!fill_->inner[node]) return number;
    mesh_->material[at(number)] = {u_[at(column)], v_[at(row)]};
    mesh_->nodes[at(number)] = alongWeft_[at(column)] + alongWarp_[at(row)];
    fill_->node[node] = number;
    return number + 1;
}

int PieceFinisher::numberBlock(int number, int column, int row) {
    const std::size_t width = at(lattice_->columns() + 1);
    const char* inner = fill_->inner.data() + lattice_->corner(column, row);
    std::uint64_t every = allEight, any = 0;
    for (int r = 0; r < 8; ++r, inner += width) {
        every &= eight(inner);
        any |= eight(inner);
    }
    if (any == 0) return number;
    if (every == allEight) {
        numberWholeBlock(number, column, row);
        return number + 64;
    }
    for (const auto [x, y] : orderInBlock) number = numberCorner(number, column + x, row + y);
    return number;
}

/// All 64 corners are inner nodes: sixteen times two by two.
void PieceFinisher::numberWholeBlock(int number, int column, int row) {
    const std::ptrdiff_t width = lattice_->columns() + 1;
    int* const numbers = fill_->node.data() + lattice_->corner(column, row);
    const double *u = u_.data() + column, *v = v_.data() + row;
    const Vec2 *weft = alongWeft_.data() + column, *warp = alongWarp_.data() + row;
    Vec2 *material = mesh_->material.data() + number, *point = mesh_->nodes.data() + number;
    for (std::size_t k = 0; k < 64; k += 4) {
        const auto [x, y] = orderInBlock[k];
        int *low = numbers + y * width + x, *high = low + width;
        low[0] = number++;
        low[1] = number++;
        high[0] = number++;
        high[1] = number++;
        for (int i = 0; i < 4; ++i) {
            const int c = x + i % 2, r = y + i / 2;
            *material++ = {u[c], v[r]};
            *point++ = weft[c] + warp[r];
        }
    }
}

} // namespace toile::meshing
