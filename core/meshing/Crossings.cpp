// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/meshing/Crossings.h"

#include "core/meshing/MonotoneChains.h"

#include <algorithm>

namespace toile::meshing {
namespace {

struct GridBox {
    std::int64_t lowX, lowY, highX, highY;
};

bool touches(const RingSegment& s, const GridBox& box) {
    return std::max(s.a.x, s.b.x) >= box.lowX && std::min(s.a.x, s.b.x) <= box.highX &&
           std::max(s.a.y, s.b.y) >= box.lowY && std::min(s.a.y, s.b.y) <= box.highY;
}

bool follows(const RingSegment& s, const RingSegment& t) {
    return s.ring == t.ring && (s.index + 1) % s.ringSize == t.index;
}

class CrossingSearch {
public:
    CrossingSearch(std::span<const RingSegment> segments, Arena& arena)
        : segments_(segments), arena_(arena), found_(&arena) {}

    std::pmr::vector<std::pair<int, int>> run() {
        std::pmr::vector<int> all(segments_.size(), &arena_);
        GridBox box{0, 0, 0, 0};
        for (std::size_t i = 0; i < all.size(); ++i) {
            all[i] = static_cast<int>(i);
            for (const GridPoint p : {segments_[i].a, segments_[i].b})
                box = {std::min<std::int64_t>(box.lowX, p.x), std::min<std::int64_t>(box.lowY, p.y),
                       std::max<std::int64_t>(box.highX, p.x), std::max<std::int64_t>(box.highY, p.y)};
        }
        search(all, box, 0);
        std::sort(found_.begin(), found_.end());
        found_.erase(std::unique(found_.begin(), found_.end()), found_.end());
        return std::move(found_);
    }

private:
    void search(std::span<const int> members, const GridBox& box, int depth) {
        constexpr std::size_t few = 12;
        constexpr int deepest = 48;
        if (members.size() <= few || depth >= deepest) return compareAll(members);
        const bool wide = box.highX - box.lowX >= box.highY - box.lowY;
        GridBox low = box, high = box;
        if (wide) low.highX = high.lowX = (box.lowX + box.highX) / 2;
        else low.highY = high.lowY = (box.lowY + box.highY) / 2;
        const std::pmr::vector<int> lower = within(members, low), upper = within(members, high);
        const std::size_t most = members.size() - members.size() / 8;
        if (lower.size() > most && upper.size() > most) return compareAll(members);
        search(lower, low, depth + 1);
        search(upper, high, depth + 1);
    }

    [[nodiscard]] std::pmr::vector<int> within(std::span<const int> members, const GridBox& box) const {
        std::pmr::vector<int> inside(&arena_);
        inside.reserve(members.size());
        for (const int i : members)
            if (touches(segments_[static_cast<std::size_t>(i)], box)) inside.push_back(i);
        return inside;
    }

    void compareAll(std::span<const int> members) {
        for (std::size_t i = 0; i < members.size(); ++i)
            for (std::size_t j = i + 1; j < members.size(); ++j)
                if (segmentsClash(segments_[static_cast<std::size_t>(members[i])],
                                  segments_[static_cast<std::size_t>(members[j])]))
                    found_.emplace_back(members[i], members[j]);
    }

    std::span<const RingSegment> segments_;
    Arena& arena_;
    std::pmr::vector<std::pair<int, int>> found_;
};

} // namespace

bool segmentsClash(const RingSegment& s, const RingSegment& t) {
    if (follows(t, s) && !follows(s, t)) return segmentsClash(t, s);
    if (follows(s, t)) { // s.b = t.a is allowed, lying on one another is not
        if (s.ringSize == 2) return true;
        return onSegment(s.a, s.b, t.b) || onSegment(t.a, t.b, s.a);
    }
    return segmentsMeet(s.a, s.b, t.a, t.b);
}

std::pmr::vector<std::pair<int, int>> allCrossings(std::span<const RingSegment> segments, Arena& arena) {
    if (const auto crosses = chainsCross(segments, arena); crosses && !*crosses)
        return std::pmr::vector<std::pair<int, int>>(&arena);
    return CrossingSearch(segments, arena).run();
}

std::optional<std::pair<int, int>> firstCrossing(std::span<const RingSegment> segments, Arena& arena) {
    const auto all = allCrossings(segments, arena);
    if (all.empty()) return std::nullopt;
    return all.front();
}

void appendSegments(std::span<const GridPoint> ring, int number, std::pmr::vector<RingSegment>& segments) {
    for (std::size_t i = 0; i < ring.size(); ++i)
        segments.push_back(
            {ring[i], ring[(i + 1) % ring.size()], number, static_cast<int>(i), static_cast<int>(ring.size()), 0});
}

bool isInside(std::span<const GridPoint> ring, GridPoint point) {
    bool inside = false;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const GridPoint a = ring[i], b = ring[(i + 1) % ring.size()];
        if ((a.y <= point.y) == (b.y <= point.y)) continue;
        const std::int64_t side = orientation(a, b, point);
        if ((a.y <= point.y) == (side > 0)) inside = !inside;
    }
    return inside;
}

} // namespace toile::meshing
