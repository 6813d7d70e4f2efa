// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/pattern/Editing.h"

namespace toile::pattern {

constexpr int mostPlies = 8;

// Edits of the fabrics of a pattern. All are pure.

/// Adds a fabric that has its id. Error when the id is taken or a constant makes no sense.
[[nodiscard]] Result<Pattern> addFabric(const Pattern& pattern, Fabric fabric);
/// Puts new constants in the place of the fabric with the same id.
[[nodiscard]] Result<Pattern> replaceFabric(const Pattern& pattern, Fabric fabric);
/// Error when a piece is cut from it.
[[nodiscard]] Result<Pattern> removeFabric(const Pattern& pattern, const FabricId& fabric);
/// Cuts a piece from another fabric.
[[nodiscard]] Result<Pattern> setPieceFabric(const Pattern& pattern, const PieceId& piece, const FabricId& fabric);
/// Fuses interlining to a piece; absent takes it off. Error when its numbers make no sense.
[[nodiscard]] Result<Pattern> setInterfacing(const Pattern& pattern, const PieceId& piece,
                                             const std::optional<Interfacing>& interfacing);

/// Cuts a piece from so many plies of its fabric, 1 to mostPlies.
[[nodiscard]] Result<Pattern> setPlies(const Pattern& pattern, const PieceId& piece, int plies);

/// Factor on all bending stiffnesses of a strengthened piece [–]. Cloth holds itself up over the cube root of it, 4.6
/// times as far: as far as a hand is wide, where a shirting does it for 2 cm. Stretch and shear, by which cloth is
/// stiff for its weight as it is, stay.
constexpr double strengthening = 100;

/// What a piece is made of: all plies of its fabric, one of them with its interfacing, strengthened if it is. Nothing
/// for a fabric that there is not.
[[nodiscard]] std::optional<Fabric> clothOf(const Pattern& pattern, const Piece& piece);

} // namespace toile::pattern
