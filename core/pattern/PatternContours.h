// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/pattern/Editing.h"
#include "core/pattern/Ids.h"

#include <span>

namespace toile::pattern {

// Edits of stitching lines. All are pure: the pattern they are given stays as it is. Coordinates are the piece's [m].
// Crossing borders are allowed while one drags; checkPattern finds them.

/// A contour through points with an edge shape from each point to the next; missing shapes are lines. Turned to run
/// counter-clockwise. Error when there are fewer than three points, two neighbours coincide, or the area is zero.
[[nodiscard]] Result<Contour> contourThrough(std::span<const Vec2> points, std::span<const EdgeShape> shapes,
                                             IdSource& ids);

/// The handles of Bézier edges at the vertex go with it.
[[nodiscard]] Result<Pattern> moveVertex(const Pattern& pattern, const PieceId& piece, const VertexId& vertex, Vec2 to);
/// Moves several vertices by the same way, with the handles at them.
[[nodiscard]] Result<Pattern> moveVertices(const Pattern& pattern, const PieceId& piece,
                                           std::span<const VertexId> vertices, Vec2 by);

enum class Handle { first, second };
/// Moves a control point of a Bézier edge. A line or an arc becomes the Bézier curve nearest to it first.
[[nodiscard]] Result<Pattern> moveHandle(const Pattern& pattern, const PieceId& piece, const EdgeId& edge,
                                         Handle handle, Vec2 to);
[[nodiscard]] Result<Pattern> setEdgeShape(const Pattern& pattern, const PieceId& piece, const EdgeId& edge,
                                           const EdgeShape& shape);
/// Control points of the cubic that stands for a curve: exact for lines and Béziers, for arcs with the same end points,
/// tangents and middle.
[[nodiscard]] geometry::CubicShape cubicOf(const geometry::Curve& curve);
/// Absent = the piece's own.
[[nodiscard]] Result<Pattern> setEdgeSeamAllowance(const Pattern& pattern, const PieceId& piece, const EdgeId& edge,
                                                   std::optional<double> allowance);

/// Splits an edge at a fraction of its arc length in (0, 1) without changing its course. The first part keeps the
/// edge's id; seams and notches are rewritten to the same places.
[[nodiscard]] Result<Pattern> insertVertex(const Pattern& pattern, const PieceId& piece, const EdgeId& edge,
                                           double fraction, IdSource& ids);
/// Joins the two edges at a vertex into one, which keeps the first one's id: the curve both were split from where there
/// is one, else one with the same end tangents. Seams and notches are rewritten; pins of the vertex are dropped.
/// A warning names each seam whose course has changed, or that is gone because a side of it ran along an edge without
/// length only, and a seam allowance that the second edge had of its own.
[[nodiscard]] Result<Edited> deleteVertex(const Pattern& pattern, const PieceId& piece, const VertexId& vertex);

/// Cuts a hole; it is turned to run clockwise.
[[nodiscard]] Result<Pattern> addHole(const Pattern& pattern, const PieceId& piece, std::span<const Vec2> points,
                                      IdSource& ids);
/// Seams along the hole, and folds that end on it, are dropped with a warning.
[[nodiscard]] Result<Edited> deleteHole(const Pattern& pattern, const PieceId& piece, std::size_t hole);

/// Where sections of a seam have ease or gathers of their own, they are divided anew when its notches change: what is
/// divided is shared by length, what becomes one is added up.
[[nodiscard]] Result<Pattern> addNotch(const Pattern& pattern, const PieceId& piece, const Notch& notch);
[[nodiscard]] Result<Pattern> changeNotch(const Pattern& pattern, const PieceId& piece, std::size_t notch,
                                          const Notch& to);
[[nodiscard]] Result<Pattern> removeNotch(const Pattern& pattern, const PieceId& piece, std::size_t notch);

} // namespace toile::pattern
