// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "samples/Sewing.h"
#include "samples/Sleeve.h"

#include "core/body/Landmarks.h"

#include <functional>

namespace toile::samples {

// What blouse and T-shirt have in common: how halves drafted by draftUpperBlock get notches, sleeves and seams.

/// The edges of half a front or back by their names in the block, each walked from the hem up to the neck.
using HalfEdges = std::function<Side(const std::string& edge)>;

/// Of a piece that is one half, or its mirror image.
[[nodiscard]] HalfEdges halfOf(const pattern::Piece& piece);
/// Of the half on +x, or on −x, of a piece made by wholeFromHalf with that suffix.
[[nodiscard]] HalfEdges positiveHalf(const pattern::Piece& piece, const std::string& suffix);
[[nodiscard]] HalfEdges negativeHalf(const pattern::Piece& piece, const std::string& suffix);

struct NotchDistances {
    double front = 0.080, back = 0.085; ///< on the armhole, from the underarm [m]
};

/// A notch on an armhole that runs from the underarm to the shoulder, or against it; the back's is double.
[[nodiscard]] pattern::Notch armholeNotch(const pattern::Piece& piece, const std::string& edge, double fromUnderarm,
                                          bool runsUp, bool isBack);

struct SleevePiece {
    pattern::Piece piece;
    Sleeve draft;
};

/// The left sleeve with its notches, not yet placed.
[[nodiscard]] Result<SleevePiece> draftSleevePiece(const pattern::Fabric& fabric, double spacing,
                                                   const Armholes& armholes, const SleeveSettings& settings);

/// Wraps the left sleeve round the arm, as far up as the shoulder lets it. Returns how far down the arm line its bottom
/// lies [m].
double placeSleeve(SleevePiece& sleeve, const body::Body& body);

/// Shoulder and side seam of one side.
[[nodiscard]] std::vector<pattern::Seam> sewSide(const std::string& side, const HalfEdges& front,
                                                 const HalfEdges& back);

/// The sleeve into its armhole, and its own seam.
[[nodiscard]] std::vector<pattern::Seam> sewSleeve(const std::string& side, const pattern::Piece& sleeve,
                                                   const HalfEdges& front, const HalfEdges& back,
                                                   const SleeveSettings& settings);

} // namespace toile::samples
