// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/meshing/MainLines.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace toile::meshing {
namespace {

using Lines = std::pmr::vector<double>; ///< rising coordinates

/// The second longest line that is far enough away for whole intervals to suit the spacing.
std::optional<double> partnerOf(std::span<const LineWish> lines, double extent, double spacing) {
    for (std::size_t i = 1; i < lines.size(); ++i) {
        const double distance = std::abs(lines[i].at - lines[0].at);
        if (distance >= 3 * spacing || distance >= 0.99 * extent) return lines[i].at;
    }
    return std::nullopt;
}

struct LineSettings {
    double spacing = 0.02;  ///< ε_m [m]
    double tolerance = 0;   ///< coordinates this near are one [m]
    double mostParts = 1.5; ///< a stretch may ask for so many times the lines that the spacing asks for [–]
};

/// Equal intervals that cover low … high and one more on each side, with a line at `anchor`.
Lines evenLines(double anchor, double interval, double low, double high, Arena& arena) {
    const int first = static_cast<int>(std::floor((low - anchor) / interval - 1e-6)) - 1;
    const int last = static_cast<int>(std::ceil((high - anchor) / interval + 1e-6)) + 1;
    Lines lines(&arena);
    lines.reserve(static_cast<std::size_t>(std::max(0, last - first + 1)));
    for (int k = first; k <= last; ++k) lines.push_back(anchor + k * interval);
    return lines;
}

/// Lines at `places` and in equal parts between them, as the nodes of stretches lie; on beyond both ends.
Lines linesThroughNodes(std::span<const double> places, std::span<const GrainStretch> stretches, double low,
                        double high, const LineSettings& settings, Arena& arena) {
    Lines inner(&arena);
    const double most = settings.mostParts * ((places.back() - places.front()) / settings.spacing + 1);
    inner.reserve(static_cast<std::size_t>(most) + 2 * places.size());
    double firstGap = settings.spacing, lastGap = settings.spacing;
    for (std::size_t i = 0; i + 1 < places.size(); ++i) {
        const double gap = places[i + 1] - places[i];
        const int natural = partsOf(gap, settings.spacing);
        int parts = natural;
        for (const GrainStretch& stretch : stretches)
            if (std::abs(stretch.low - places[i]) <= settings.tolerance &&
                std::abs(stretch.high - places[i + 1]) <= settings.tolerance &&
                stretch.parts <= settings.mostParts * natural)
                parts = std::max(parts, stretch.parts);
        for (int k = 0; k < parts; ++k) inner.push_back(places[i] + gap * k / parts);
        lastGap = gap / parts;
        if (i == 0) firstGap = lastGap;
    }
    Lines lines = evenLines(places.front(), firstGap, low, places.front(), arena);
    std::erase_if(lines, [&](double line) { return line > places.front() - 0.5 * firstGap; });
    const Lines beyond = evenLines(places.back(), lastGap, places.back(), high, arena);
    lines.reserve(lines.size() + inner.size() + beyond.size());
    lines.insert(lines.end(), inner.begin(), inner.end());
    for (const double line : beyond)
        if (line > places.back() - 0.5 * lastGap) lines.push_back(line);
    return lines;
}

/// The index of the line at a coordinate, or −1.
std::ptrdiff_t lineAt(std::span<const double> lines, double at, double tolerance) {
    const auto found = std::lower_bound(lines.begin(), lines.end(), at - tolerance);
    return found != lines.end() && *found <= at + tolerance ? found - lines.begin() : -1;
}

/// Every node of the stretch lies on a line, and every line that crosses it meets a node.
bool carries(std::span<const double> lines, const GrainStretch& stretch, double tolerance) {
    const std::ptrdiff_t first = lineAt(lines, stretch.low, tolerance), last = lineAt(lines, stretch.high, tolerance);
    if (first < 0 || last - first != stretch.parts) return false;
    for (std::ptrdiff_t k = 1; k < stretch.parts; ++k) {
        const double node = stretch.low + (stretch.high - stretch.low) * static_cast<double>(k) / stretch.parts;
        if (std::abs(lines[static_cast<std::size_t>(first + k)] - node) > tolerance) return false;
    }
    return true;
}

/// Metres of border whose nodes such lines would carry: edges along the lines, and edges across them that are
/// divided where the lines cross.
double carried(std::span<const double> lines, std::span<const LineWish> straight,
               std::span<const GrainStretch> stretches, double tolerance) {
    double length = 0;
    for (const LineWish& line : straight)
        if (lineAt(lines, line.at, tolerance) >= 0) length += line.weight;
    for (const GrainStretch& stretch : stretches)
        if (carries(lines, stretch, tolerance)) length += stretch.high - stretch.low;
    return length;
}

/// Even lines at h = W/⌈W/ε⌉ with lines on the two longest grain-parallel edges, or at the nodes of a stretch
/// across; or lines through the fixed points of all stretches, in equal parts between them: whichever carries
/// most of the border, even lines first. Without straight edges they are laid symmetrically.
Lines regularLines(std::span<const LineWish> straight, std::span<const GrainStretch> stretches,
                   std::span<const double> places, double low, double high, const LineSettings& settings,
                   Arena& arena) {
    constexpr std::size_t enough = 40; // candidates; a comb has as many stretches as teeth
    const double spacing = settings.spacing;
    std::pmr::vector<Lines> candidates(&arena);
    candidates.reserve(enough + 1);
    const auto addEven = [&](double anchor, double interval) {
        if (candidates.size() < enough) candidates.push_back(evenLines(anchor, interval, low, high, arena));
    };
    if (!straight.empty()) {
        if (const auto partner = partnerOf(straight, high - low, spacing)) {
            const double width = std::abs(*partner - straight.front().at);
            addEven(std::min(*partner, straight.front().at), width / partsOf(width, spacing));
        }
        addEven(straight.front().at, spacing);
    }
    for (const GrainStretch& stretch : stretches)
        addEven(stretch.low, (stretch.high - stretch.low) / partsOf(stretch.high - stretch.low, spacing));
    if (places.size() > 1) candidates.push_back(linesThroughNodes(places, stretches, low, high, settings, arena));
    if (candidates.empty()) {
        const bool even = partsOf(high - low, spacing) % 2 == 0;
        addEven(0.5 * (low + high) - (even ? 0 : 0.5 * spacing), spacing);
    }
    std::size_t best = 0;
    double most = -1;
    for (std::size_t i = 0; i < candidates.size(); ++i) {
        const double length = carried(candidates[i], straight, stretches, settings.tolerance);
        if (length <= most + settings.tolerance) continue;
        most = length;
        best = i;
    }
    Lines lines = std::move(candidates[best]);
    for (const LineWish& edge : straight) // an edge's own coordinate, free of rounding
        if (const auto line = lineAt(lines, edge.at, 0.25 * settings.tolerance); line >= 0)
            lines[static_cast<std::size_t>(line)] = edge.at;
    return lines;
}

/// A coordinate that asks for a line, the stronger the more.
struct Wish {
    double at = 0;
    int weight = 1;
};

/// Lines at the wishes, in equal parts between them; wishes nearer than `merge` to a stronger one are
/// dropped.
Lines linesThrough(std::pmr::vector<Wish> wishes, double merge, double spacing, double low, double high, Arena& arena) {
    std::sort(wishes.begin(), wishes.end(), [](const Wish& a, const Wish& b) { return a.at < b.at; });
    std::pmr::vector<Wish> kept(&arena);
    for (const Wish& wish : wishes) {
        if (kept.empty() || wish.at - kept.back().at >= merge) kept.push_back(wish);
        else if (wish.weight > kept.back().weight) kept.back() = wish;
    }
    if (kept.empty()) return evenLines(low, spacing, low, high, arena);
    Lines lines = evenLines(kept.front().at, spacing, low, kept.front().at, arena);
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
void addRegionLines(const PieceInput& piece, const PieceFrame& frame, int axis, std::pmr::vector<Wish>& wishes) {
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

Lines exactBorderLines(std::span<const LineWish> straight, std::pmr::vector<Wish> wishes, double low, double high,
                       double spacing, Arena& arena) {
    if (!straight.empty()) {
        wishes.push_back({straight.front().at, 3});
        if (const auto partner = partnerOf(straight, high - low, spacing)) wishes.push_back({*partner, 3});
    }
    return linesThrough(std::move(wishes), spacing / 4, spacing, low, high, arena);
}

/// Corners that turn by more than 15°, notches and seam ends; region corners.
void addFeatures(const PieceInput& piece, const PieceBoundary& boundary, std::span<const Vec2> seamEnds, int axis,
                 std::pmr::vector<Wish>& wishes) {
    const double sharp = std::cos(15 * std::numbers::pi / 180);
    for (int loop = 0; loop < loopCount(piece); ++loop) {
        const BoundaryLoop& edges = loopOf(piece, loop);
        for (std::size_t e = 0; e < edges.size(); ++e) {
            const Curve &curve = edges[e].curve, &next = edges[(e + 1) % edges.size()].curve;
            const Vec2 in = geometry::tangentAt(curve, 1), out = geometry::tangentAt(next, 0);
            if (dot(in, out) < sharp * length(in) * length(out))
                wishes.push_back({along(boundary.frame.frameOf(curve.end), axis), 2});
            const EdgeArc& edge = boundary.loops[static_cast<std::size_t>(loop)].edges[e];
            if (edge.collapsed) continue;
            for (const double notch : edges[e].notches)
                wishes.push_back({along(boundary.frame.frameOf(edge.arc.pointAt(notch)), axis), 1});
        }
    }
    for (const Vec2 end : seamEnds) wishes.push_back({along(end, axis), 1});
    for (const RegionInput& region : piece.regions)
        for (const Vec2 corner : region.outline) wishes.push_back({along(boundary.frame.frameOf(corner), axis), 1});
}

void addAuthoredVertices(const PieceInput& piece, const PieceFrame& frame, int axis, std::pmr::vector<Wish>& wishes) {
    for (int loop = 0; loop < loopCount(piece); ++loop)
        for (const BoundaryEdge& edge : loopOf(piece, loop))
            wishes.push_back({along(frame.frameOf(edge.curve.start), axis), 1});
}

Lines linesOfAxis(const PieceInput& piece, const PieceBoundary& boundary, std::span<const Vec2> seamEnds,
                  const GrainStretches& stretches, int axis, Arena& arena) {
    const double low = along(boundary.box.low, axis), high = along(boundary.box.high, axis), spacing = piece.spacing;
    std::pmr::vector<Wish> wishes(&arena);
    if (piece.rule == LineRule::paper) {
        addAuthoredVertices(piece, boundary.frame, axis, wishes);
        const double least =
            std::max(16 * boundary.frame.unit, 1e-5 * spacing); // lines no nearer than the grid can tell
        return linesThrough(std::move(wishes), least, spacing, low, high, arena);
    }
    const std::pmr::vector<LineWish> straight = grainLines(piece, boundary.frame, axis, arena);
    if (piece.border == RegionBorder::exact) addRegionLines(piece, boundary.frame, axis, wishes);
    if (piece.rule == LineRule::features) {
        addFeatures(piece, boundary, seamEnds, axis, wishes);
        return linesThrough(std::move(wishes), spacing / 4, spacing, low, high, arena);
    }
    if (wishes.empty()) { // the rule `regular`
        const auto& own = stretches[static_cast<std::size_t>(axis)];
        const double across = along(boundary.box.high - boundary.box.low, 1 - axis);
        return regularLines(straight, own, linePlaces(piece, boundary.frame, axis, own, arena), low, high,
                            {spacing, 2 * boundary.frame.unit, mostPartsAcross(across, spacing)}, arena);
    }
    return exactBorderLines(straight, std::move(wishes), low, high, spacing, arena);
}

/// Draws lines far outside the piece near, so that the integer grid holds them.
Lines within(Lines lines, double low, double high, double reach) {
    for (double& line : lines) line = std::clamp(line, low - reach, high + reach);
    lines.erase(std::unique(lines.begin(), lines.end()), lines.end());
    return lines;
}

} // namespace

MainLines mainLines(const PieceInput& piece, const PieceBoundary& boundary, std::span<const Vec2> seamEnds,
                    const GrainStretches& stretches, Arena& arena) {
    const geometry::Box2& box = boundary.box;
    const double reach = distance(box.low, box.high);
    return {within(linesOfAxis(piece, boundary, seamEnds, stretches, 0, arena), box.low.x, box.high.x, reach),
            within(linesOfAxis(piece, boundary, seamEnds, stretches, 1, arena), box.low.y, box.high.y, reach)};
}

} // namespace toile::meshing
