// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/meshing/Regions.h"
#include "core/base/Index.h"

#include "core/meshing/Flags.h"
#include "core/meshing/PolygonOverlap.h"
#include "core/meshing/RegionBorderPath.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>

namespace toile::meshing {
namespace {

constexpr double largestCellCount = 1e7;
constexpr double borderMoveWarned = 0.5; ///< of ε_m [–]

Polygons paintedBorders(const RegionInput& region, const PieceFrame& frame, Arena& arena) {
    Polygons borders(&arena);
    const auto add = [&](const Polygon& polygon) {
        auto& turned = borders.emplace_back();
        for (const Vec2 p : polygon) turned.push_back(frame.frameOf(p));
    };
    add(region.outline);
    for (const Polygon& hole : region.holes) add(hole);
    return borders;
}

Polygons contoursInFrame(const PieceBoundary& boundary, Arena& arena) {
    Polygons contours(&arena);
    for (const auto& ring : boundary.contours) {
        auto& polygon = contours.emplace_back();
        for (const GridPoint p : ring)
            polygon.push_back(Vec2{static_cast<double>(p.x), static_cast<double>(p.y)} * boundary.frame.unit);
    }
    return contours;
}

/// The cells inside closed paths of main lines, by parity.
std::pmr::vector<char> cellsInside(std::span<const LatticePath> paths, const Lattice& lattice, Arena& arena) {
    std::pmr::vector<char> inside(at(lattice.columns() * lattice.rows()), 0, &arena);
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

Polygons asPolygons(std::span<const LatticePath> paths, const Lattice& lattice, Arena& arena) {
    Polygons polygons(&arena);
    for (const LatticePath& path : paths) {
        auto& polygon = polygons.emplace_back();
        for (const LatticePoint p : path)
            polygon.push_back({lattice.mainX()[at(p.column)], lattice.mainY()[at(p.row)]});
    }
    return polygons;
}

double distanceToBorders(const Polygons& borders, Vec2 point) {
    double best = 1e300;
    for (const auto& border : borders)
        if (!border.empty()) best = std::min(best, geometry::distanceToBorder(border, point));
    return best;
}

/// Largest distance from the part of one border inside the piece to the other border, sampled.
double oneSidedDistance(const Polygons& from, const Polygons& to, const Polygons& piece, double spacing) {
    double perimeter = 0;
    for (const auto& border : from)
        for (std::size_t i = 0; i < border.size(); ++i)
            perimeter += distance(border[i], border[(i + 1) % border.size()]);
    const double step = std::max(spacing / 8, perimeter / 2000);
    double worst = 0;
    for (const auto& border : from)
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
                                 const Polygons& contours, Arena& arena) {
    const auto error = [&](const std::string& text) {
        return Error{ErrorCode::invalidInput, text, {.object = nameOf(piece) + ", region \"" + region.label + "\""}};
    };
    if (region.outline.size() < 3) return error("The border of the region needs at least three points.");
    if (overlapArea(painted, contours, arena) <= 1e-12 * piece.spacing * piece.spacing + 1e-14)
        return error("The region lies outside the piece.");
    return std::nullopt;
}

/// Which cells each region covers.
using CellsOfRegions = std::pmr::vector<std::pmr::vector<char>>;

/// Overwrites the report; returns the cells.
std::pmr::vector<char> snapped(const PieceInput& piece, const RegionInput& region, const Polygons& painted,
                               const Polygons& contours, const Lattice& lattice, Arena& arena, RegionReport& report) {
    std::pmr::vector<LatticePath> paths(&arena);
    for (const auto& border : painted)
        if (border.size() >= 3) paths.push_back(nearestLatticePath(border, lattice, arena));
    report.label = region.label;
    report.ratio = 1 << region.refinement;
    report.spacing = piece.spacing / report.ratio;
    report.cells = 0;
    const Polygons final = asPolygons(paths, lattice, arena);
    report.displacement = std::max(oneSidedDistance(painted, final, contours, piece.spacing),
                                   oneSidedDistance(final, painted, contours, piece.spacing));
    report.areaChange = overlapArea(final, contours, arena) - overlapArea(painted, contours, arena);
    return cellsInside(paths, lattice, arena);
}

void warnOfOverlaps(const PieceInput& piece, const CellsOfRegions& cells, const Lattice& lattice,
                    std::vector<Warning>& warnings) {
    for (std::size_t i = 0; i < cells.size(); ++i)
        for (std::size_t j = i + 1; j < cells.size(); ++j) {
            int common = 0;
            for (std::size_t c = 0; c < lattice.active.size(); ++c)
                common += lattice.active[c] && cells[i][c] && cells[j][c];
            if (common > 0)
                warnings.push_back({nameOf(piece), "Regions \"" + piece.regions[i].label + "\" and \"" +
                                                       piece.regions[j].label + "\" share " + std::to_string(common) +
                                                       " main cells; the finer one counts there."});
        }
}

} // namespace

Result<void> snapRegions(const PieceInput& piece, const PieceBoundary& boundary, Arena& arena, Lattice& lattice,
                         std::span<RegionReport> reports, std::vector<Warning>& warnings) {
    const Polygons contours = contoursInFrame(boundary, arena);
    CellsOfRegions cells(&arena);
    for (std::size_t r = 0; r < piece.regions.size(); ++r) {
        const RegionInput& region = piece.regions[r];
        RegionReport& report = reports[r];
        const Polygons painted = paintedBorders(region, boundary.frame, arena);
        if (auto error = regionError(piece, region, painted, contours, arena)) return tl::unexpected(*error);
        cells.push_back(snapped(piece, region, painted, contours, lattice, arena, report));
        if (report.displacement > borderMoveWarned * piece.spacing)
            warnings.push_back({nameOf(piece), "The border of region \"" + region.label + "\" moved by " +
                                                   millimetres(report.displacement) + " to the main mesh of " +
                                                   millimetres(piece.spacing) + "."});
    }
    warnOfOverlaps(piece, cells, lattice, warnings);
    lattice.makeDivisible();
    for (std::size_t r = 0; r < reports.size(); ++r)
        for (std::size_t c = 0; c < lattice.division.size(); ++c) {
            if (!cells[r][c]) continue;
            const int u = reports[r].ratio;
            if (lattice.region[c] >= 0 && lattice.division[c] >= u) continue;
            lattice.division[c] = u;
            lattice.region[c] = static_cast<int>(r);
        }
    for (std::size_t c = 0; c < lattice.division.size(); ++c)
        if (lattice.active[c] && lattice.region[c] >= 0) ++reports[at(lattice.region[c])].cells;
    for (const RegionReport& report : reports)
        if (report.cells == 0)
            return fail(ErrorCode::invalidInput,
                        "The region has no cell left after snapping to the main mesh of " + millimetres(piece.spacing) +
                            "; make it larger, or the main mesh finer.",
                        {.object = nameOf(piece) + ", region \"" + report.label + "\""});
    return {};
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
