// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/meshing/FoldNodes.h"
#include "core/base/Index.h"

#include "core/meshing/Crossings.h"
#include "core/meshing/GrainSpans.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace toile::meshing {
namespace {

tl::unexpected<Error> refuse(const PieceInput& piece, const FoldInput& fold, const std::string& sentence) {
    return fail(ErrorCode::invalidInput, sentence, {.object = nameOf(piece) + ", fold \"" + fold.label + "\""});
}

/// Places where a fold turns by more than this are nodes.
const double sharp = std::cos(15 * std::numbers::pi / 180);

/// The border node at a fold's end: a fixed point of its edge, so that there is one.
int nodeAt(const BoundaryNodes& nodes, const FoldEndInput& end) {
    const EdgeNodes& edge = nodes.loops[at(end.loop)][at(end.edge)];
    return std::min_element(edge.begin(), edge.end(),
                            [&](const EdgeNode& a, const EdgeNode& b) {
                                return std::abs(a.fraction - end.fraction) < std::abs(b.fraction - end.fraction);
                            })
        ->node;
}

/// The corners of a fold in the frame, and between them the course of each leg.
std::vector<std::vector<Vec2>> legsOf(const std::vector<Vec2>& line) {
    std::vector<std::vector<Vec2>> legs{{line.front()}};
    for (std::size_t i = 1; i < line.size(); ++i) {
        legs.back().push_back(line[i]);
        if (i + 1 == line.size()) break;
        const Vec2 in = line[i] - line[i - 1], out = line[i + 1] - line[i];
        if (dot(in, out) < sharp * length(in) * length(out)) legs.push_back({line[i]});
    }
    return legs;
}

/// The finest cells that a leg passes through: how many of them a main cell has along each side.
int finestAlong(const Lattice& lattice, const std::vector<Vec2>& leg, double spacing) {
    int finest = 1;
    if (lattice.isUniform()) return finest;
    for (std::size_t i = 0; i + 1 < leg.size(); ++i) {
        const int steps = 2 * partsOf(distance(leg[i], leg[i + 1]), spacing);
        for (int k = 0; k <= steps; ++k) {
            const Vec2 place = lerp(leg[i], leg[i + 1], static_cast<double>(k) / steps);
            const int u = lattice.activeDivision(lattice.columnOf(place.x), lattice.rowOf(place.y));
            finest = std::max(finest, u);
        }
    }
    return finest;
}

/// Where the lines across a leg along the grain meet it, but for those too near its ends.
std::vector<Vec2> crossingsOf(Vec2 from, Vec2 to, const std::vector<double>& lines, int axis, double spacing) {
    std::vector<Vec2> crossings;
    const double start = along(from, axis), end = along(to, axis), reach = std::abs(end - start);
    for (const double line : lines) {
        const double t = (line - start) / (end - start);
        if (t * reach < 0.5 * spacing || (1 - t) * reach < 0.5 * spacing) continue;
        Vec2 place = lerp(from, to, t);
        (axis == 0 ? place.x : place.y) = line;
        crossings.push_back(place);
    }
    if (end < start) std::reverse(crossings.begin(), crossings.end());
    return crossings;
}

std::vector<Vec2> equalParts(const std::vector<Vec2>& leg, double spacing) {
    double total = 0;
    for (std::size_t i = 0; i + 1 < leg.size(); ++i) total += distance(leg[i], leg[i + 1]);
    const int parts = partsOf(total, spacing);
    std::vector<Vec2> places;
    double before = 0;
    for (std::size_t i = 0; i + 1 < leg.size(); ++i) {
        const double here = distance(leg[i], leg[i + 1]);
        for (int k = static_cast<int>(places.size()) + 1; k < parts && k * total / parts <= before + here; ++k)
            places.push_back(lerp(leg[i], leg[i + 1], (k * total / parts - before) / here));
        before += here;
    }
    return places;
}

/// Where a leg's nodes lie between its ends, in the frame.
std::vector<Vec2> nodesOf(const std::vector<Vec2>& leg, const PieceInput& piece, const PieceFrame& frame,
                          const Lattice& lattice) {
    const Vec2 way = leg.back() - leg.front();
    if (leg.size() == 2 && lattice.isUniform())
        for (const int axis : {0, 1})
            if (std::abs(along(way, 1 - axis)) <= 2 * frame.unit)
                return crossingsOf(leg.front(), leg.back(), axis == 0 ? lattice.mainX() : lattice.mainY(), axis,
                                   piece.spacing);
    return equalParts(leg, piece.spacing / finestAlong(lattice, leg, piece.spacing));
}

struct Segment {
    GridPoint a, b;
    int nodeA = 0, nodeB = 0;
};

/// Two segments that have more in common than an end of both.
bool clash(const Segment& s, const Segment& t) {
    if (s.nodeA != t.nodeA && s.nodeA != t.nodeB && s.nodeB != t.nodeA && s.nodeB != t.nodeB)
        return segmentsMeet(s.a, s.b, t.a, t.b);
    const auto isNew = [&](int node) { return node != s.nodeA && node != s.nodeB; };
    const auto isLost = [&](int node) { return node != t.nodeA && node != t.nodeB; };
    return (!isNew(t.nodeA) && !isNew(t.nodeB)) || (isNew(t.nodeA) && onSegment(s.a, s.b, t.a)) ||
           (isNew(t.nodeB) && onSegment(s.a, s.b, t.b)) || (isLost(s.nodeA) && onSegment(t.a, t.b, s.a)) ||
           (isLost(s.nodeB) && onSegment(t.a, t.b, s.b));
}

std::vector<Segment> segmentsOf(const BoundaryNodes& nodes, const std::vector<int>& line, bool closed) {
    std::vector<Segment> segments;
    for (std::size_t i = 0; i + (closed ? 0 : 1) < line.size(); ++i) {
        const int a = line[i], b = line[(i + 1) % line.size()];
        segments.push_back({nodes.grid[at(a)], nodes.grid[at(b)], a, b});
    }
    return segments;
}

/// A side from this node of the border begins inside the piece; one that then meets no border stays there.
bool setsOutInside(const BoundaryNodes& nodes, int from, int towards) {
    for (const std::vector<int>& ring : nodes.rings) {
        const auto found = std::ranges::find(ring, from);
        if (found == ring.end()) continue;
        const int previous = found == ring.begin() ? ring.back() : *std::prev(found);
        const int next = std::next(found) == ring.end() ? ring.front() : *std::next(found);
        return insideCorner(nodes.grid[at(previous)], nodes.grid[at(from)], nodes.grid[at(next)],
                            nodes.grid[at(towards)]);
    }
    return false;
}

/// A fold's nodes between its ends lie inside, and its sides meet nothing but at nodes.
Result<void> checkCourse(const PieceInput& piece, std::size_t number, const BoundaryNodes& nodes) {
    const FoldInput& fold = piece.folds[number];
    const std::vector<int>& line = nodes.folds[number];
    const auto gridRing = [&](std::size_t r) {
        std::vector<GridPoint> ring;
        for (const int node : nodes.rings[r]) ring.push_back(nodes.grid[at(node)]);
        return ring;
    };
    for (std::size_t r = 0; r < nodes.rings.size(); ++r) {
        const std::vector<GridPoint> ring = gridRing(r);
        for (std::size_t i = 1; i + 1 < line.size(); ++i)
            if (isInside(ring, nodes.grid[at(line[i])]) != (r == 0))
                return refuse(piece, fold,
                              "The fold leaves the piece at " + pointText(nodes.points[at(line[i])]) + ".");
    }
    const std::vector<Segment> own = segmentsOf(nodes, line, false);
    const auto meets = [&](const std::vector<Segment>& others) -> const Segment* {
        for (const Segment& s : own)
            for (const Segment& t : others)
                if (clash(s, t)) return &s;
        return nullptr;
    };
    for (const auto& ring : nodes.rings)
        if (const Segment* s = meets(segmentsOf(nodes, ring, true)))
            return refuse(piece, fold,
                          "The fold crosses or touches the border near " + pointText(nodes.points[at(s->nodeA)]) + ".");
    for (std::size_t other = 0; other < number; ++other)
        if (const Segment* s = meets(segmentsOf(nodes, nodes.folds[other], false)))
            return refuse(piece, fold,
                          "The fold crosses or touches fold \"" + piece.folds[other].label + "\" near " +
                              pointText(nodes.points[at(s->nodeA)]) + ".");
    for (std::size_t i = 0; i < own.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            if (clash(own[i], own[j]))
                return refuse(piece, fold,
                              "The fold crosses or touches itself near " + pointText(nodes.points[at(line[i])]) + ".");
    if (!setsOutInside(nodes, line[0], line[1])) return refuse(piece, fold, "The fold runs outside the piece.");
    return {};
}

void addNodes(const PieceInput& piece, const PieceBoundary& boundary, const Lattice& lattice, const FoldInput& fold,
              BoundaryNodes& nodes) {
    const int first = nodeAt(nodes, fold.ends[0]), last = nodeAt(nodes, fold.ends[1]);
    std::vector<Vec2> line{boundary.frame.frameOf(nodes.points[at(first)])};
    for (std::size_t i = 1; i + 1 < fold.points.size(); ++i) line.push_back(boundary.frame.frameOf(fold.points[i]));
    line.push_back(boundary.frame.frameOf(nodes.points[at(last)]));
    std::vector<int>& numbers = nodes.folds.emplace_back();
    numbers.push_back(first);
    const auto add = [&](Vec2 inFrame) {
        const GridPoint grid = boundary.frame.gridOf(inFrame);
        if (grid == nodes.grid[at(numbers.back())]) return;
        numbers.push_back(static_cast<int>(nodes.points.size()));
        nodes.points.push_back(boundary.frame.pointFromFrame(inFrame));
        nodes.grid.push_back(grid);
    };
    const auto legs = legsOf(line);
    for (std::size_t leg = 0; leg < legs.size(); ++leg) {
        for (const Vec2 place : nodesOf(legs[leg], piece, boundary.frame, lattice)) add(place);
        if (leg + 1 < legs.size()) add(legs[leg].back());
    }
    numbers.push_back(last);
}

} // namespace

Result<void> checkFolds(const PieceInput& piece, const PieceBoundary& boundary) {
    for (const FoldInput& fold : piece.folds) {
        if (fold.points.size() < 2) return refuse(piece, fold, "A fold needs at least two points.");
        for (const Vec2 point : fold.points)
            if (!geometry::isFinite(point) || std::abs(point.x) >= 1e6 || std::abs(point.y) >= 1e6)
                return refuse(piece, fold, "A coordinate is not a number or beyond 1e6 m.");
        for (const FoldEndInput& end : fold.ends) {
            if (end.loop < 0 || end.loop >= loopCount(piece) || end.edge < 0 ||
                end.edge >= static_cast<int>(loopOf(piece, end.loop).size()) || !(end.fraction >= 0) ||
                !(end.fraction <= 1))
                return refuse(piece, fold, "A fold begins and ends on the border of its piece.");
            if (boundary.loops[at(end.loop)].edges[at(end.edge)].collapsed)
                return refuse(piece, fold, "A fold cannot end on an edge without length.");
        }
    }
    return {};
}

Result<void> addFoldNodes(const PieceInput& piece, const PieceBoundary& boundary, const Lattice& lattice,
                          BoundaryNodes& nodes) {
    for (std::size_t number = 0; number < piece.folds.size(); ++number) {
        addNodes(piece, boundary, lattice, piece.folds[number], nodes);
        if (nodes.folds[number].front() == nodes.folds[number].back())
            return refuse(piece, piece.folds[number], "The fold ends where it begins.");
        if (auto checked = checkCourse(piece, number, nodes); !checked) return checked;
    }
    return {};
}

void FoldSides::assign(const BoundaryNodes& nodes) {
    sides_.clear();
    for (const auto& line : nodes.folds)
        for (std::size_t i = 0; i + 1 < line.size(); ++i) sides_.push_back(std::minmax(line[i], line[i + 1]));
    std::sort(sides_.begin(), sides_.end());
}

bool FoldSides::has(int a, int b) const {
    return !sides_.empty() && std::binary_search(sides_.begin(), sides_.end(), std::pair<int, int>(std::minmax(a, b)));
}

} // namespace toile::meshing
