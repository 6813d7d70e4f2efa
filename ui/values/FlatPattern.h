// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/pattern/Brush.h"
#include "core/pattern/Pattern.h"

#include <optional>
#include <vector>

namespace toile::ui {

/// A contour as it is drawn: each edge as a polyline from its start to its end.
struct FlatContour {
    std::vector<std::vector<Vec2>> edges;
    geometry::Polygon polygon;
};

/// A piece as it is drawn: mirrors resolved, curves flattened, moved to its place on the pattern table.
struct FlatPiece {
    pattern::Piece piece; ///< resolved, its geometry in coordinates of the table: points of the piece + tablePosition
    FlatContour outline;
    std::vector<FlatContour> holes;
    std::vector<pattern::Area> cut; ///< with its seam allowances

    [[nodiscard]] const pattern::Contour& contour(std::size_t loop) const;
    [[nodiscard]] const FlatContour& flat(std::size_t loop) const;
    [[nodiscard]] std::size_t loops() const { return 1 + holes.size(); }
};

/// The pattern as painters and tools see it, in the order of its pieces.
struct FlatPattern {
    std::vector<FlatPiece> pieces;
};

/// The piece with all its points moved.
[[nodiscard]] pattern::Piece moved(pattern::Piece piece, Vec2 by);
[[nodiscard]] FlatPattern flattened(const pattern::Pattern& pattern);
[[nodiscard]] const FlatPiece* findPiece(const FlatPattern& pattern, const pattern::PieceId& id);
[[nodiscard]] geometry::Box2 boundsOf(const FlatPattern& pattern);
[[nodiscard]] geometry::Box2 boundsOf(const FlatPiece& piece);
/// Inside the outline and in no hole.
[[nodiscard]] bool covers(const FlatPiece& piece, Vec2 point);

/// An edge of a contour of a piece, by index.
struct EdgePlace {
    std::size_t loop = 0; ///< 0 = the outline, then the holes
    std::size_t edge = 0;
    friend bool operator==(const EdgePlace&, const EdgePlace&) = default;
};
[[nodiscard]] std::optional<EdgePlace> placeOf(const pattern::Piece& piece, const pattern::EdgeId& edge);
struct VertexPlace {
    std::size_t loop = 0, vertex = 0;
    friend bool operator==(const VertexPlace&, const VertexPlace&) = default;
};
[[nodiscard]] std::optional<VertexPlace> placeOf(const pattern::Piece& piece, const pattern::VertexId& vertex);

/// The way of a seam part in the plane, in the direction in which it is sewn; empty where piece or edge is missing.
[[nodiscard]] std::vector<Vec2> pathOf(const FlatPattern& pattern, const pattern::SeamPart& part);
/// One side of a seam: the ways of its parts.
[[nodiscard]] std::vector<std::vector<Vec2>> pathsOf(const FlatPattern& pattern,
                                                     const std::vector<pattern::SeamPart>& side);
/// Length of the polylines together [m].
[[nodiscard]] double lengthOf(const std::vector<Vec2>& path);
[[nodiscard]] double lengthOf(const std::vector<std::vector<Vec2>>& paths);
/// The point at a fraction of a polyline's length, and the direction there (not normalised).
struct PathPoint {
    Vec2 position, direction;
};
[[nodiscard]] PathPoint pointAlong(const std::vector<Vec2>& path, double fraction);
/// The same of ways in a row, which are not empty.
[[nodiscard]] PathPoint pointAlong(const std::vector<std::vector<Vec2>>& paths, double fraction);

} // namespace toile::ui
