// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pattern/Brush.h"

#include <algorithm>
#include <clipper.hpp>
#include <cmath>

namespace toile::pattern {
namespace {

using geometry::Polygon;

constexpr double unitsPerMetre = 1e8; // Clipper counts in integers; below 10 m it needs no wide arithmetic

ClipperLib::Path pathOf(std::span<const Vec2> points) {
    ClipperLib::Path path;
    for (const Vec2 p : points) path.emplace_back(std::llround(p.x * unitsPerMetre), std::llround(p.y * unitsPerMetre));
    return path;
}

ClipperLib::Paths pathsOf(const std::vector<Area>& areas) {
    ClipperLib::Paths paths;
    for (const Area& area : areas) {
        paths.push_back(pathOf(area.outline));
        for (const Polygon& hole : area.holes) paths.push_back(pathOf(hole));
    }
    return paths;
}

Polygon polygonOf(const ClipperLib::Path& path) {
    Polygon polygon;
    for (const auto& p : path)
        polygon.push_back({static_cast<double>(p.X) / unitsPerMetre, static_cast<double>(p.Y) / unitsPerMetre});
    return polygon;
}

/// Outlines are on even levels of the tree, their holes below them, islands in holes below those.
void collect(const ClipperLib::PolyNode& node, std::vector<Area>& areas) {
    for (const ClipperLib::PolyNode* outer : node.Childs) {
        Area area{polygonOf(outer->Contour), {}};
        for (const ClipperLib::PolyNode* hole : outer->Childs) {
            area.holes.push_back(polygonOf(hole->Contour));
            collect(*hole, areas);
        }
        areas.push_back(std::move(area));
    }
}

std::vector<Area> areasOf(const ClipperLib::PolyTree& tree) {
    std::vector<Area> areas;
    collect(tree, areas);
    std::ranges::sort(areas, std::greater{}, [](const Area& area) { return geometry::signedArea(area.outline); });
    return areas;
}

std::vector<Area> combined(ClipperLib::ClipType how, const std::vector<Area>& a, const std::vector<Area>& b) {
    ClipperLib::Clipper clipper;
    clipper.StrictlySimple(true);
    clipper.AddPaths(pathsOf(a), ClipperLib::ptSubject, true);
    clipper.AddPaths(pathsOf(b), ClipperLib::ptClip, true);
    ClipperLib::PolyTree tree;
    clipper.Execute(how, tree, ClipperLib::pftNonZero, ClipperLib::pftNonZero);
    return areasOf(tree);
}

} // namespace

std::vector<Area> swept(std::span<const Vec2> stroke, double radius) {
    constexpr double miterLimit = 2; // of no use to round joins
    ClipperLib::ClipperOffset offset(miterLimit, radius / 50 * unitsPerMetre);
    offset.AddPath(pathOf(stroke), ClipperLib::jtRound, ClipperLib::etOpenRound);
    ClipperLib::PolyTree tree;
    offset.Execute(tree, radius * unitsPerMetre);
    return areasOf(tree);
}

std::vector<Area> unionOf(const std::vector<Area>& a, const std::vector<Area>& b) {
    return combined(ClipperLib::ctUnion, a, b);
}

std::vector<Area> differenceOf(const std::vector<Area>& a, const std::vector<Area>& b) {
    return combined(ClipperLib::ctDifference, a, b);
}

std::vector<Area> intersectionOf(const std::vector<Area>& a, const std::vector<Area>& b) {
    return combined(ClipperLib::ctIntersection, a, b);
}

} // namespace toile::pattern
