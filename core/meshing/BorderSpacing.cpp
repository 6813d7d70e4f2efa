// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/meshing/BorderSpacing.h"
#include "core/base/Index.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace toile::meshing {
namespace {

/// A fixed point pair nearer than the spacing divides the cells beside it once only: the rings would cost
/// more than the angles are worth.
constexpr int loneSegmentDivision = 2;
constexpr int seamDivision = 1 << 16;

double loopArea(const BoundaryLoop& loop) {
    double doubled = 0;
    const Vec2 origin = loop.front().curve.start;
    for (const BoundaryEdge& edge : loop) {
        // Simpson's rule on ½ ∮ p × dp; exact for lines, 1e-10 relative for the curves of garments.
        const int panels = std::holds_alternative<geometry::LineShape>(edge.curve.shape) ? 1 : 64;
        const auto integrand = [&](double t) {
            return cross(geometry::pointAt(edge.curve, t) - origin, geometry::tangentAt(edge.curve, t));
        };
        for (int k = 0; k < panels; ++k) {
            const double a = static_cast<double>(k) / panels, b = static_cast<double>(k + 1) / panels;
            doubled += (b - a) / 6 * (integrand(a) + 4 * integrand(0.5 * (a + b)) + integrand(b));
        }
    }
    return std::abs(0.5 * doubled);
}

double distanceToChords(const EdgeNodes& list, const BoundaryNodes& nodes, Vec2 point) {
    double least = distance(nodes.points[at(list.front().node)], point);
    for (std::size_t k = 0; k + 1 < list.size() && least > 0; ++k)
        least = std::min(least, distance(point, geometry::closestOnSegment(nodes.points[at(list[k].node)],
                                                                           nodes.points[at(list[k + 1].node)], point)));
    return least;
}

} // namespace

double finestSpacingAlong(const PieceInput& piece, const PieceBoundary& boundary, const Lattice& lattice, int loop,
                          int edge, double from, double to) {
    const LoopBoundary& border = boundary.loops[at(loop)];
    const EdgeArc& arc = border.edges[at(edge)];
    const auto place = [&](double fraction) { return boundary.frame.frameOf(arc.arc.pointAt(fraction)); };
    if (arc.collapsed) return piece.spacing;
    const int samples = 2 + static_cast<int>(std::ceil(arc.length * (to - from) / (0.25 * piece.spacing)));
    int finest = 1;
    for (int k = 0; k < samples; ++k) {
        const double fraction = from + (to - from) * (k + 0.5) / samples, step = 0.25 * (to - from) / samples;
        const Vec2 along = place(fraction + step) - place(fraction - step);
        const Vec2 inward = normalized(leftOf(along)) * (border.backwards ? -1e-3 : 1e-3) * piece.spacing;
        const Vec2 inside = place(fraction) + inward; // a border on a line belongs to the cell inside
        finest = std::max(finest, lattice.divisionOf(lattice.columnOf(inside.x), lattice.rowOf(inside.y)));
    }
    return piece.spacing / finest;
}

void listSeeds(const BoundaryNodes& nodes, const PieceFrame& frame, int pieceIndex, const BoundaryDivision& division,
               std::vector<SpacingSeed>& seeds) {
    seeds.clear();
    seeds.reserve(nodes.points.size());
    for (std::size_t r = 0; r < nodes.rings.size(); ++r)
        for (std::size_t i = 0; i < nodes.rings[r].size(); ++i) {
            const BoundarySpot& spot = nodes.spots[r][i];
            int parts = 1;
            for (const Stretch& stretch : division.stretches(pieceIndex, spot.loop, spot.edge))
                if (stretch.from <= spot.fraction && spot.fraction <= stretch.to) parts = division.count(stretch);
            const int a = nodes.rings[r][i], b = nodes.rings[r][(i + 1) % nodes.rings[r].size()];
            seeds.push_back({frame.frameOf(nodes.points[at(a)]), frame.frameOf(nodes.points[at(b)]),
                             parts > 1 ? seamDivision : loneSegmentDivision});
        }
}

double exactArea(const PieceInput& piece) {
    double area = 0;
    for (int loop = 0; loop < loopCount(piece); ++loop) area += loopArea(loopOf(piece, loop)) * (loop == 0 ? 1 : -1);
    return area;
}

double boundaryDeviation(const PieceInput& piece, const PieceBoundary& boundary, const BoundaryNodes& nodes) {
    double worst = 0;
    for (int loop = 0; loop < loopCount(piece); ++loop)
        for (std::size_t e = 0; e < loopOf(piece, loop).size(); ++e) {
            const EdgeNodes& list = nodes.loops[at(loop)][e];
            const EdgeArc& arc = boundary.loops[at(loop)].edges[e];
            const Curve& curve = loopOf(piece, loop)[e].curve;
            if (std::holds_alternative<geometry::LineShape>(curve.shape)) { // its ends may be passed over
                for (const Vec2 end : {curve.start, curve.end})
                    worst = std::max(worst, distanceToChords(list, nodes, end));
                continue;
            }
            for (std::size_t k = 0; k + 1 < list.size() && !arc.collapsed; ++k)
                for (const double part : {0.25, 0.5, 0.75}) {
                    const Vec2 on =
                        arc.arc.pointAt(list[k].fraction + (list[k + 1].fraction - list[k].fraction) * part);
                    worst = std::max(worst,
                                     distance(on, geometry::closestOnSegment(nodes.points[at(list[k].node)],
                                                                             nodes.points[at(list[k + 1].node)], on)));
                }
        }
    return worst;
}

double smallestBorderAngle(const BoundaryNodes& nodes) {
    double smallest = 2 * std::numbers::pi;
    for (const auto& ring : nodes.rings)
        for (std::size_t i = 0, n = ring.size(); i < n; ++i) {
            const Vec2 here = nodes.points[at(ring[i])];
            // Either turning sense: a mirrored or clockwise ring has its interior on the other side.
            const Vec2 next = nodes.points[at(ring[(i + 1) % n])] - here,
                       before = nodes.points[at(ring[(i + n - 1) % n])] - here;
            const bool leftTurn = orientation(nodes.grid[at(ring[(i + n - 1) % n])], nodes.grid[at(ring[i])],
                                              nodes.grid[at(ring[(i + 1) % n])]) >= 0;
            const double between = std::atan2(std::abs(cross(next, before)), dot(next, before));
            smallest = std::min(smallest, leftTurn ? between : 2 * std::numbers::pi - between);
        }
    return smallest;
}

} // namespace toile::meshing
