// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pattern/Brush.h"
#include "core/pattern/CheckParts.h"
#include "core/pattern/Crossings.h"
#include "core/pattern/PatternMeasures.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace toile::pattern {
namespace {

constexpr double shortestEdge = 1e-6; ///< neighbours nearer than this leave no edge [m]
constexpr double largest = 100;       ///< a garment's coordinates are smaller [m]

std::string loopPath(int loop) {
    return loop == 0 ? "" : fmt::format("holes[{}].", loop - 1);
}
const char* loopName(int loop) {
    return loop == 0 ? "outline" : "hole";
}

bool isSmall(Vec2 p) {
    return std::abs(p.x) < largest && std::abs(p.y) < largest;
} // false for NaN

bool isSmall(const EdgeShape& shape) {
    if (const auto* cubic = std::get_if<geometry::CubicShape>(&shape))
        return isSmall(cubic->control1) && isSmall(cubic->control2);
    if (const auto* arc = std::get_if<geometry::ArcShape>(&shape)) return std::abs(arc->bulge) < 1000;
    return true;
}

bool checkNumbers(const Contour& contour, int loop, Problems& problems) {
    const std::string at = loopPath(loop);
    const std::size_t n = contour.vertices.size();
    if (n < 3 || contour.edges.size() != n) {
        problems.error(at + "vertices",
                       fmt::format("A contour needs at least three points, but this {} has {}.", loopName(loop), n));
        return false;
    }
    bool sound = true;
    const auto refuse = [&](const std::string& member, std::string text) {
        problems.error(at + member, std::move(text));
        sound = false;
    };
    for (std::size_t i = 0; i < n; ++i) {
        if (!isSmall(contour.vertices[i].position))
            refuse(fmt::format("vertices[{}]", i), "A point must have finite coordinates below 100 m.");
        if (!isSmall(contour.edges[i].shape))
            refuse(fmt::format("edges[{}]", i),
                   "The shape of an edge must have finite numbers, coordinates below 100 m.");
        if (contour.edges[i].seamAllowance && !(*contour.edges[i].seamAllowance >= 0))
            refuse(fmt::format("edges[{}].seamAllowance", i), "A seam allowance cannot be negative.");
    }
    for (std::size_t i = 0; sound && i < n; ++i)
        if (geometry::distance(contour.vertices[i].position, contour.vertices[(i + 1) % n].position) < shortestEdge)
            refuse(fmt::format("edges[{}]", i),
                   fmt::format("The edge \"{}\" has no length: its two points coincide.", contour.edges[i].id.value));
    return sound;
}

bool checkOrientation(const Contour& contour, int loop, Problems& problems) {
    const double area = geometry::signedArea(flattened(contour, checkedChordError));
    if (std::abs(area) < 1e-10) {
        problems.error(loopPath(loop) + "vertices", fmt::format("The {} encloses no area.", loopName(loop)));
        return false;
    }
    if ((area > 0) == (loop == 0)) return true;
    problems.error(
        loopPath(loop) + "vertices",
        loop == 0 ? "The outline runs clockwise, but must run counter-clockwise seen from the right side of the cloth."
                  : "The hole runs counter-clockwise, but must run clockwise.");
    return false;
}

/// The segments of all loops; loopLengths gets the number of each.
std::vector<BorderSegment> segmentsOf(const Piece& piece, std::vector<std::size_t>& loopLengths) {
    std::vector<BorderSegment> segments;
    for (int loop = 0; loop <= static_cast<int>(piece.holes.size()); ++loop) {
        const Contour& contour = loopOf(piece, loop);
        std::size_t order = 0;
        for (std::size_t edge = 0; edge < contour.edges.size(); ++edge) {
            const auto points = geometry::flattened(curveOf(contour, edge), checkedChordError);
            for (std::size_t i = 1; i < points.size(); ++i)
                if (points[i - 1] != points[i]) segments.push_back({points[i - 1], points[i], loop, edge, order++});
        }
        loopLengths.push_back(order);
    }
    return segments;
}

bool checkCrossings(const Piece& piece, Problems& problems) {
    std::vector<std::size_t> loopLengths;
    auto segments = segmentsOf(piece, loopLengths);
    const auto crossing = firstCrossing(std::move(segments), loopLengths);
    if (!crossing) return true;
    // The later edge is named first: it is usually the one that was moved.
    const bool swap =
        std::pair(crossing->first.loop, crossing->first.edge) > std::pair(crossing->second.loop, crossing->second.edge);
    const BorderSegment& one = swap ? crossing->second : crossing->first;
    const BorderSegment& other = swap ? crossing->first : crossing->second;
    const auto name = [&](const BorderSegment& s) { return loopOf(piece, s.loop).edges[s.edge].id.value; };
    problems.error(fmt::format("{}edges[{}]", loopPath(one.loop), one.edge),
                   one.loop == other.loop && one.edge == other.edge
                       ? fmt::format("The edge \"{}\" crosses itself at ({:.2f}, {:.2f}) mm.", name(one),
                                     mm(crossing->point.x), mm(crossing->point.y))
                       : fmt::format("The edges \"{}\" and \"{}\" cross or touch at ({:.2f}, {:.2f}) mm.", name(one),
                                     name(other), mm(crossing->point.x), mm(crossing->point.y)));
    return false;
}

bool checkNesting(const Piece& piece, Problems& problems) {
    const Polygon outline = flattened(piece.outline, checkedChordError);
    bool sound = true;
    for (std::size_t i = 0; i < piece.holes.size(); ++i) {
        const Vec2 point = piece.holes[i].vertices.front().position; // nothing crosses: one point speaks for all
        const auto refuse = [&](const char* text) {
            problems.error(fmt::format("holes[{}]", i), text);
            sound = false;
        };
        if (geometry::windingNumber(outline, point) == 0) refuse("The hole lies outside the piece.");
        for (std::size_t j = 0; j < piece.holes.size(); ++j)
            if (j != i && geometry::windingNumber(flattened(piece.holes[j], checkedChordError), point) != 0)
                refuse("The hole lies inside another hole.");
    }
    return sound;
}

bool checkRegionNumbers(const Region& region, const std::string& at, Problems& problems) {
    const auto usable = [](const Polygon& polygon) {
        return polygon.size() >= 3 && std::ranges::all_of(polygon, [](Vec2 p) { return isSmall(p); });
    };
    bool sound = true;
    const auto refuse = [&](const char* member, std::string text) {
        problems.error(at + member, std::move(text));
        sound = false;
    };
    if (!usable(region.outline)) refuse("outline", "A region needs at least three corners with finite coordinates.");
    else if (std::abs(geometry::signedArea(region.outline)) < 1e-10) refuse("outline", "The region encloses no area.");
    for (std::size_t i = 0; i < region.holes.size(); ++i)
        if (!usable(region.holes[i]))
            refuse("holes", "A hole of a region needs at least three corners with finite coordinates.");
    if (region.refinement < 0)
        refuse("refinement", fmt::format("The refinement is {}, but must be 0 or more.", region.refinement));
    for (const double factor : {region.stiffness.stretch, region.stiffness.shear, region.stiffness.bending})
        if (!(factor > 0 && std::isfinite(factor))) {
            refuse("stiffness", fmt::format("A stiffness factor is {}, but must be positive.", factor));
            break;
        }
    return sound;
}

} // namespace

