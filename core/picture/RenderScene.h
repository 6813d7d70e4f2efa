// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Shared.h"
#include "core/body/Landmarks.h"
#include "core/picture/Colour.h"
#include "core/simulation/Frame.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace toile::picture {

/// What of a scene is drawn.
struct RenderOptions {
    bool body = true;
    bool cloth = true;
    bool seams = true;
    bool meshLines = false; ///< edges of the scan-line mesh
    bool regions = false;   ///< sub-regions tinted
    bool floor = true;      ///< a grid of 10 cm at y = 0 with the shadow of what stands on it
    bool shadows = true;    ///< cast by the key light
    friend bool operator==(const RenderOptions&, const RenderOptions&) = default;
};

/// A line through points of space.
struct Stroke {
    std::vector<Vec3> points; ///< [m]
    Colour colour;
    double width = 2;  ///< [px]
    bool onTop = true; ///< seen through everything
    friend bool operator==(const Stroke&, const Stroke&) = default;
};

/// Everything a picture of the garment shows; a value.
struct RenderScene {
    std::optional<Shared<body::Body>> body;
    std::optional<Shared<simulation::Frame>> frame;
    std::map<std::string, Colour> pieceColours; ///< of the right side, by id of the piece; absent = defaultFabricColour
    std::vector<Colour> seamColours;            ///< by index of the seam; where it ends, seamColour
    std::string selectedPiece;                  ///< id; empty = none
    RenderOptions options;
    std::vector<Stroke> overlay;
};

inline constexpr Colour defaultFabricColour{0.60f, 0.70f, 0.80f};

/// Box round the body and the cloth that are drawn; absent when there is nothing finite to see.
[[nodiscard]] std::optional<geometry::Box3> boundsOf(const RenderScene& scene);

/// The colour of a seam: neighbours in the list are far apart in hue.
[[nodiscard]] Colour seamColour(std::size_t seam);

} // namespace toile::picture
