// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pattern/CheckParts.h"
#include "core/pattern/Crossings.h"
#include "core/pattern/PatternFolds.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace toile::pattern {
namespace {

constexpr double atEnd = 1e-4; ///< what a fold may touch the border by at its own ends [m]

std::vector<BorderSegment> segmentsThrough(const std::vector<Vec2>& points, bool closed) {
    std::vector<BorderSegment> segments;
    for (std::size_t i = 0; i + (closed ? 0 : 1) < points.size(); ++i)
        segments.push_back({points[i], points[(i + 1) % points.size()], 0, i, i});
    return segments;
}

std::string millimetreText(Vec2 point) {
    return fmt::format("({:.2f}, {:.2f}) mm", 1000 * point.x, 1000 * point.y);
}

bool checkNumbers(const Piece& piece, const Fold& fold, const std::string& at, Problems& problems) {
    bool sound = true;
    const auto refuse = [&](const std::string& member, std::string text) {
        problems.error(at + member, std::move(text));
        sound = false;
    };
    if (!(std::abs(fold.angle) < 3.2)) refuse("foldAngleDegrees", "A fold angle is at most 180°.");
    if (!(fold.stiffnessFactor > 0 && std::isfinite(fold.stiffnessFactor)))
        refuse("stiffnessFactor",
               fmt::format("The stiffness factor is {}, but must be positive.", fold.stiffnessFactor));
    for (std::size_t end = 0; end < 2; ++end) {
        const std::string member = end == 0 ? "from" : "to";
        if (!findEdge(piece, fold.ends[end].edge))
            refuse(member + ".edge", fmt::format("The piece has no edge \"{}\".", fold.ends[end].edge.value));
        if (!(fold.ends[end].position >= 0 && fold.ends[end].position <= 1))
            refuse(member + ".position",
                   fmt::format("A fold ends at a fraction from 0 to 1 of an edge, but this one at {}.",
                               fold.ends[end].position));
    }
    if (!std::ranges::all_of(fold.between, [](Vec2 p) { return geometry::isFinite(p); }))
        refuse("between", "A point must have finite coordinates.");
    return sound;
}

bool isInside(const Piece& piece, Vec2 point) {
    if (geometry::windingNumber(flattened(piece.outline, checkedChordError), point) == 0) return false;
    return std::ranges::none_of(piece.holes, [&](const Contour& hole) {
        return geometry::windingNumber(flattened(hole, checkedChordError), point) != 0;
    });
}

/// A straight piece of a fold lies on the border: its middle is no farther from it than its ends may be, nor than any
/// piece's that leaves the border at 30° or more.
bool runsAlong(const std::vector<Polygon>& borders, const BorderSegment& leg) {
    const double reach = std::min(atEnd, 0.25 * geometry::distance(leg.a, leg.b));
    return std::ranges::any_of(borders, [&](const Polygon& border) {
        return geometry::distanceToBorder(border, geometry::lerp(leg.a, leg.b, 0.5)) <= reach;
    });
}

/// The fold runs through the piece, and meets its border at its ends only.
void checkCourse(const Piece& piece, const Fold& fold, const std::vector<Vec2>& line, const std::string& at,
                 Problems& problems) {
    const auto refuse = [&](Vec2 point) {
        problems.error(at + "between",
                       fmt::format("The fold \"{}\" leaves the piece at {}.", fold.name, millimetreText(point)));
    };
    std::vector<Polygon> borders;
    for (int loop = 0; loop <= static_cast<int>(piece.holes.size()); ++loop)
        borders.push_back(flattened(loopOf(piece, loop), checkedChordError));
    const std::vector<BorderSegment> legs = segmentsThrough(line, false);
    for (const Polygon& polygon : borders)
        for (const BorderSegment& border : segmentsThrough(polygon, true))
            for (const BorderSegment& own : legs)
                if (const auto point = meeting(own, border); point &&
                                                             geometry::distance(*point, line.front()) > atEnd &&
                                                             geometry::distance(*point, line.back()) > atEnd)
                    return refuse(*point);
    for (const BorderSegment& own : legs) {
        const Vec2 middle = geometry::lerp(own.a, own.b, 0.5);
        if (runsAlong(borders, own))
            return problems.error(at + "between", fmt::format("The fold \"{}\" runs along the border at {}.", fold.name,
                                                              millimetreText(middle)));
        if (!isInside(piece, middle)) return refuse(middle);
    }
}

void checkFold(const Piece& piece, std::size_t number, const std::vector<std::vector<Vec2>>& lines,
               const std::string& at, Problems& problems) {
    const Fold& fold = piece.folds[number];
    const std::vector<Vec2>& line = lines[number];
    double length = 0;
    for (const BorderSegment& own : segmentsThrough(line, false)) length += geometry::distance(own.a, own.b);
    if (!(length > 1e-3) || fold.ends[0] == fold.ends[1])
        return problems.error(at + "to", fmt::format("The fold \"{}\" ends where it begins.", fold.name));
    checkCourse(piece, fold, line, at, problems);
    const std::vector<BorderSegment> own = segmentsThrough(line, false);
    for (std::size_t i = 0; i < own.size(); ++i)
        for (std::size_t j = 0; j + 1 < i; ++j)
            if (meeting(own[i], own[j]))
                return problems.error(at + "between", fmt::format("The fold \"{}\" crosses itself.", fold.name));
    for (std::size_t other = 0; other < number; ++other)
        for (const BorderSegment& q : segmentsThrough(lines[other], false))
            for (const BorderSegment& p : own)
                if (const auto point = meeting(p, q))
                    return problems.error(at + "between",
                                          fmt::format("The fold \"{}\" crosses the fold \"{}\" at {}.", fold.name,
                                                      piece.folds[other].name, millimetreText(*point)));
}

} // namespace

void checkFolds(const Piece& piece, Problems& problems) {
    std::vector<std::vector<Vec2>> lines(piece.folds.size());
    for (std::size_t i = 0; i < piece.folds.size(); ++i) {
        const std::string at = fmt::format("folds[{}].", i);
        if (!checkNumbers(piece, piece.folds[i], at, problems)) continue;
        lines[i] = pointsOf(piece, piece.folds[i]);
        checkFold(piece, i, lines, at, problems);
    }
}

} // namespace toile::pattern
