// SPDX-License-Identifier: GPL-3.0-or-later
#include "samples/GatheredSkirt.h"

#include "core/material/FabricPresets.h"
#include "samples/Strokes.h"
#include "samples/Waistband.h"

#include <algorithm>
#include <numbers>

namespace toile::samples {
namespace {

using namespace pattern;

/// A rectangle below y = 0, its middle at x = 0; `a` is its +x half.
Piece panel(const char* id, const char* name, const Fabric& fabric, double width, const GatheredSkirtSettings& s) {
    Piece piece = pieceNamed(id, name, fabric, s.spacing);
    const double half = width / 2;
    const Vec2 hemB{-half, -s.length}, hemA{half, -s.length}, waistA{half, 0}, middle{0, 0}, waistB{-half, 0};
    piece.outline = contourOf(id, {line("hem-b", "hem", hemB, hemA), line("hem-a", "side-a", hemA, waistA),
                                   line("waist-a", "waist-a", waistA, middle),
                                   line("middle", "waist-b", middle, waistB), line("waist-b", "side-b", waistB, hemB)});
    return piece;
}

} // namespace

document::Document gatheredSkirt(const body::Measurements& m, const body::Body& body, const GatheredSkirtSettings& s) {
    const Fabric fabric = material::poplin(), stiff = interlined(fabric);
    const double waist = m.waist + s.waistEase, width = s.gatherRatio * waist / 2, lowered = s.waistbandWidth / 2;

    const double top = body.landmarks.waist.y - lowered;
    const Ring ring = ringRound(body, top - s.length, top, 0.015);
    const double radius = std::max(ring.radius, width / (0.97 * std::numbers::pi));
    const Curl halfRing{{0, 1}, radius};
    Piece front = panel("skirt-front", "Skirt front", fabric, width, s);
    front.placement = Placement{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, top, ring.centre.z + radius}}, halfRing};
    Piece back = panel("skirt-back", "Skirt back", fabric, width, s);
    back.placement = Placement{{{-1, 0, 0}, {0, 1, 0}, {0, 0, -1}, {0, top, ring.centre.z - radius}}, halfRing};
    const Piece band =
        draftWaistband(stiff, body, {waist, s.waistbandWidth, std::min(s.spacing, waistbandSpacing)}, lowered);

    document::Document document;
    document.pattern.fabrics = {fabric, stiff};
    document.pattern.pieces = {front, back, band};
    document.pattern.seams = {
        seam("side left", {along(front, "side-a")}, {against(back, "side-b")}),
        seam("side right", {along(back, "side-a")}, {against(front, "side-b")}),
        seam("waist left", {against(front, "waist-a"), against(back, "waist-b")}, {along(band, "bottom-left")}),
        seam("waist right", {against(back, "waist-a"), against(front, "waist-b")}, {along(band, "bottom-right")}),
        waistbandSeam(band),
    };
    for (const std::size_t gathered : {2, 3})
        document.pattern.seams[gathered].sections = {{.ease = 0, .gatherRatio = s.gatherRatio}};
    hangOnWaistband(document);
    return document;
}

} // namespace toile::samples
