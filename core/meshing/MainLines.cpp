// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/meshing/MainLines.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace toile::meshing {
namespace {

double along(Vec2 point, int axis) {
    return axis == 0 ? point.x : point.y;
}

/// Straight boundary on one coordinate: where and how long.
struct StraightLine {
    double at = 0, length = 0; ///< [m]
};

/// The grain-parallel straight edges of one axis, joined by coordinate, longest first. Axis 0: x is constant.
std::vector<StraightLine> grainParallelLines(const PieceInput& piece, const PieceFrame& frame, int axis) {
    std::vector<StraightLine> lines;
    for (int loop = 0; loop < loopCount(piece); ++loop)
        for (const BoundaryEdge& edge : loopOf(piece, loop)) {
            if (!std::holds_alternative<geometry::LineShape>(edge.curve.shape)) continue;
            const Vec2 a = frame.frameOf(edge.curve.start), b = frame.frameOf(edge.curve.end);
            const Vec2 along = axis == 0 ? b - a : Vec2{b.y - a.y, b.x - a.x};
            if (std::abs(along.x) > 2 * frame.unit || std::abs(along.y) <= 4 * frame.unit) continue;
            const double at = 0.5 * (axis == 0 ? a.x + b.x : a.y + b.y);
            const auto same = std::find_if(lines.begin(), lines.end(), [&](const StraightLine& line) {
                return std::abs(line.at - at) <= 2 * frame.unit;
            });
            if (same == lines.end())
                lines.push_back({at, std::abs(along.y)});
            else
                same->length += std::abs(along.y);
        }
    std::sort(lines.begin(), lines.end(), [&](const StraightLine& a, const StraightLine& b) {
        return std::abs(a.length - b.length) > frame.unit ? a.length > b.length : a.at < b.at;
    });
    return lines;
}

int partsOf(double distance, double spacing) {
    return std::max(1, static_cast<int>(std::ceil(distance / spacing - 1e-9)));
}

/// The second longest line that is far enough away for whole intervals to suit the spacing.
std::optional<double> partnerOf(const std::vector<StraightLine>& lines, double extent, double spacing) {
    for (std::size_t i = 1; i < lines.size(); ++i) {
        const double distance = std::abs(lines[i].at - lines[0].at);
        if (distance >= 3 * spacing || distance >= 0.99 * extent) return lines[i].at;
    }
    return std::nullopt;
}

/// Equal intervals that cover low … high and one more on each side, with a line at `anchor`.
std::vector<double> evenLines(double anchor, double interval, double low, double high) {
    const int first = static_cast<int>(std::floor((low - anchor) / interval - 1e-6)) - 1;
    const int last = static_cast<int>(std::ceil((high - anchor) / interval + 1e-6)) + 1;
    std::vector<double> lines;
    for (int k = first; k <= last; ++k) lines.push_back(anchor + k * interval);
    return lines;
}

/// Evenly spaced lines, by one of them and their distance.
struct EvenSpacing {
    double anchor = 0, interval = 0;
};

bool onLine(const EvenSpacing& spacing, double at, double tolerance) {
    const double steps = (at - spacing.anchor) / spacing.interval;
    return std::abs(steps - std::round(steps)) * spacing.interval <= tolerance;
}

/// A grain-parallel straight edge by its ends along the axis of which lines are sought.
struct StraightSpan {
    double low = 0, high = 0;
};

std::vector<StraightSpan> grainParallelSpans(const PieceInput& piece, const PieceFrame& frame, int axis) {
    std::vector<StraightSpan> spans;
    for (int loop = 0; loop < loopCount(piece); ++loop)
        for (const BoundaryEdge& edge : loopOf(piece, loop)) {
            if (!std::holds_alternative<geometry::LineShape>(edge.curve.shape)) continue;
            const Vec2 a = frame.frameOf(edge.curve.start), b = frame.frameOf(edge.curve.end);
            if (std::abs(along(b - a, 1 - axis)) > 2 * frame.unit) continue;
            const double low = std::min(along(a, axis), along(b, axis)),
                         high = std::max(along(a, axis), along(b, axis));
            if (high - low >= piece.spacing) spans.push_back({low, high});
        }
    return spans;
}

/// Metres of border whose nodes such lines would carry: edges along the lines, and edges across them that are
/// divided where the lines cross.
double carried(const EvenSpacing& spacing, const std::vector<StraightLine>& lines,
               const std::vector<StraightSpan>& spans, double wanted, double tolerance) {
    double length = 0;
    for (const StraightLine& line : lines)
        if (onLine(spacing, line.at, tolerance)) length += line.length;
    for (const StraightSpan& span : spans)
        if (onLine(spacing, span.low, tolerance) && onLine(spacing, span.high, tolerance) &&
            std::lround((span.high - span.low) / spacing.interval) == partsOf(span.high - span.low, wanted))
            length += span.high - span.low;
    return length;
}

/// h = W/⌈W/ε⌉ with lines on the two longest grain-parallel edges, or at the nodes of an edge across,
/// whichever carries more of the border; else the phase of the longest edge; else symmetric.
std::vector<double> regularLines(const std::vector<StraightLine>& straight,
                                 const std::vector<StraightSpan>& spans, double low, double high,
                                 double spacing, double tolerance) {
    std::vector<EvenSpacing> candidates;
    if (!straight.empty()) {
        if (const auto partner = partnerOf(straight, high - low, spacing)) {
            const double width = std::abs(*partner - straight.front().at);
            candidates.push_back({std::min(*partner, straight.front().at), width / partsOf(width, spacing)});
        }
        candidates.push_back({straight.front().at, spacing});
    }
    for (const StraightSpan& span : spans)
        candidates.push_back({span.low, (span.high - span.low) / partsOf(span.high - span.low, spacing)});
    if (candidates.empty()) {
        const bool even = partsOf(high - low, spacing) % 2 == 0;
        candidates.push_back({0.5 * (low + high) - (even ? 0 : 0.5 * spacing), spacing});
    }
    EvenSpacing best = candidates.front();
    double most = -1;
    for (const EvenSpacing& candidate : candidates) {
        const double length = carried(candidate, straight, spans, spacing, tolerance);
        if (length <= most + tolerance) continue;
        most = length;
        best = candidate;
    }
    std::vector<double> lines = evenLines(best.anchor, best.interval, low, high);
    for (double& line : lines) // an edge's own coordinate, free of rounding
        for (const StraightLine& edge : straight)
            if (std::abs(line - edge.at) < 0.25 * tolerance) line = edge.at;
    return lines;
}

/// A coordinate that asks for a line, the stronger the more.
struct Wish {
    double at = 0;
    int weight = 1;
};

/// Lines at the wishes, in equal parts between them; wishes nearer than `merge` to a stronger one are
/// dropped.
std::vector<double> linesThrough(std::vector<Wish> wishes, double merge, double spacing, double low,
                                 double high) {
    std::sort(wishes.begin(), wishes.end(), [](const Wish& a, const Wish& b) { return a.at < b.at; });
    std::vector<Wish> kept;
    for (const Wish& wish : wishes) {
        if (kept.empty() || wish.at - kept.back().at >= merge)
            kept.push_back(wish);
        else if (wish.weight > kept.back().weight)
            kept.back() = wish;
    }
    if (kept.empty()) return evenLines(low, spacing, low, high);
    std::vector<double> lines = evenLines(kept.front().at, spacing, low, kept.front().at);
    std::erase_if(lines, [&](double line) { return line > kept.front().at - 0.5 * spacing; });
    for (std::size_t i = 0; i + 1 < kept.size(); ++i) {
        const double gap = kept[i + 1].at - kept[i].at;
        const int parts = partsOf(gap, spacing);
        for (int k = 0; k < parts; ++k) lines.push_back(kept[i].at + gap * k / parts);
    }
    for (double line = kept.back().at; line < high + 1.5 * spacing; line += spacing) lines.push_back(line);
    lines.push_back(lines.back() + spacing);
    return lines;
}

/// The grain-parallel straight parts of the painted borders; short ones are brush strokes, not borders.
void addRegionLines(const PieceInput& piece, const PieceFrame& frame, int axis, std::vector<Wish>& wishes) {
    const auto addPolygon = [&](const Polygon& polygon) {
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            const Vec2 a = frame.frameOf(polygon[i]), b = frame.frameOf(polygon[(i + 1) % polygon.size()]);
            if (std::abs(along(b - a, axis)) <= 2 * frame.unit &&
                std::abs(along(b - a, 1 - axis)) >= 0.5 * piece.spacing)
                wishes.push_back({0.5 * along(a + b, axis), 2});
        }
    };
    for (const RegionInput& region : piece.regions) {
        addPolygon(region.outline);
        for (const Polygon& hole : region.holes) addPolygon(hole);
    }
}

