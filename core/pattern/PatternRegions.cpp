// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pattern/PatternRegions.h"

#include "core/pattern/Brush.h"
#include "core/pattern/Crossings.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace toile::pattern {
namespace {

constexpr double largest = 100; ///< coordinates beyond this are no garment's [m]

bool isUsable(Vec2 p) {
    return std::abs(p.x) < largest && std::abs(p.y) < largest;
} // false for NaN too

/// A border that crosses itself becomes that of what it encloses.
Result<Area> areaWithin(Polygon polygon, const Piece& piece) {
    if (polygon.size() < 3)
        return fail(ErrorCode::invalidInput, "A region needs at least three corners.", placeOf(piece));
    if (!std::ranges::all_of(polygon, isUsable))
        return fail(ErrorCode::invalidInput, "The corners of a region must have finite coordinates.", placeOf(piece));
    std::vector<Area> enclosed;
    if (firstCrossing(polygon)) {
        enclosed = unionOf({{std::move(polygon), {}}}, {});
    } else {
        if (geometry::signedArea(polygon) < 0) std::ranges::reverse(polygon);
        enclosed.push_back({std::move(polygon), {}});
    }
    if (enclosed.empty() || geometry::signedArea(enclosed.front().outline) < 1e-10)
        return fail(ErrorCode::invalidInput, "A region must enclose an area.", placeOf(piece));
    if (enclosed.size() > 1 || firstCrossing(enclosed.front().outline))
        return fail(ErrorCode::invalidInput,
                    "The border crosses itself and encloses several regions: draw one at a time.", placeOf(piece));
    return std::move(enclosed.front());
}

Result<void> usable(const Stroke& stroke, const Piece& piece) {
    if (stroke.points.empty() || !std::ranges::all_of(stroke.points, isUsable))
        return fail(ErrorCode::invalidInput, "A brush stroke needs points with finite coordinates.", placeOf(piece));
    if (!(stroke.radius > 1e-5 && stroke.radius < largest))
        return fail(ErrorCode::invalidInput, "The radius of the brush must be at least 0.01 mm.", placeOf(piece));
    return {};
}

Result<void> refinementIn(int refinement, const Piece& piece) {
    if (refinement >= 0 && refinement <= 16) return {};
    return fail(ErrorCode::invalidInput, fmt::format("The refinement is {}, but must be from 0 to 16.", refinement),
                placeOf(piece));
}

Region made(const Area& area, std::string name, int refinement, IdSource& ids) {
    Region region;
    region.id = ids.take<RegionId>();
    region.name = std::move(name);
    region.outline = area.outline;
    region.holes = area.holes;
    region.refinement = refinement;
    return region;
}

std::vector<Area> areaOf(const Region& region) {
    return {{region.outline, region.holes}};
}

Result<Pattern> changedRegion(const Pattern& pattern, const PieceId& piece, const RegionId& id,
                              const std::function<Result<void>(Piece&, Region&)>& change) {
    return changedShape(pattern, piece, [&](Piece& p) -> Result<void> {
        const auto found = std::ranges::find(p.regions, id, &Region::id);
        if (found == p.regions.end())
            return fail(ErrorCode::notFound, fmt::format("There is no region \"{}\".", id.value), placeOf(p));
        return change(p, *found);
    });
}

} // namespace

Result<Pattern> addRegion(const Pattern& pattern, const PieceId& piece, Polygon outline, std::string name,
                          int refinement, IdSource& ids) {
    return changedShape(pattern, piece, [&](Piece& p) -> Result<void> {
        if (auto ok = refinementIn(refinement, p); !ok) return ok;
        return areaWithin(std::move(outline), p).map([&](const Area& area) {
            p.regions.push_back(made(area, std::move(name), refinement, ids));
        });
    });
}

Result<Pattern> removeRegion(const Pattern& pattern, const PieceId& piece, const RegionId& region) {
    return changedRegion(pattern, piece, region, [&](Piece& p, Region&) -> Result<void> {
        std::erase_if(p.regions, [&](const Region& r) { return r.id == region; });
        return {};
    });
}

Result<Pattern> renameRegion(const Pattern& pattern, const PieceId& piece, const RegionId& region, std::string name) {
    return changedRegion(pattern, piece, region, [&](Piece&, Region& r) -> Result<void> {
        r.name = std::move(name);
        return {};
    });
}

Result<Pattern> setRefinement(const Pattern& pattern, const PieceId& piece, const RegionId& region, int refinement) {
    return changedRegion(pattern, piece, region, [&](Piece& p, Region& r) -> Result<void> {
        r.refinement = refinement;
        return refinementIn(refinement, p);
    });
}

Result<Pattern> setStiffness(const Pattern& pattern, const PieceId& piece, const RegionId& region,
                             const StiffnessFactors& stiffness) {
    return changedRegion(pattern, piece, region, [&](Piece& p, Region& r) -> Result<void> {
        for (const double factor : {stiffness.stretch, stiffness.shear, stiffness.bending})
            if (!(factor > 0 && std::isfinite(factor)))
                return fail(ErrorCode::invalidInput, "A stiffness factor must be positive.", placeOf(p));
        r.stiffness = stiffness;
        return {};
    });
}

Result<Pattern> paintNewRegion(const Pattern& pattern, const PieceId& piece, const Stroke& stroke, std::string name,
                               int refinement, IdSource& ids) {
    return changedShape(pattern, piece, [&](Piece& p) -> Result<void> {
        if (auto ok = usable(stroke, p).and_then([&] { return refinementIn(refinement, p); }); !ok) return ok;
        p.regions.push_back(made(swept(stroke.points, stroke.radius).front(), std::move(name), refinement, ids));
        return {};
    });
}

Result<Pattern> paintRegion(const Pattern& pattern, const PieceId& piece, const RegionId& region,
                            const Stroke& stroke) {
    return changedRegion(pattern, piece, region, [&](Piece& p, Region& r) -> Result<void> {
        if (auto ok = usable(stroke, p); !ok) return ok;
        const auto areas = unionOf(areaOf(r), swept(stroke.points, stroke.radius));
        if (areas.size() != 1)
            return fail(ErrorCode::invalidInput, "The stroke does not touch the region: begin a new one there.",
                        placeOf(p));
        r.outline = areas.front().outline;
        r.holes = areas.front().holes;
        return {};
    });
}

Result<Pattern> eraseRegion(const Pattern& pattern, const PieceId& piece, const RegionId& region, const Stroke& stroke,
                            IdSource& ids) {
    return changedRegion(pattern, piece, region, [&](Piece& p, Region& r) -> Result<void> {
        if (auto ok = usable(stroke, p); !ok) return ok;
        const auto areas = differenceOf(areaOf(r), swept(stroke.points, stroke.radius));
        if (areas.empty()) {
            std::erase_if(p.regions, [&](const Region& other) { return other.id == region; });
            return {};
        }
        r.outline = areas.front().outline;
        r.holes = areas.front().holes;
        std::vector<Region> cutOff;
        for (std::size_t i = 1; i < areas.size(); ++i) {
            cutOff.push_back(made(areas[i], fmt::format("{} {}", r.name, i + 1), r.refinement, ids));
            cutOff.back().stiffness = r.stiffness;
        }
        p.regions.insert(p.regions.end(), cutOff.begin(), cutOff.end());
        return {};
    });
}

} // namespace toile::pattern
