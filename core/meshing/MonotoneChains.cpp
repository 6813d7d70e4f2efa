// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/meshing/MonotoneChains.h"

#include <algorithm>

namespace toile::meshing {
namespace {

constexpr std::size_t mostChains = 400; ///< all pairs of boxes are compared

class Search {
public:
    explicit Search(std::span<const RingSegment> segments) : segments_(segments) {}

    [[nodiscard]] bool cross(const MonotoneChain& a, const MonotoneChain& b) const {
        const GridPoint a0 = start(a), a1 = end(a), b0 = start(b), b1 = end(b);
        if (std::max(a0.x, a1.x) < std::min(b0.x, b1.x) || std::max(b0.x, b1.x) < std::min(a0.x, a1.x) ||
            std::max(a0.y, a1.y) < std::min(b0.y, b1.y) || std::max(b0.y, b1.y) < std::min(a0.y, a1.y))
            return false;
        const int sizeA = a.last - a.first, sizeB = b.last - b.first;
        if (sizeA == 1 && sizeB == 1) return segmentsClash(segment(a.first), segment(b.first));
        const MonotoneChain& longer = sizeA >= sizeB ? a : b;
        const MonotoneChain& other = sizeA >= sizeB ? b : a;
        const int middle = longer.first + (longer.last - longer.first) / 2;
        return cross({longer.first, middle}, other) || cross({middle, longer.last}, other);
    }

private:
    [[nodiscard]] const RingSegment& segment(int i) const { return segments_[static_cast<std::size_t>(i)]; }
    [[nodiscard]] GridPoint start(const MonotoneChain& chain) const { return segment(chain.first).a; }
    [[nodiscard]] GridPoint end(const MonotoneChain& chain) const { return segment(chain.last - 1).b; }

    std::span<const RingSegment> segments_;
};

} // namespace

std::pmr::vector<MonotoneChain> monotoneChains(std::span<const RingSegment> segments, Arena& arena) {
    std::pmr::vector<MonotoneChain> chains(&arena);
    int x = 0, y = 0; // the way the chain in hand goes; 0 = either
    for (int i = 0; i < static_cast<int>(segments.size()); ++i) {
        const RingSegment& segment = segments[static_cast<std::size_t>(i)];
        const int dx = (segment.b.x > segment.a.x) - (segment.b.x < segment.a.x);
        const int dy = (segment.b.y > segment.a.y) - (segment.b.y < segment.a.y);
        const bool goesOn = !chains.empty() && segment.index > 0 && dx * x >= 0 && dy * y >= 0;
        if (goesOn) {
            chains.back().last = i + 1;
            if (x == 0) x = dx;
            if (y == 0) y = dy;
        } else {
            chains.push_back({i, i + 1});
            x = dx;
            y = dy;
        }
    }
    return chains;
}

std::optional<bool> chainsCross(std::span<const RingSegment> segments, Arena& arena) {
    const auto chains = monotoneChains(segments, arena);
    if (chains.size() > mostChains) return std::nullopt;
    const Search search(segments);
    for (std::size_t i = 0; i < chains.size(); ++i)
        for (std::size_t j = i + 1; j < chains.size(); ++j)
            if (search.cross(chains[i], chains[j])) return true;
    return false;
}

} // namespace toile::meshing
