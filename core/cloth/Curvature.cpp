// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cloth/Curvature.h"

#include <algorithm>
#include <array>
#include <optional>

namespace toile::cloth {
namespace {

/// Neighbours of a node on its lines; −1 = none.
struct Neighbours {
    std::array<int, 2> weft{-1, -1}, warp{-1, -1}; ///< in direction −, +
    [[nodiscard]] bool isInner() const { return std::min({weft[0], weft[1], warp[0], warp[1]}) >= 0; }
};

std::vector<Neighbours> neighboursOf(const Patch& patch) {
    std::vector<Neighbours> neighbours(patch.material.size());
    for (const PatchRectangle& cell : patch.rectangles) {
        const auto& n = cell.nodes; // −−, +−, ++, −+
        for (const auto& [from, to] : {std::array{n[0], n[1]}, std::array{n[3], n[2]}}) {
            neighbours[from].weft[1] = to;
            neighbours[to].weft[0] = from;
        }
        for (const auto& [from, to] : {std::array{n[0], n[3]}, std::array{n[1], n[2]}}) {
            neighbours[from].warp[1] = to;
            neighbours[to].warp[0] = from;
        }
    }
    return neighbours;
}

class Lines {
public:
    Lines(const Patch& patch, std::span<const Vec3> positions)
        : patch_(patch), positions_(positions), neighbours_(neighboursOf(patch)) {}

    void append(std::vector<Curvature>& out, std::array<int, 2> Neighbours::*line) const {
        std::vector<std::optional<double>> values(neighbours_.size());
        for (std::size_t n = 0; n < values.size(); ++n)
            if (neighbours_[n].isInner()) values[n] = curvatureAt(static_cast<int>(n), neighbours_[n].*line);
        for (std::size_t n = 0; n < values.size(); ++n) {
            if (!values[n]) continue;
            const auto& [before, after] = neighbours_[n].*line;
            if (!values[before] || !values[after]) continue;
            out.push_back({*values[n], *values[n] / 2 - (*values[before] + *values[after]) / 4, areaOf(neighbours_[n]),
                           static_cast<int>(n)});
        }
    }

private:
    [[nodiscard]] const Vec3& at(int node) const { return positions_[patch_.particles[node]]; }
    [[nodiscard]] double gap(int a, int b) const { return distance(patch_.material[a], patch_.material[b]); }

    [[nodiscard]] double curvatureAt(int node, std::array<int, 2> ends) const {
        const Neighbours& around = neighbours_[node];
        const Vec3 normal = cross(at(around.weft[1]) - at(around.weft[0]), at(around.warp[1]) - at(around.warp[0]));
        const double size = length(normal), before = gap(node, ends[0]), after = gap(node, ends[1]);
        if (size == 0) return 0; // folded up to nothing: bent, but to neither side
        const Vec3 bend = (at(ends[1]) - at(node)) / after - (at(node) - at(ends[0])) / before;
        return 2 / (before + after) * dot(bend, normal) / size;
    }
    [[nodiscard]] double areaOf(const Neighbours& n) const {
        return gap(n.weft[0], n.weft[1]) * gap(n.warp[0], n.warp[1]) / 4;
    }

    const Patch& patch_;
    std::span<const Vec3> positions_;
    std::vector<Neighbours> neighbours_;
};

} // namespace

std::vector<Curvature> curvatures(const Patch& patch, std::span<const Vec3> positions) {
    std::vector<Curvature> all;
    const Lines lines(patch, positions);
    lines.append(all, &Neighbours::weft);
    lines.append(all, &Neighbours::warp);
    return all;
}

} // namespace toile::cloth
