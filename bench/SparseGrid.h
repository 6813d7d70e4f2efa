// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bench/NearestWays.h"
#include "core/collision/BodySurface.h"

#include <array>
#include <cmath>
#include <unordered_map>

namespace toile::bench {

/// The signed distance at the nodes of a lattice in a band round the skin, linear in between: blocks of 8³ cells, each
/// with all of its 9³ nodes, found by a hash.
class SparseGrid final : public NearestWay {
public:
    SparseGrid(collision::BodySurface body, double spacing, double band)
        : body_(std::move(body)), spacing_(spacing), band_(band) {
        grow();
    }

    [[nodiscard]] std::optional<Nearest> nearest(const Vec3& p, double) override {
        std::array<int, 3> cell{}, block{};
        std::array<double, 3> t{};
        for (int axis = 0; axis < 3; ++axis) {
            const double place = p[axis] / spacing_;
            cell[axis] = static_cast<int>(std::floor(place));
            t[axis] = place - cell[axis];
            block[axis] = cell[axis] >> 3;
            cell[axis] &= 7;
        }
        const auto found = blocks_.find(keyOf(block));
        if (found == blocks_.end()) return std::nullopt;
        const float* node = found->second.data() + (cell[0] * nodes + cell[1]) * nodes + cell[2];
        const auto along = [&](int offset) { return node[offset] + t[2] * (node[offset + 1] - node[offset]); };
        const double a = along(0), b = along(nodes), c = along(nodes * nodes), d = along(nodes * nodes + nodes);
        const double low = a + t[1] * (b - a), high = c + t[1] * (d - c);
        const auto rise = [&](int offset) { return node[offset + 1] - node[offset]; };
        const double z0 = rise(0) + t[1] * (rise(nodes) - rise(0));
        const double z1 = rise(nodes * nodes) + t[1] * (rise(nodes * nodes + nodes) - rise(nodes * nodes));
        const Vec3 slope{high - low, (b - a) + t[0] * ((d - c) - (b - a)), z0 + t[0] * (z1 - z0)};
        return Nearest{low + t[0] * (high - low), normalized(slope)};
    }

    /// Made anew: every node near skin that moves has another distance.
    void moveTo(std::span<const Vec3> vertices) override {
        body_.moveTo(vertices);
        blocks_.clear();
        grow();
    }
    /// Without the hierarchy that it is made from.
    [[nodiscard]] std::size_t bytes() const override {
        return blocks_.size() * (sizeof(Block) + 4 * sizeof(void*)) + blocks_.bucket_count() * sizeof(void*);
    }

private:
    static constexpr int nodes = 9;
    using Block = std::array<float, nodes * nodes * nodes>;

    static std::uint64_t keyOf(const std::array<int, 3>& block) {
        std::uint64_t key = 0;
        for (const int i : block) key = key << 21 | static_cast<std::uint64_t>(i + (1 << 20));
        return key;
    }

    /// All blocks that reach into the band round a corner of the body, whose edges are shorter than the band is wide.
    void grow() {
        for (const Vec3& corner : body_.mesh().vertices) growAround(corner);
    }

    void growAround(const Vec3& corner) {
        const double size = 8 * spacing_;
        std::array<int, 3> low{}, high{}, at{};
        for (int axis = 0; axis < 3; ++axis) {
            low[axis] = static_cast<int>(std::floor((corner[axis] - band_) / size));
            high[axis] = static_cast<int>(std::floor((corner[axis] + band_) / size));
        }
        for (at[0] = low[0]; at[0] <= high[0]; ++at[0])
            for (at[1] = low[1]; at[1] <= high[1]; ++at[1])
                for (at[2] = low[2]; at[2] <= high[2]; ++at[2])
                    if (const auto [block, isNew] = blocks_.try_emplace(keyOf(at)); isNew) fill(block->second, at);
    }

    void fill(Block& block, const std::array<int, 3>& at) const {
        double radius = 1e9; // from node to node the distance changes by no more than the way
        float* node = block.data();
        for (int i = 0; i < nodes; ++i)
            for (int j = 0; j < nodes; ++j)
                for (int k = 0; k < nodes; ++k) {
                    const Vec3 p{8.0 * at[0] + i, 8.0 * at[1] + j, 8.0 * at[2] + k};
                    const double distance = body_.nearest(p * spacing_, radius)->signedDistance;
                    radius = std::abs(distance) + (k + 1 < nodes ? 1.01 : 15) * spacing_;
                    *node++ = static_cast<float>(distance);
                }
    }

    collision::BodySurface body_;
    double spacing_, band_;
    std::unordered_map<std::uint64_t, Block> blocks_;
};

} // namespace toile::bench
