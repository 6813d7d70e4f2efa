// SPDX-License-Identifier: GPL-3.0-or-later
#include "samples/CircleSkirt.h"

#include "core/material/FabricPresets.h"
#include "samples/Strokes.h"
#include "samples/Waistband.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace toile::samples {
namespace {

using namespace pattern;

/// Half a ring about the origin, on x ≥ 0: the centre front at −y, the centre back at +y.
std::vector<Stroke> halfRing(double inner, double outer) {
    const double quarter = std::tan(std::numbers::pi / 8); // bulge of a quarter circle
    return {arc("hem-front", "hem-front", {0, -outer}, quarter, {outer, 0}),
            arc("hem-side", "hem-back", {outer, 0}, quarter, {0, outer}),
            line("hem-back", "centre-back", {0, outer}, {0, inner}),
            arc("waist-back", "waist-back", {0, inner}, -quarter, {inner, 0}),
            arc("waist-side", "waist-front", {inner, 0}, -quarter, {0, -inner}),
            line("waist-front", "centre-front", {0, -inner}, {0, -outer})};
}

constexpr double droop = 0.30; // each half falls away to its side, just enough to pass beneath the hands [rad]
constexpr double below = 0.01; // the ridge lies so far below the waistband, which stands round the body already [m]

/// The half plane that falls to the left from a ridge over the centre line, as near as the body lets it come.
/// Seen from outside, the piece's −y is forward.
Placement placedHalf(const body::Body& body, double inner, double outer, double height) {
    const double c = std::cos(droop), s = std::sin(droop), clearance = 0.015;
    Placement placement{{{c, -s, 0}, {0, 0, -1}, {s, c, 0}, {0, height - below, body.landmarks.waist.z}}, {}};
    Transform& frame = placement.transform;
    const auto isTouched = [&](const Vec3& vertex) {
        const Vec3 d = vertex - frame.origin;
        const double u = dot(d, frame.axisX), v = dot(d, frame.axisY), r = std::hypot(u, v);
        return u > -clearance && r > inner - clearance && r < outer && std::abs(dot(d, frame.axisZ)) < clearance;
    };
    while (std::ranges::any_of(body.mesh.vertices, isTouched) && frame.origin.x < 0.3) frame.origin.x += 0.002;
    return placement;
}

} // namespace

document::Document circleSkirt(const body::Measurements& m, const body::Body& body, const CircleSkirtSettings& s) {
    const Fabric fabric = material::poplin(), stiff = interlined(fabric);
    const double waist = m.waist + s.waistEase, inner = waist / (2 * std::numbers::pi), lowered = s.waistbandWidth / 2;

    Piece left = pieceNamed("skirt-left", "Skirt left", fabric, s.spacing);
    left.outline = contourOf("skirt-left", halfRing(inner, inner + s.length));
    left.placement = placedHalf(body, inner, inner + s.length, body.landmarks.waist.y - lowered);
    const Piece right = mirrorPiece("skirt-right", "Skirt right", left);
    const Piece band =
        draftWaistband(stiff, body, {waist, s.waistbandWidth, std::min(s.spacing, waistbandSpacing)}, lowered);

    document::Document document;
    document.pattern.fabrics = {fabric, stiff};
    document.pattern.pieces = {left, right, band};
    document.pattern.seams = {
        seam("centre front", {along(left, "centre-front")}, {along(right, "centre-front")}),
        seam("centre back", {along(left, "centre-back")}, {along(right, "centre-back")}),
        seam("waist left", {against(left, "waist-front"), against(left, "waist-back")}, {along(band, "bottom-left")}),
        seam("waist right", {along(right, "waist-back"), along(right, "waist-front")}, {along(band, "bottom-right")}),
        waistbandSeam(band),
    };
    hangOnWaistband(document);
    return document;
}

} // namespace toile::samples
