// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/pattern/Editing.h"
#include "core/pattern/Ids.h"

namespace toile::pattern {

// Edits of whole pieces. All are pure.

constexpr int outermostLayer = 100;
constexpr double mostPressure = 10'000; ///< [Pa]

/// Adds a piece that has its id (IdSource, contourThrough). Error when the id is taken or the outline is empty.
[[nodiscard]] Result<Pattern> addPiece(const Pattern& pattern, Piece piece);
/// Adds a mirror image: its shape follows every edit of its source; fabric, interfacing, plies, layer, pressure and
/// whether it is frozen or strengthened are its own and begin as the source's. The line goes through two points of the
/// source [m].
[[nodiscard]] Result<Pattern> addMirrorPiece(const Pattern& pattern, const PieceId& source, Vec2 lineStart,
                                             Vec2 lineEnd, std::string name, IdSource& ids);
/// Adds a copy that goes its own way, with ids of its own and without seams, pins and tacks. A copy of a mirror image
/// follows the same source.
[[nodiscard]] Result<Pattern> duplicatePiece(const Pattern& pattern, const PieceId& piece, std::string name,
                                             IdSource& ids);
/// Its mirror images, seams, pins and tacks go with it; a warning names each.
[[nodiscard]] Result<Edited> deletePiece(const Pattern& pattern, const PieceId& piece);

[[nodiscard]] Result<Pattern> renamePiece(const Pattern& pattern, const PieceId& piece, std::string name);
/// Moves the piece on the pattern table; its shape and its place in space stay.
[[nodiscard]] Result<Pattern> movePiece(const Pattern& pattern, const PieceId& piece, Vec2 tablePosition);
/// Direction of warp from +y, counter-clockwise [rad].
[[nodiscard]] Result<Pattern> setGrain(const Pattern& pattern, const PieceId& piece, double grain);
/// ε_m [m].
[[nodiscard]] Result<Pattern> setSpacing(const Pattern& pattern, const PieceId& piece, double spacing);
[[nodiscard]] Result<Pattern> setSeamAllowance(const Pattern& pattern, const PieceId& piece, double allowance);
/// Where pieces overlap, the higher layer lies outside; 0 to 100.
[[nodiscard]] Result<Pattern> setLayer(const Pattern& pattern, const PieceId& piece, int layer);
/// Of the air behind the piece, towards its right side; −10 000 to 10 000 Pa.
[[nodiscard]] Result<Pattern> setPressure(const Pattern& pattern, const PieceId& piece, double pressure);
/// Its cloth stays where it lies, as if all of it were pinned, while the rest goes on.
[[nodiscard]] Result<Pattern> setFrozen(const Pattern& pattern, const PieceId& piece, bool frozen);
/// Stiffer to bend for the time being, so that it does not crumple while it is arranged and sewn.
[[nodiscard]] Result<Pattern> setStrengthened(const Pattern& pattern, const PieceId& piece, bool strengthened);
[[nodiscard]] Result<Pattern> setLineRule(const Pattern& pattern, const PieceId& piece, LineRule rule);
[[nodiscard]] Result<Pattern> setRegionBorder(const Pattern& pattern, const PieceId& piece, RegionBorder border);

/// Lays all pieces out on the table in rows, so that none covers another.
[[nodiscard]] Pattern laidOut(const Pattern& pattern);
/// Some pieces cover each other on the table, as in a pattern that was never laid out.
[[nodiscard]] bool piecesCoverEachOther(const Pattern& pattern);

/// Holds a vertex where it lies. Error when it is held already.
[[nodiscard]] Result<Pattern> addPin(const Pattern& pattern, const PieceId& piece, const VertexId& vertex,
                                     IdSource& ids);
[[nodiscard]] Result<Pattern> removePin(const Pattern& pattern, const PinId& pin);
/// Where the body moves, the vertex is carried along instead of staying where it is.
[[nodiscard]] Result<Pattern> setPinToBody(const Pattern& pattern, const PinId& pin, bool toBody);

} // namespace toile::pattern
