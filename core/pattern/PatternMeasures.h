// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/pattern/Pattern.h"

#include <optional>
#include <vector>

namespace toile::pattern {

/// Where an edge or a vertex stands in a piece: loop 0 is the outline, 1 … are the holes.
struct LoopIndex {
    int loop = 0;
    std::size_t index = 0;
    friend bool operator==(const LoopIndex&, const LoopIndex&) = default;
};

[[nodiscard]] std::optional<LoopIndex> findEdge(const Piece& piece, const EdgeId& edge);
[[nodiscard]] std::optional<LoopIndex> findVertex(const Piece& piece, const VertexId& vertex);
[[nodiscard]] const Contour& loopOf(const Piece& piece, int loop);
[[nodiscard]] Contour& loopOf(Piece& piece, int loop);
[[nodiscard]] geometry::Curve curveOf(const Piece& piece, const LoopIndex& edge);

/// Arc length of an edge that the piece has [m].
[[nodiscard]] double edgeLength(const Piece& piece, const EdgeId& edge);
/// Angle between the two edges that meet at a vertex of the piece, measured on the side of the cloth, in (0, 2π) [rad].
[[nodiscard]] double cornerAngle(const Piece& piece, const VertexId& vertex);
/// Polygon within chordError [m] of a contour.
[[nodiscard]] Polygon flattened(const Contour& contour, double chordError);
/// Area of cloth: the outline's less the holes' [m²].
[[nodiscard]] double areaOf(const Piece& piece);

/// The piece whose contour a piece shows: its source for a mirror piece, else itself. Null where the source is unknown
/// or is a mirror piece too.
[[nodiscard]] const Piece* shapeOf(const Pattern& pattern, const Piece& piece);

/// Arc length of a seam's part [m]; none where the piece or the edge is unknown.
[[nodiscard]] std::optional<double> partLength(const Pattern& pattern, const SeamPart& part);
/// Points of a seam's part in the piece's own coordinates, in the order the seam walks it; empty where unknown.
[[nodiscard]] std::vector<Vec2> partPoints(const Pattern& pattern, const SeamPart& part, double chordError);

/// A stretch of a seam between neighbouring notches.
struct SectionLengths {
    double a = 0, b = 0;   ///< lengths of the two sides [m]
    double wantedEase = 0; ///< a − b as declared, by ease or by gather ratio [m]

    [[nodiscard]] double mismatch() const { return a - b - wantedEase; }
};

/// The sections of a seam in its order. Where both sides have the same number of notches inside, the first meets the
/// first, and so on; otherwise the seam is one section, and also where one is declared: an ease for the whole seam.
/// None where a part is unknown or the number of declared sections is not the number found.
[[nodiscard]] std::optional<std::vector<SectionLengths>> sectionsOf(const Pattern& pattern, const Seam& seam);
/// How many the notches make, whatever is declared; 1 where a part is unknown.
[[nodiscard]] std::size_t sectionCount(const Pattern& pattern, const Seam& seam);

} // namespace toile::pattern