bool checkContours(const Piece& piece, Problems& problems) {
    bool sound = true;
    for (int loop = 0; loop <= static_cast<int>(piece.holes.size()); ++loop)
        sound = checkNumbers(loopOf(piece, loop), loop, problems) && sound;
    if (!sound || !checkCrossings(piece, problems)) return false; // a crossing border has no orientation
    for (int loop = 0; loop <= static_cast<int>(piece.holes.size()); ++loop)
        sound = checkOrientation(loopOf(piece, loop), loop, problems) && sound;
    return sound && checkNesting(piece, problems);
}

void checkRegions(const Piece& piece, Problems& problems) {
    const std::vector<Area> cloth{{flattened(piece.outline, checkedChordError), {}}};
    for (std::size_t i = 0; i < piece.regions.size(); ++i) {
        const Region& region = piece.regions[i];
        const std::string at = fmt::format("regions[{}].", i);
        if (!checkRegionNumbers(region, at, problems)) continue;
        if (const auto crossing = firstCrossing(region.outline))
            problems.error(
                at + "outline",
                fmt::format("The border of the region \"{}\" crosses or touches itself at ({:.2f}, {:.2f}) mm.",
                            region.name, mm(crossing->point.x), mm(crossing->point.y)));
        else if (intersectionOf(cloth, {{region.outline, {}}}).empty())
            problems.error(at + "outline", fmt::format("The region \"{}\" lies outside the piece.", region.name));
    }
}

} // namespace toile::pattern
