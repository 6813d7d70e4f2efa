// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pattern/PatternContours.h"

#include "core/pattern/EdgeFractions.h"
#include "core/pattern/JoinedCurve.h"
#include "core/pattern/PatternMeasures.h"
#include "core/pattern/SeamSections.h"

#include <algorithm>
#include <fmt/format.h>
#include <functional>

namespace toile::pattern {
namespace {

using geometry::ArcShape;
using geometry::CubicShape;
using geometry::Curve;
using geometry::LineShape;

constexpr double nearEnd = 1e-9;    ///< fractions this near to an end of an edge are the end [–]
constexpr double coincident = 1e-9; ///< points nearer than this coincide [m]

Result<LoopIndex> edgeIn(const Piece& piece, const EdgeId& edge) {
    if (const auto at = findEdge(piece, edge)) return *at;
    return fail(ErrorCode::notFound, fmt::format("There is no edge \"{}\".", edge.value), placeOf(piece));
}

Result<LoopIndex> vertexIn(const Piece& piece, const VertexId& vertex) {
    if (const auto at = findVertex(piece, vertex)) return *at;
    return fail(ErrorCode::notFound, fmt::format("There is no point \"{}\".", vertex.value), placeOf(piece));
}

Result<void> finite(Vec2 p, const Piece& piece) {
    if (geometry::isFinite(p)) return {};
    return fail(ErrorCode::invalidInput, "A point must have finite coordinates.", placeOf(piece));
}

std::size_t before(const Contour& contour, std::size_t i) {
    return (i + contour.edges.size() - 1) % contour.edges.size();
}

/// Moves a vertex with the handles at it.
void moveWithHandles(Contour& contour, std::size_t i, Vec2 by) {
    contour.vertices[i].position += by;
    if (auto* in = std::get_if<CubicShape>(&contour.edges[before(contour, i)].shape)) in->control2 += by;
    if (auto* out = std::get_if<CubicShape>(&contour.edges[i].shape)) out->control1 += by;
}

Contour turnedRound(Contour contour) {
    const std::size_t n = contour.vertices.size();
    Contour turned;
    for (std::size_t i = 0; i < n; ++i) {
        turned.vertices.push_back(contour.vertices[(n - i) % n]);
        const std::size_t edge = n - 1 - i;
        Edge back = contour.edges[edge];
        back.shape = geometry::reversed(curveOf(contour, edge)).shape;
        turned.edges.push_back(std::move(back));
    }
    return turned;
}

template <class Predicate>
std::vector<Warning> warnOfSeams(const Pattern& pattern, Predicate touches, const std::string& text) {
    std::vector<Warning> warnings;
    for (const Seam& seam : pattern.seams)
        if (std::ranges::any_of(seam.sides, [&](const auto& side) { return std::ranges::any_of(side, touches); }))
            warnings.push_back({toString(placeOf(seam)), text});
    return warnings;
}

bool liesOnAnEdge(const Notch& notch) {
    return notch.position >= 0 && notch.position <= 1;
}

/// The shape with other notches; the sections of seams follow.
Result<Pattern> changedNotches(const Pattern& pattern, const PieceId& piece,
                               const std::function<Result<void>(Piece&)>& change) {
    return changedShape(pattern, piece, change).map([&](Pattern next) {
        divideSectionsAnew(next, pattern);
        return next;
    });
}

/// A side that ran along an edge without length alone is no side.
void dropOneSidedSeams(Edited& edited) {
    std::erase_if(edited.pattern.seams, [&](const Seam& seam) {
        const bool gone = std::ranges::any_of(seam.sides, [](const auto& side) { return side.empty(); });
        if (gone) edited.warnings.push_back({toString(placeOf(seam)), "it is gone: one side of it had no length."});
        return gone;
    });
}

/// Pins of vertices that a piece, and so its mirror images, no longer have.
void dropPins(Edited& edited, const PieceId& piece, std::span<const VertexId> gone) {
    const auto pins = std::erase_if(edited.pattern.pins, [&](const Pin& pin) {
        const Piece* holder = findPiece(edited.pattern, pin.piece);
        const bool here = pin.piece == piece || (holder && holder->mirror && holder->mirror->source == piece);
        return here && std::ranges::find(gone, pin.vertex) != gone.end();
    });
    if (pins > 0)
        edited.warnings.push_back(
            {toString(placeOf(*findPiece(edited.pattern, piece))), "the pin of a deleted point is gone."});
}

} // namespace

Result<Contour> contourThrough(std::span<const Vec2> points, std::span<const EdgeShape> shapes, IdSource& ids) {
    if (points.size() < 3) return fail(ErrorCode::invalidInput, "A contour needs at least three points.");
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (!geometry::isFinite(points[i]))
            return fail(ErrorCode::invalidInput, "A point must have finite coordinates.");
        if (geometry::distance(points[i], points[(i + 1) % points.size()]) < coincident)
            return fail(ErrorCode::invalidInput, "Two neighbouring points of a contour must not coincide.");
    }
    Contour contour;
    for (std::size_t i = 0; i < points.size(); ++i) {
        contour.vertices.push_back({ids.take<VertexId>(), points[i]});
        contour.edges.push_back({ids.take<EdgeId>(), i < shapes.size() ? shapes[i] : EdgeShape{LineShape{}}, {}});
    }
    const double area = geometry::signedArea(flattened(contour, 1e-4));
    if (std::abs(area) < 1e-12) return fail(ErrorCode::invalidInput, "A contour must enclose an area.");
    return area > 0 ? contour : turnedRound(std::move(contour));
}