std::vector<double> exactBorderLines(const std::vector<StraightLine>& straight, std::vector<Wish> wishes,
                                     double low, double high, double spacing) {
    if (!straight.empty()) {
        wishes.push_back({straight.front().at, 3});
        if (const auto partner = partnerOf(straight, high - low, spacing)) wishes.push_back({*partner, 3});
    }
    return linesThrough(std::move(wishes), spacing / 4, spacing, low, high);
}

/// Corners that turn by more than 15°, notches and seam ends; region corners.
void addFeatures(const PieceInput& piece, const PieceBoundary& boundary, const std::vector<Vec2>& seamEnds,
                 int axis, std::vector<Wish>& wishes) {
    const double sharp = std::cos(15 * std::numbers::pi / 180);
    for (int loop = 0; loop < loopCount(piece); ++loop) {
        const BoundaryLoop& edges = loopOf(piece, loop);
        for (std::size_t e = 0; e < edges.size(); ++e) {
            const Curve &curve = edges[e].curve, &next = edges[(e + 1) % edges.size()].curve;
            const Vec2 in = geometry::tangentAt(curve, 1), out = geometry::tangentAt(next, 0);
            if (dot(in, out) < sharp * length(in) * length(out))
                wishes.push_back({along(boundary.frame.frameOf(curve.end), axis), 2});
            for (const double notch : edges[e].notches)
                wishes.push_back(
                    {along(boundary.frame.frameOf(
                               boundary.loops[static_cast<std::size_t>(loop)].edges[e].arc.pointAt(notch)),
                           axis),
                     1});
        }
    }
    for (const Vec2 end : seamEnds) wishes.push_back({along(end, axis), 1});
    for (const RegionInput& region : piece.regions)
        for (const Vec2 corner : region.outline)
            wishes.push_back({along(boundary.frame.frameOf(corner), axis), 1});
}

