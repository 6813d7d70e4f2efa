// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pattern/Crossings.h"

#include <algorithm>

namespace toile::pattern {
namespace {

bool follow(const BorderSegment& p, const BorderSegment& q, const std::vector<std::size_t>& loopLengths) {
    if (p.loop != q.loop) return false;
    const std::size_t n = loopLengths[static_cast<std::size_t>(p.loop)];
    return (p.order + 1) % n == q.order || (q.order + 1) % n == p.order;
}

/// Two segments in a row may share their joint, but not run back over each other.
bool foldBack(const BorderSegment& p, const BorderSegment& q) {
    const Vec2 d = p.b - p.a, e = q.b - q.a;
    return cross(d, e) == 0 && dot(d, e) < 0;
}

} // namespace

std::optional<Vec2> meeting(const BorderSegment& p, const BorderSegment& q) {
    const Vec2 d = p.b - p.a, e = q.b - q.a;
    const double denominator = cross(d, e);
    if (denominator != 0) {
        const double s = cross(q.a - p.a, e) / denominator, t = cross(q.a - p.a, d) / denominator;
        if (s < 0 || s > 1 || t < 0 || t > 1) return std::nullopt;
        return geometry::lerp(p.a, p.b, s);
    }
    if (cross(q.a - p.a, d) != 0) return std::nullopt; // parallel
    for (const Vec2 end : {q.a, q.b})                  // on one line: does an end of one lie on the other?
        if (dot(end - p.a, end - p.b) <= 0) return end;
    for (const Vec2 end : {p.a, p.b})
        if (dot(end - q.a, end - q.b) <= 0) return end;
    return std::nullopt;
}

std::optional<Crossing> firstCrossing(std::vector<BorderSegment> segments,
                                      const std::vector<std::size_t>& loopLengths) {
    const auto left = [](const BorderSegment& s) { return std::min(s.a.x, s.b.x); };
    const auto right = [](const BorderSegment& s) { return std::max(s.a.x, s.b.x); };
    std::ranges::sort(segments, {}, left);
    std::vector<const BorderSegment*> open; // those that reach the sweep line
    for (const BorderSegment& now : segments) {
        std::erase_if(open, [&](const BorderSegment* s) { return right(*s) < left(now); });
        for (const BorderSegment* other : open) {
            if (std::max(other->a.y, other->b.y) < std::min(now.a.y, now.b.y) ||
                std::max(now.a.y, now.b.y) < std::min(other->a.y, other->b.y))
                continue;
            if (follow(*other, now, loopLengths)) {
                if (foldBack(*other, now)) return Crossing{*other, now, other->b == now.a ? now.a : now.b};
            } else if (const auto point = meeting(*other, now)) return Crossing{*other, now, *point};
        }
        open.push_back(&now);
    }
    return std::nullopt;
}

std::optional<Crossing> firstCrossing(const geometry::Polygon& polygon) {
    std::vector<BorderSegment> segments;
    for (std::size_t i = 0; i < polygon.size(); ++i)
        segments.push_back({polygon[i], polygon[(i + 1) % polygon.size()], 0, i, i});
    return firstCrossing(std::move(segments), {polygon.size()});
}

} // namespace toile::pattern