Result<Pattern> moveVertex(const Pattern& pattern, const PieceId& piece, const VertexId& vertex, Vec2 to) {
    return changedShape(pattern, piece, [&](Piece& p) -> Result<void> {
        return vertexIn(p, vertex).and_then([&](LoopIndex at) {
            Contour& contour = loopOf(p, at.loop);
            if (auto ok = finite(to, p); !ok) return ok;
            moveWithHandles(contour, at.index, to - contour.vertices[at.index].position);
            contour.vertices[at.index].position = to; // exactly
            return Result<void>();
        });
    });
}

Result<Pattern> moveVertices(const Pattern& pattern, const PieceId& piece, std::span<const VertexId> vertices,
                             Vec2 by) {
    return changedShape(pattern, piece, [&](Piece& p) -> Result<void> {
        for (const VertexId& vertex : vertices) {
            const auto at = vertexIn(p, vertex);
            if (!at) return tl::unexpected<Error>(at.error());
            moveWithHandles(loopOf(p, at->loop), at->index, by);
        }
        return finite(by, p);
    });
}

CubicShape cubicOf(const Curve& curve) {
    if (const auto* cubic = std::get_if<CubicShape>(&curve.shape)) return *cubic;
    double handle = 1.0 / 3; // of the tangent vector, which for lines and arcs has the length of the curve
    if (const auto* arc = std::get_if<ArcShape>(&curve.shape); arc && std::abs(arc->bulge) > 1e-9) {
        const double sweep = 4 * std::atan(arc->bulge);
        handle = 4.0 / 3 * std::tan(sweep / 4) / sweep; // the usual circle approximation: its middle lies on the arc
    }
    return {curve.start + geometry::tangentAt(curve, 0) * handle, curve.end - geometry::tangentAt(curve, 1) * handle};
}

Result<Pattern> moveHandle(const Pattern& pattern, const PieceId& piece, const EdgeId& edge, Handle handle, Vec2 to) {
    return changedShape(pattern, piece, [&](Piece& p) -> Result<void> {
        return edgeIn(p, edge).and_then([&](LoopIndex at) {
            CubicShape cubic = cubicOf(curveOf(p, at));
            (handle == Handle::first ? cubic.control1 : cubic.control2) = to;
            loopOf(p, at.loop).edges[at.index].shape = cubic;
            return finite(to, p);
        });
    });
}

Result<Pattern> setEdgeShape(const Pattern& pattern, const PieceId& piece, const EdgeId& edge, const EdgeShape& shape) {
    return changedShape(pattern, piece, [&](Piece& p) -> Result<void> {
        return edgeIn(p, edge).and_then([&](LoopIndex at) {
            loopOf(p, at.loop).edges[at.index].shape = shape;
            if (const auto* arc = std::get_if<ArcShape>(&shape); arc && !std::isfinite(arc->bulge))
                return Result<void>(
                    fail(ErrorCode::invalidInput, "The bulge of an arc must be a finite number.", placeOf(p)));
            if (const auto* cubic = std::get_if<CubicShape>(&shape))
                return finite(cubic->control1 + cubic->control2, p);
            return Result<void>();
        });
    });
}

