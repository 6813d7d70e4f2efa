// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/pattern/Pattern.h"

namespace toile::tests {

/// A rectangle of the given size [m] with corners v1 … v4 and edges bottom, right, top, left.
inline pattern::Piece rectangle(const std::string& name, double width, double height) {
    using namespace pattern;
    Piece piece;
    piece.id = PieceId(name);
    piece.name = name;
    piece.fabric = FabricId("cotton");
    piece.outline.vertices = {{VertexId("v1"), {0, 0}},
                              {VertexId("v2"), {width, 0}},
                              {VertexId("v3"), {width, height}},
                              {VertexId("v4"), {0, height}}};
    for (const char* edge : {"bottom", "right", "top", "left"}) piece.outline.edges.push_back({EdgeId(edge), {}, {}});
    return piece;
}

/// Front and back of a tube, 0.3 × 0.4 m, sewn along both sides, and a mirror image of the front; the front's right
/// edge is an S-shaped curve.
inline pattern::Pattern twoPanels() {
    using namespace pattern;
    Piece front = rectangle("front", 0.3, 0.4), back = rectangle("back", 0.3, 0.4);
    front.outline.edges[1].shape = geometry::CubicShape{{0.33, 0.1}, {0.28, 0.3}};
    front.notches = {{EdgeId("right"), 0.25}, {EdgeId("right"), 0.75}};
    front.placement = Placement{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-0.15, 0.6, 0.2}}, {}};
    back.placement = Placement{{{-1, 0, 0}, {0, 1, 0}, {0, 0, -1}, {0.15, 0.6, -0.2}}, {}};
    Piece image;
    image.id = PieceId("image");
    image.name = "image";
    image.fabric = FabricId("cotton");
    image.mirror = MirrorOf{PieceId("front"), {0, 0}, {0, 1}};
    Fabric cotton;
    cotton.id = FabricId("cotton");
    cotton.name = "cotton";
    Seam right, left;
    right.id = SeamId("s1");
    right.name = "right side";
    right.sides = {
        {{{PieceId("front"), EdgeId("right"), 0, 1, false}}, {{PieceId("back"), EdgeId("left"), 0, 1, true}}}};
    left.id = SeamId("s2");
    left.name = "left side";
    left.sides = {
        {{{PieceId("front"), EdgeId("left"), 0, 1, false}}, {{PieceId("back"), EdgeId("right"), 0, 1, true}}}};
    return {{front, back, image}, {right, left}, {cotton}, {{PinId("n1"), PieceId("front"), VertexId("v3")}}};
}

/// The pieces of the two panels.
inline const pattern::PieceId front("front"), back("back"), image("image");

inline pattern::Pattern unsewnPanels() {
    pattern::Pattern pattern = twoPanels();
    pattern.seams.clear();
    return pattern;
}

} // namespace toile::tests
