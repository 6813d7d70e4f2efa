// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/meshing/Regions.h"

#include "core/meshing/Flags.h"
#include "core/meshing/PolygonOverlap.h"
#include "core/meshing/RegionBorderPath.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>

namespace toile::meshing {
namespace {

std::size_t at(int i) {
    return static_cast<std::size_t>(i);
}

constexpr double largestCellCount = 1e7;
constexpr double borderMoveWarned = 0.5; ///< of ε_m [–]

using Polygons = std::vector<Polygon>;

Polygons paintedBorders(const RegionInput& region, const PieceFrame& frame) {
    Polygons borders;
    const auto add = [&](const Polygon& polygon) {
        Polygon& turned = borders.emplace_back();
        for (const Vec2 p : polygon) turned.push_back(frame.frameOf(p));
    };
    add(region.outline);
    for (const Polygon& hole : region.holes) add(hole);
    return borders;
}

Polygons contoursInFrame(const PieceBoundary& boundary) {
    Polygons contours;
    for (const auto& ring : boundary.contours) {
        Polygon& polygon = contours.emplace_back();
        for (const GridPoint p : ring)
            polygon.push_back(Vec2{static_cast<double>(p.x), static_cast<double>(p.y)} * boundary.frame.unit);
    }
    return contours;
}

/// The cells inside closed paths of main lines, by parity.
std::vector<char> cellsInside(const std::vector<LatticePath>& paths, const Lattice& lattice) {
    std::vector<char> inside(at(lattice.columns() * lattice.rows()), 0);
    for (const LatticePath& path : paths)
        for (std::size_t i = 0; i < path.size(); ++i) {
            const LatticePoint p = path[i], q = path[(i + 1) % path.size()];
            if (p.column != q.column) continue;
            for (int row = std::min(p.row, q.row); row < std::max(p.row, q.row); ++row)
                for (int column = p.column; column < lattice.columns(); ++column)
                    inside[at(lattice.cell(column, row))] ^= 1;
        }
    return inside;
}

Polygons asPolygons(const std::vector<LatticePath>& paths, const Lattice& lattice) {
    Polygons polygons;
    for (const LatticePath& path : paths) {
        Polygon& polygon = polygons.emplace_back();
        for (const LatticePoint p : path)
            polygon.push_back({lattice.mainX()[at(p.column)], lattice.mainY()[at(p.row)]});
    }
    return polygons;
}

double distanceToBorders(const Polygons& borders, Vec2 point) {
    double best = 1e300;
    for (const Polygon& border : borders)
        if (!border.empty()) best = std::min(best, geometry::distanceToBorder(border, point));
    return best;
}

/// Largest distance from the part of one border inside the piece to the other border, sampled.
double oneSidedDistance(const Polygons& from, const Polygons& to, const Polygons& piece, double spacing) {
    double perimeter = 0;
    for (const Polygon& border : from)
        for (std::size_t i = 0; i < border.size(); ++i)
            perimeter += distance(border[i], border[(i + 1) % border.size()]);
    const double step = std::max(spacing / 8, perimeter / 2000);
    double worst = 0;
    for (const Polygon& border : from)
        for (std::size_t i = 0; i < border.size(); ++i) {
            const Vec2 a = border[i], b = border[(i + 1) % border.size()];
            const int parts = std::max(1, static_cast<int>(std::ceil(distance(a, b) / step)));
            for (int k = 0; k < parts; ++k) {
                const Vec2 sample = lerp(a, b, static_cast<double>(k) / parts);
                const double here = distanceToBorders(to, sample);
                if (here > worst && covers(piece, sample)) worst = here;
            }
        }
    return worst;
}

std::optional<Error> regionError(const PieceInput& piece, const RegionInput& region, const Polygons& painted,
                                 const Polygons& contours) {
    const auto error = [&](const std::string& text) {
        return Error{ErrorCode::invalidInput, text, {.object = nameOf(piece) + ", region \"" + region.label + "\""}};
    };
    if (region.outline.size() < 3) return error("The border of the region needs at least three points.");
    if (overlapArea(painted, contours) <= 1e-12 * piece.spacing * piece.spacing + 1e-14)
        return error("The region lies outside the piece.");
    return std::nullopt;
}

struct SnappedRegion {
    std::vector<char> cells;
    RegionReport report;
};

SnappedRegion snapped(const PieceInput& piece, const RegionInput& region, const Polygons& painted,
                      const Polygons& contours, const Lattice& lattice) {
    std::vector<LatticePath> paths;
    for (const Polygon& border : painted)
        if (border.size() >= 3) paths.push_back(nearestLatticePath(border, lattice));
    SnappedRegion result{cellsInside(paths, lattice), {}};
    result.report.label = region.label;
    result.report.ratio = 1 << region.refinement;
    result.report.spacing = piece.spacing / result.report.ratio;
    const Polygons final = asPolygons(paths, lattice);
    result.report.displacement = std::max(oneSidedDistance(painted, final, contours, piece.spacing),
                                          oneSidedDistance(final, painted, contours, piece.spacing));
    result.report.areaChange = overlapArea(final, contours) - overlapArea(painted, contours);
    return result;
}

void warnOfOverlaps(const PieceInput& piece, const std::vector<SnappedRegion>& regions, const Lattice& lattice,
                    std::vector<Warning>& warnings) {
    for (std::size_t i = 0; i < regions.size(); ++i)
        for (std::size_t j = i + 1; j < regions.size(); ++j) {
            int common = 0;
            for (std::size_t c = 0; c < lattice.active.size(); ++c)
                common += lattice.active[c] && regions[i].cells[c] && regions[j].cells[c];
            if (common > 0)
                warnings.push_back({nameOf(piece), "Regions \"" + regions[i].report.label + "\" and \"" +
                                                       regions[j].report.label + "\" share " + std::to_string(common) +
                                                       " main cells; the finer one counts there."});
        }
}

} // namespace

Result<std::vector<RegionReport>> snapRegions(const PieceInput& piece, const PieceBoundary& boundary, Lattice& lattice,
                                              std::vector<Warning>& warnings) {
    std::vector<RegionReport> reports;
    if (piece.regions.empty()) return reports;
    const Polygons contours = contoursInFrame(boundary);
    std::vector<SnappedRegion> regions;
    for (const RegionInput& region : piece.regions) {
        const Polygons painted = paintedBorders(region, boundary.frame);
        if (auto error = regionError(piece, region, painted, contours)) return tl::unexpected(*error);
        regions.push_back(snapped(piece, region, painted, contours, lattice));
        const RegionReport& report = regions.back().report;
        if (report.displacement > borderMoveWarned * piece.spacing)
            warnings.push_back({nameOf(piece), "The border of region \"" + region.label + "\" moved by " +
                                                   millimetres(report.displacement) + " to the main mesh of " +
                                                   millimetres(piece.spacing) + "."});
    }
    warnOfOverlaps(piece, regions, lattice, warnings);
    lattice.makeDivisible();
    for (std::size_t r = 0; r < regions.size(); ++r)
        for (std::size_t c = 0; c < lattice.division.size(); ++c) {
            if (!regions[r].cells[c]) continue;
            const int u = regions[r].report.ratio;
            if (lattice.region[c] >= 0 && lattice.division[c] >= u) continue;
            lattice.division[c] = u;
            lattice.region[c] = static_cast<int>(r);
        }
    for (std::size_t c = 0; c < lattice.division.size(); ++c)
        if (lattice.active[c] && lattice.region[c] >= 0) ++regions[at(lattice.region[c])].report.cells;
    for (const SnappedRegion& region : regions) {
        if (region.report.cells == 0)
            return fail(ErrorCode::invalidInput,
                        "The region has no cell left after snapping to the main mesh of " + millimetres(piece.spacing) +
                            "; make it larger, or the main mesh finer.",
                        {.object = nameOf(piece) + ", region \"" + region.report.label + "\""});
        reports.push_back(region.report);
    }
    return reports;
}

void balance(Lattice& lattice, std::vector<std::pair<int, int>>& open) {
    if (lattice.division.empty()) return;
    open.clear();
    for (int row = 0; row < lattice.rows(); ++row)
        for (int column = 0; column < lattice.columns(); ++column)
            if (lattice.activeDivision(column, row) > 2) open.emplace_back(column, row);
    while (!open.empty()) {
        const auto [column, row] = open.back();
        open.pop_back();
        const int least = lattice.activeDivision(column, row) / 2;
        for (int r = row - 1; r <= row + 1; ++r)
            for (int c = column - 1; c <= column + 1; ++c) {
                const int u = lattice.activeDivision(c, r);
                if (u == 0 || u >= least) continue;
                lattice.division[at(lattice.cell(c, r))] = least;
                if (least > 2) open.emplace_back(c, r);
            }
    }
}

void seedFromBorder(const std::vector<SpacingSeed>& seeds, Lattice& lattice) {
    double longest = 0; // side of a cell
    for (int column = 0; column < lattice.columns(); ++column) longest = std::max(longest, lattice.width(column));
    for (int row = 0; row < lattice.rows(); ++row) longest = std::max(longest, lattice.height(row));
    for (const SpacingSeed& seed : seeds) {
        const double spacing = std::sqrt(squaredLength(seed.b - seed.a));
        const double most = 2 * spacing * (1 + 1e-9);
        if (longest <= most) continue;
        const Vec2 middle = lerp(seed.a, seed.b, 0.5);
        const int column = lattice.columnOf(middle.x), row = lattice.rowOf(middle.y);
        const double side = std::max(lattice.width(column), lattice.height(row));
        if (side <= most) continue;
        lattice.makeDivisible();
        int& u = lattice.division[at(lattice.cell(column, row))];
        while (side / u > most && 2 * u <= seed.largestDivision) u *= 2;
    }
}

namespace {

Result<void> refusedBeyondLimit(const PieceInput& piece, double cells, const std::string& cause) {
    if (cells <= largestCellCount) return {};
    char estimate[32];
    std::snprintf(estimate, sizeof estimate, "%.2g", cells);
    return fail(ErrorCode::tooLarge,
                cause + " would give about " + estimate + " cells; at most 1e7 are allowed. Choose a larger spacing.",
                {.object = nameOf(piece)});
}

} // namespace

Result<void> affordable(const PieceInput& piece, const Lattice& lattice) {
    double cells = static_cast<double>(lattice.active.size()); // no more than that, if none is divided
    if (lattice.division.empty() && cells <= largestCellCount) return {};
    cells = static_cast<double>(countOf(lattice.active));
    for (std::size_t c = 0; c < lattice.division.size(); ++c)
        if (lattice.active[c] && lattice.division[c] > 1)
            cells += static_cast<double>(lattice.division[c]) * lattice.division[c] - 1;
    return refusedBeyondLimit(piece, cells, "The regions");
}

Result<void> affordable(const PieceInput& piece, std::size_t linesX, std::size_t linesY) {
    return refusedBeyondLimit(piece, static_cast<double>(linesX) * static_cast<double>(linesY) / 4, "The scan lines");
}

} // namespace toile::meshing