Result<Pattern> setEdgeSeamAllowance(const Pattern& pattern, const PieceId& piece, const EdgeId& edge,
                                     std::optional<double> allowance) {
    return changedShape(pattern, piece, [&](Piece& p) -> Result<void> {
        if (allowance && !(*allowance >= 0 && std::isfinite(*allowance)))
            return fail(ErrorCode::invalidInput, "A seam allowance cannot be negative.", placeOf(p));
        return edgeIn(p, edge).map([&](LoopIndex at) { loopOf(p, at.loop).edges[at.index].seamAllowance = allowance; });
    });
}

Result<Pattern> insertVertex(const Pattern& pattern, const PieceId& piece, const EdgeId& edge, double fraction,
                             IdSource& ids) {
    const EdgeId after = ids.take<EdgeId>();
    auto next = changedShape(pattern, piece, [&](Piece& p) -> Result<void> {
        if (!(fraction > nearEnd && fraction < 1 - nearEnd))
            return fail(ErrorCode::invalidInput, "A new point must lie between the ends of its edge.", placeOf(p));
        return edgeIn(p, edge).map([&](LoopIndex at) {
            Contour& contour = loopOf(p, at.loop);
            const Curve whole = curveOf(contour, at.index);
            const auto [first, second] = geometry::splitAt(whole, geometry::ArcLength(whole).parameterAt(fraction));
            Edge rest = contour.edges[at.index];
            rest.id = after;
            rest.shape = second.shape;
            contour.edges[at.index].shape = first.shape;
            const auto behind = static_cast<std::ptrdiff_t>(at.index) + 1;
            contour.edges.insert(contour.edges.begin() + behind, std::move(rest));
            contour.vertices.insert(contour.vertices.begin() + behind, {ids.take<VertexId>(), first.end});
        });
    });
    if (next) rewriteAfterSplit(*next, piece, edge, after, fraction);
    return next;
}

Result<Edited> deleteVertex(const Pattern& pattern, const PieceId& piece, const VertexId& vertex) {
    EdgeId kept, gone;
    double fraction = 0;
    bool moved = false;
    std::vector<Warning> narrowed;
    auto next = changedShape(pattern, piece, [&](Piece& p) -> Result<void> {
        const auto at = vertexIn(p, vertex);
        if (!at) return tl::unexpected<Error>(at.error());
        Contour& contour = loopOf(p, at->loop);
        if (contour.vertices.size() <= 3)
            return fail(ErrorCode::invalidInput, "A contour needs at least three points: delete the whole instead.",
                        placeOf(p));
        const std::size_t in = before(contour, at->index);
        const Curve a = curveOf(contour, in), b = curveOf(contour, at->index);
        const Curve joined = joinedCurve(a, b);
        fraction = jointOf(a, b);
        moved = !sameCourse(joined, a, b, fraction);
        kept = contour.edges[in].id;
        gone = contour.edges[at->index].id;
        const auto allowanceOf = [&](std::size_t i) {
            return contour.edges[i].seamAllowance.value_or(p.seamAllowance);
        };
        if (const double first = allowanceOf(in), second = allowanceOf(at->index); first != second)
            narrowed.push_back(
                {toString(placeOf(p)),
                 fmt::format("the edges at the deleted point had seam allowances of {:.1f} and {:.1f} mm; "
                             "the one they are joined to has the first.",
                             1000 * first, 1000 * second)});
        contour.edges[in].shape = joined.shape;
        contour.vertices.erase(contour.vertices.begin() + static_cast<std::ptrdiff_t>(at->index));
        contour.edges.erase(contour.edges.begin() + static_cast<std::ptrdiff_t>(at->index));
        return {};
    });
    if (!next) return tl::unexpected<Error>(std::move(next).error());
    Edited edited{*std::move(next), {}};
    if (moved)
        edited.warnings = warnOfSeams(
            pattern,
            [&](const SeamPart& part) {
                return liesOn(pattern, part, piece, kept) || liesOn(pattern, part, piece, gone);
            },
            "its course has changed with the deleted point.");
    edited.warnings.insert(edited.warnings.end(), narrowed.begin(), narrowed.end());
    rewriteAfterJoin(edited.pattern, piece, kept, gone, fraction);
    dropOneSidedSeams(edited);
    dropPins(edited, piece, std::span(&vertex, 1));
    return edited;
}

