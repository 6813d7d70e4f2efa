// SPDX-License-Identifier: GPL-3.0-or-later
// The nodes of a finished piece: where they are, and in which order.
#include "core/base/Index.h"
#include "core/meshing/FinishedPiece.h"
#include "core/meshing/Flags.h"

#include <algorithm>

namespace toile::meshing {
namespace {

/// Numbers corners of main cells that are inner nodes, and writes where they are. To be copied: what is written to a
/// mesh cannot change a copy of one's own, which the compiler knows.
struct CornerWriter {
    std::ptrdiff_t width;              ///< of a row of corners
    const char* inner;                 ///< of each corner
    int* numbers;                      ///< of each corner
    const double *u, *v;               ///< of the lines
    const Vec2 *alongWeft, *alongWarp; ///< of the lines: their sum is a corner's place
    Vec2 *materials, *points;          ///< by number
    bool streamed;

    [[nodiscard]] int corner(int number, int column, int row) const {
        const std::ptrdiff_t node = row * width + column;
        if (!inner[node]) return number;
        materials[number] = {u[column], v[row]};
        points[number] = alongWeft[column] + alongWarp[row];
        numbers[node] = number;
        return number + 1;
    }

    [[nodiscard]] int block(int number, int column, int row) const {
        const char* flags = inner + row * width + column;
        std::uint64_t every = allEight, any = 0;
        for (int r = 0; r < 8; ++r, flags += width) {
            every &= eight(flags);
            any |= eight(flags);
        }
        if (any == 0) return number;
        if (every == allEight) return wholeBlock(number, column, row);
        for (const auto [x, y] : orderInBlock) number = corner(number, column + x, row + y);
        return number;
    }

    /// All 64 corners are inner nodes: sixteen times two by two.
    [[nodiscard]] int wholeBlock(int number, int column, int row) const {
        int* const first = numbers + row * width + column;
        for (std::size_t k = 0; k < 64; k += 4) {
            const auto [x, y] = orderInBlock[k];
            int *low = first + y * width + x, *high = low + width;
            low[0] = number;
            low[1] = number + 1;
            high[0] = number + 2;
            high[1] = number + 3;
            for (int i = 0; i < 4; ++i, ++number) {
                const int c = column + x + i % 2, r = row + y + i / 2;
                const Vec2 material{u[c], v[r]}, point = alongWeft[c] + alongWarp[r];
                if (streamed) {
                    stream(materials + number, material);
                    stream(points + number, point);
                } else {
                    materials[number] = material;
                    points[number] = point;
                }
            }
        }
        return number;
    }
};

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
    return at(borderCount_) + countOf(std::span(fill_->inner).first(fill_->inner.size() - GridFill::margin));
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
    streamed_ = count * (2 * sizeof(Vec2) + sizeof(Rectangle) + 2 * sizeof(std::array<int, 3>)) >= streamedFrom;
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
    const CornerWriter writer{
        lattice_->columns() + 1, fill_->inner.data(), fill_->node.data(),     u_.data(),           v_.data(),
        alongWeft_.data(),       alongWarp_.data(),   mesh_->material.data(), mesh_->nodes.data(), streamed_};
    int next = MortonWalk(
                   square_, lattice_->columns() + 1, lattice_->rows() + 1, others_,
                   [writer](int number, int column, int row) { return writer.block(number, column, row); },
                   [writer](int number, int column, int row) { return writer.corner(number, column, row); }, visitOther)
                   .run();
    for (const KeyedNode& slave : slaves_) next = visitOther(next, slave.second);
    for (const auto& [node, latticeNode] : fill_->aligned) fill_->node[at(latticeNode)] = borderNumbers_[at(node)];
    for (std::size_t v = 0; v < strip_->places.size(); ++v) // these may have been moved
        if (layer_->isFree[v]) place(numberOf(layer_->stripNodes[v]), strip_->places[v]);
}

} // namespace toile::meshing
