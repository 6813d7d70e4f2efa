// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/values/FlatPattern.h"
#include "ui/values/Selection.h"

#include <optional>

namespace toile::ui {

/// A place on an edge of a contour.
struct EdgeHit {
    EdgeRef edge;
    Vec2 point;           ///< of the edge, nearest to the pointer [m]
    double parameter = 0; ///< of the edge's curve in the resolved piece
    double fraction = 0;  ///< of its arc length, along the source's edge where the piece is a mirror
    double distance = 0;  ///< from the pointer [m]
};

/// One of the two control points of a cubic edge.
struct HandleRef {
    EdgeRef edge;
    int control = 1; ///< 1 = next to the start, 2 = next to the end, in the resolved piece
    friend bool operator==(const HandleRef&, const HandleRef&) = default;
};

/// One end of a tack: 0 where a button is sewn to, 1 where it is held to.
struct TackEnd {
    pattern::TackId tack;
    std::size_t end = 0;
    friend bool operator==(const TackEnd&, const TackEnd&) = default;
};

/// One end of a pressed fold.
struct FoldEnd {
    FoldRef fold;
    std::size_t end = 0;
    friend bool operator==(const FoldEnd&, const FoldEnd&) = default;
};

/// What lies nearest to a point within a tolerance [m]; the topmost (last) piece wins.
[[nodiscard]] std::optional<VertexRef> vertexAt(const FlatPattern& pattern, Vec2 point, double tolerance);
[[nodiscard]] std::optional<HandleRef> handleAt(const FlatPattern& pattern, Vec2 point, double tolerance);
[[nodiscard]] std::optional<EdgeHit> edgeAt(const FlatPattern& pattern, Vec2 point, double tolerance);
[[nodiscard]] std::optional<pattern::PieceId> pieceAt(const FlatPattern& pattern, Vec2 point);
/// The smallest region that covers the point.
[[nodiscard]] std::optional<RegionRef> regionAt(const FlatPattern& pattern, Vec2 point);
[[nodiscard]] std::optional<pattern::SeamId> seamAt(const pattern::Pattern& document, const FlatPattern& flat,
                                                    Vec2 point, double tolerance);

[[nodiscard]] std::optional<TackEnd> tackEndAt(const pattern::Pattern& document, const FlatPattern& flat, Vec2 point,
                                               double tolerance);

[[nodiscard]] std::optional<FoldRef> foldAt(const FlatPattern& pattern, Vec2 point, double tolerance);
[[nodiscard]] std::optional<FoldEnd> foldEndAt(const FlatPattern& pattern, Vec2 point, double tolerance);

[[nodiscard]] std::optional<Vec2> positionOf(const FlatPattern& pattern, const pattern::ClothPoint& place);
[[nodiscard]] std::optional<Vec2> positionOf(const FlatPattern& pattern, const VertexRef& vertex);
[[nodiscard]] std::optional<Vec2> positionOf(const FlatPattern& pattern, const HandleRef& handle);
/// The ways of an edge from its start to its end as drawn; empty if it does not exist.
[[nodiscard]] std::vector<Vec2> pathOf(const FlatPattern& pattern, const EdgeRef& edge);

} // namespace toile::ui