Result<Pattern> addHole(const Pattern& pattern, const PieceId& piece, std::span<const Vec2> points, IdSource& ids) {
    return changedShape(pattern, piece, [&](Piece& p) -> Result<void> {
        return contourThrough(points, {}, ids).map([&](Contour hole) {
            p.holes.push_back(turnedRound(std::move(hole)));
        });
    });
}

Result<Edited> deleteHole(const Pattern& pattern, const PieceId& piece, std::size_t hole) {
    std::vector<EdgeId> gone;
    std::vector<VertexId> goneVertices;
    std::vector<Warning> unfolded;
    const auto isGone = [&](const EdgeId& edge) { return std::ranges::find(gone, edge) != gone.end(); };
    auto next = changedShape(pattern, piece, [&](Piece& p) -> Result<void> {
        if (hole >= p.holes.size()) return fail(ErrorCode::notFound, "There is no such hole.", placeOf(p));
        for (const Edge& edge : p.holes[hole].edges) gone.push_back(edge.id);
        for (const Vertex& vertex : p.holes[hole].vertices) goneVertices.push_back(vertex.id);
        p.holes.erase(p.holes.begin() + static_cast<std::ptrdiff_t>(hole));
        std::erase_if(p.notches, [&](const Notch& notch) { return isGone(notch.edge); });
        std::erase_if(p.folds, [&](const Fold& fold) {
            const bool ends = std::ranges::any_of(fold.ends, [&](const BorderPoint& end) { return isGone(end.edge); });
            if (ends) unfolded.push_back({toString(placeOf(p, fold)), "it is gone with the hole that it ended on."});
            return ends;
        });
        return {};
    });
    if (!next) return tl::unexpected<Error>(std::move(next).error());
    const auto touches = [&](const SeamPart& part) {
        return std::ranges::any_of(gone, [&](const EdgeId& edge) { return liesOn(pattern, part, piece, edge); });
    };
    Edited edited{*std::move(next), warnOfSeams(pattern, touches, "it is gone with the hole that it ran along.")};
    edited.warnings.insert(edited.warnings.end(), unfolded.begin(), unfolded.end());
    std::erase_if(edited.pattern.seams, [&](const Seam& seam) {
        return std::ranges::any_of(seam.sides, [&](const auto& side) { return std::ranges::any_of(side, touches); });
    });
    dropPins(edited, piece, goneVertices);
    return edited;
}

Result<Pattern> addNotch(const Pattern& pattern, const PieceId& piece, const Notch& notch) {
    return changedNotches(pattern, piece, [&](Piece& p) -> Result<void> {
        if (!liesOnAnEdge(notch))
            return fail(ErrorCode::invalidInput, "A notch lies between the ends of its edge.", placeOf(p));
        return edgeIn(p, notch.edge).map([&](LoopIndex) { p.notches.push_back(notch); });
    });
}

Result<Pattern> changeNotch(const Pattern& pattern, const PieceId& piece, std::size_t notch, const Notch& to) {
    return changedNotches(pattern, piece, [&](Piece& p) -> Result<void> {
        if (notch >= p.notches.size()) return fail(ErrorCode::notFound, "There is no such notch.", placeOf(p));
        if (!liesOnAnEdge(to))
            return fail(ErrorCode::invalidInput, "A notch lies between the ends of its edge.", placeOf(p));
        return edgeIn(p, to.edge).map([&](LoopIndex) { p.notches[notch] = to; });
    });
}

Result<Pattern> removeNotch(const Pattern& pattern, const PieceId& piece, std::size_t notch) {
    return changedNotches(pattern, piece, [&](Piece& p) -> Result<void> {
        if (notch >= p.notches.size()) return fail(ErrorCode::notFound, "There is no such notch.", placeOf(p));
        p.notches.erase(p.notches.begin() + static_cast<std::ptrdiff_t>(notch));
        return {};
    });
}

} // namespace toile::pattern
