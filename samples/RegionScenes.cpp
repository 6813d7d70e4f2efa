// SPDX-License-Identifier: GPL-3.0-or-later
#include "samples/RegionScenes.h"
#include "samples/Placing.h"

#include "core/material/FabricPresets.h"
#include "samples/Lathe.h"
#include "samples/Sewing.h"
#include "samples/Strokes.h"

#include <numbers>

namespace toile::samples {
namespace {

using namespace pattern;

constexpr double mainSpacing = 0.02; // [m]
constexpr double rodRadius = 0.01, rodHeight = 0.6, rodLength = 0.2;
constexpr double stripWidth = 0.1;

Region finer(const std::string& name, Vec2 low, Vec2 high) {
    Region region;
    region.id = RegionId{name};
    region.name = name;
    region.outline = {low, {high.x, low.y}, high, {low.x, high.y}};
    region.refinement = 2;
    return region;
}

/// A cloth that comes to rest soon, damped as in thick air.
document::Document documentOf(Piece piece) {
    document::Document document;
    const Fabric fabric = material::denim();
    piece.fabric = fabric.id;
    document.pattern.fabrics = {fabric};
    document.pattern.pieces = {std::move(piece)};
    document.scene.damping = 5;
    return document;
}

/// A strip along y whose short edges have a vertex each spacing, by which they can be held.
Piece strip(double length) {
    Piece piece = pieceNamed("strip", "Strip", material::denim(), mainSpacing);
    constexpr int parts = 5;
    const double x = stripWidth / 2, y = length / 2;
    std::vector<Stroke> strokes;
    for (int i = 0; i < parts; ++i) {
        const std::string name = "lower-" + std::to_string(i);
        const double from = -x + stripWidth * i / parts, to = -x + stripWidth * (i + 1) / parts;
        strokes.push_back(line(name, name, {from, -y}, {to, -y}));
    }
    strokes.push_back(line("lower-5", "right", {x, -y}, {x, y}));
    for (int i = 0; i < parts; ++i) {
        const std::string name = "upper-" + std::to_string(i);
        const double from = x - stripWidth * i / parts, to = x - stripWidth * (i + 1) / parts;
        strokes.push_back(line(name, name, {from, y}, {to, y}));
    }
    strokes.push_back(line("upper-5", "left", {-x, y}, {-x, -y}));
    piece.outline = contourOf("strip", strokes);
    return piece;
}

} // namespace

document::Document finerOverRod() {
    constexpr double length = 0.4, band = 0.08; // [m]
    Piece across = strip(length);
    across.regions = {finer("over the rod", {-stripWidth / 2, -band / 2}, {stripWidth / 2, band / 2})};
    across.placement = Placement{lyingAt({0, rodHeight + rodRadius + 0.01, 0}), {}};
    document::Document document = documentOf(across);
    document.avatarFile = "bodies/rod.glb";
    document.scene.damping = 15; // or its ends would swing through each other below the rod
    return document;
}

document::Document finerInSlack() {
    constexpr double length = 0.6, band = 0.12; // [m]
    Piece slack = strip(length);
    slack.regions = {finer("middle", {-stripWidth / 2, -band / 2}, {stripWidth / 2, band / 2})};
    // Half a circle, its ends on top: rolled about the weft, the right side down.
    slack.placement = Placement{{{1, 0, 0}, {0, 0, 1}, {0, -1, 0}, {0, 1, 0}}, Curl{{1, 0}, length / std::numbers::pi}};
    document::Document document = documentOf(slack);
    for (const char* end : {"lower-", "upper-"})
        for (int i = 0; i <= 5; ++i) {
            const std::string vertex = end + std::to_string(i);
            document.pattern.pins.push_back({PinId{"pin-" + vertex}, slack.id, vertexId(slack.id.value, vertex)});
        }
    return document;
}

geometry::TriangleMesh rodMesh() {
    std::vector<Vec2> profile{{0, -rodLength / 2}, {rodRadius / 2, -rodLength / 2}};
    constexpr int rings = 40;
    for (int i = 0; i <= rings; ++i) profile.push_back({rodRadius, rodLength * (static_cast<double>(i) / rings - 0.5)});
    profile.push_back({rodRadius / 2, rodLength / 2});
    profile.push_back({0, rodLength / 2});
    geometry::TriangleMesh mesh = lathed(profile, 48);
    for (Vec3& p : mesh.vertices) p = {p.y, rodHeight - p.x, p.z}; // from upright to along x
    return mesh;
}

} // namespace toile::samples
