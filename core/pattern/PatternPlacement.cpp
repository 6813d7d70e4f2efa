// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pattern/PatternPlacement.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace toile::pattern {
namespace {

Result<Curl> usable(const Curl& curl, const Piece& piece) {
    const double size = geometry::length(curl.axis);
    if (!(size > 1e-9 && std::isfinite(size)))
        return fail(ErrorCode::invalidInput, "The axis of a curl needs a direction.", placeOf(piece));
    if (!(std::abs(curl.radius) > 0 && std::isfinite(curl.radius)))
        return fail(ErrorCode::invalidInput, "The radius of a curl must be a length other than 0.", placeOf(piece));
    if (curl.bent && !isLine(*curl.bent))
        return fail(ErrorCode::invalidInput,
                    "A bent middle needs two points at least, and no two neighbours in one place.", placeOf(piece));
    return Curl{curl.axis / size, curl.radius, curl.bent};
}

Result<void> rigid(const Transform& transform, const Piece& piece) {
    if (isRigid(transform)) return {};
    return fail(ErrorCode::invalidInput, "A placement moves and turns a piece, but does not stretch or mirror it.",
                placeOf(piece));
}

} // namespace

Placement movedOutward(const Placement& placement, double way) {
    const double outward = placement.curl && placement.curl->radius < 0 ? -1 : 1;
    Placement moved = placement;
    moved.transform.origin += moved.transform.axisZ * (outward * way);
    if (moved.curl) moved.curl->radius += outward * way;
    return moved;
}

bool isRigid(const Transform& t) {
    constexpr double tolerance = 1e-6;
    const auto unit = [](const Vec3& a) { return std::abs(squaredLength(a) - 1) <= tolerance; };
    return isFinite(t.origin) && unit(t.axisX) && unit(t.axisY) && unit(t.axisZ) &&
           squaredLength(cross(t.axisX, t.axisY) - t.axisZ) <= tolerance * tolerance;
}

bool isLine(const BentLine& bent) {
    const std::vector<Vec3>& points = bent.points;
    const auto apart = [](const Vec3& a, const Vec3& b) { return squaredLength(b - a) > 1e-12; }; // a micrometre
    return points.size() > 1 && std::isfinite(bent.from) &&
           std::ranges::all_of(points, [](const Vec3& p) { return isFinite(p); }) &&
           std::ranges::adjacent_find(points, std::not_fn(apart)) == points.end();
}

Result<Pattern> setPlacement(const Pattern& pattern, const PieceId& piece, const std::optional<Placement>& placement) {
    return changed(pattern, piece, [&](Piece& p) -> Result<void> {
        p.placement = placement;
        if (!placement) return {};
        if (auto ok = rigid(placement->transform, p); !ok) return ok;
        if (!placement->curl) return {};
        return usable(*placement->curl, p).map([&](const Curl& curl) { p.placement->curl = curl; });
    });
}

Result<Pattern> movePlacement(const Pattern& pattern, const PieceId& piece, const Transform& motion) {
    return changed(pattern, piece, [&](Piece& p) -> Result<void> {
        if (!p.placement) return fail(ErrorCode::invalidInput, "This piece is not placed yet.", placeOf(p));
        p.placement->transform = composed(motion, p.placement->transform);
        return rigid(p.placement->transform, p);
    });
}

Result<Pattern> setCurl(const Pattern& pattern, const PieceId& piece, const std::optional<Curl>& curl) {
    return changed(pattern, piece, [&](Piece& p) -> Result<void> {
        if (!p.placement) return fail(ErrorCode::invalidInput, "This piece is not placed yet.", placeOf(p));
        p.placement->curl.reset();
        if (!curl) return {};
        return usable(*curl, p).map([&](const Curl& unit) { p.placement->curl = unit; });
    });
}

Placement mirrored(const Placement& placement) {
    const auto opposite = [](const Vec3& v) { return Vec3{-v.x, v.y, v.z}; };
    const Transform& t = placement.transform;
    Placement result{{opposite(-t.axisX), opposite(t.axisY), opposite(t.axisZ), opposite(t.origin)}, placement.curl};
    if (result.curl) {
        result.curl->axis.x = -result.curl->axis.x;
        if (result.curl->bent)
            for (Vec3& point : result.curl->bent->points) point.x = -point.x;
    }
    return result;
}

} // namespace toile::pattern