void addAuthoredVertices(const PieceInput& piece, const PieceFrame& frame, int axis,
                         std::vector<Wish>& wishes) {
    for (int loop = 0; loop < loopCount(piece); ++loop)
        for (const BoundaryEdge& edge : loopOf(piece, loop))
            wishes.push_back({along(frame.frameOf(edge.curve.start), axis), 1});
}

std::vector<double> linesOfAxis(const PieceInput& piece, const PieceBoundary& boundary,
                                const std::vector<Vec2>& seamEnds, int axis) {
    const double low = along(boundary.box.low, axis), high = along(boundary.box.high, axis),
                 spacing = piece.spacing;
    std::vector<Wish> wishes;
    if (piece.rule == LineRule::paper) {
        addAuthoredVertices(piece, boundary.frame, axis, wishes);
        const double least =
            std::max(16 * boundary.frame.unit, 1e-5 * spacing); // lines no nearer than the grid can tell
        return linesThrough(std::move(wishes), least, spacing, low, high);
    }
    const std::vector<StraightLine> straight = grainParallelLines(piece, boundary.frame, axis);
    if (piece.border == RegionBorder::exact) addRegionLines(piece, boundary.frame, axis, wishes);
    if (piece.rule == LineRule::features) {
        addFeatures(piece, boundary, seamEnds, axis, wishes);
        return linesThrough(std::move(wishes), spacing / 4, spacing, low, high);
    }
    if (wishes.empty()) // the rule `regular`
        return regularLines(straight, grainParallelSpans(piece, boundary.frame, axis), low, high, spacing,
                            2 * boundary.frame.unit);
    return exactBorderLines(straight, std::move(wishes), low, high, spacing);
}

/// Draws lines far outside the piece near, so that the integer grid holds them.
std::vector<double> within(std::vector<double> lines, double low, double high, double reach) {
    for (double& line : lines) line = std::clamp(line, low - reach, high + reach);
    lines.erase(std::unique(lines.begin(), lines.end()), lines.end());
    return lines;
}

} // namespace

MainLines mainLines(const PieceInput& piece, const PieceBoundary& boundary,
                    const std::vector<Vec2>& seamEnds) {
    const geometry::Box2& box = boundary.box;
    const double reach = distance(box.low, box.high);
    return {within(linesOfAxis(piece, boundary, seamEnds, 0), box.low.x, box.high.x, reach),
            within(linesOfAxis(piece, boundary, seamEnds, 1), box.low.y, box.high.y, reach)};
}

} // namespace toile::meshing
