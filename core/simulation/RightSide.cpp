// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/RightSide.h"

#include "core/collision/BodySurface.h"
#include "core/collision/WindingNumber.h"
#include "core/simulation/ClothParts.h"
#include "core/simulation/Openings.h"

#include <algorithm>
#include <numbers>

namespace toile::simulation {
namespace {

using geometry::TriangleIndices;
using geometry::TriangleMesh;

/// Area vector of the fan over a closed line, seen from any point [m²].
Vec3 areaOf(const std::vector<Vec3>& loop) {
    Vec3 doubled;
    for (std::size_t i = 0; i < loop.size(); ++i)
        doubled += cross(loop[i] - loop.front(), loop[(i + 1) % loop.size()] - loop.front());
    return 0.5 * doubled;
}

/// Along the limb that passes by most closely, if that is the way out of the opening; else straight out of it.
Vec3 wayOutOf(const Vec3& middle, const Vec3& straight, const std::vector<std::vector<Vec3>>& limbs) {
    constexpr double near = 0.05, steepest = 0.7; // [m]; cosine of the angle between both
    Vec3 way = straight;
    double least = near;
    for (const std::vector<Vec3>& line : limbs)
        for (std::size_t i = 0; i + 1 < line.size(); ++i) {
            const Vec3 along = line[i + 1] - line[i];
            if (length(along) == 0) continue;
            const double part = std::clamp(dot(middle - line[i], along) / dot(along, along), 0.0, 1.0);
            const double far = geometry::distance(middle, line[i] + part * along);
            const Vec3 out = normalized(along) * (dot(along, straight) < 0 ? -1.0 : 1.0);
            if (far >= least || dot(out, straight) < steepest) continue;
            least = far;
            way = out;
        }
    return way;
}

/// How the cloth goes on beyond an opening in thought: straight on from the rim, then narrowing to a point so far away
/// that it hardly leans. The rim of a hem lies in folds, a collar is turned down over its stand, and what leans would
/// pass through them.
struct Closing {
    Vec3 rise; ///< from the rim to where it begins to narrow
    Vec3 apex;
};

Closing closingOver(const std::vector<Vec3>& loop, const Vec3& middleOfCloth,
                    const std::vector<std::vector<Vec3>>& limbs) {
    constexpr double straightOn = 1, slenderness = 4; // heights over a round opening, to its radius [–]
    Vec3 middle;
    double perimeter = 0;
    for (std::size_t i = 0; i < loop.size(); ++i) {
        middle += loop[i] / static_cast<double>(loop.size());
        perimeter += geometry::distance(loop[i], loop[(i + 1) % loop.size()]);
    }
    const Vec3 area = areaOf(loop);
    if (length(area) == 0) return {{}, middle};
    const Vec3 straight = normalized(area) * (dot(area, middle - middleOfCloth) < 0 ? -1.0 : 1.0);
    const Vec3 radius = wayOutOf(middle, straight, limbs) * (perimeter / (2 * std::numbers::pi));
    return {straightOn * radius, middle + (straightOn + slenderness) * radius};
}

void close(TriangleMesh& mesh, const Opening& opening, const Vec3& middleOfCloth,
           const std::vector<std::vector<Vec3>>& limbs) {
    std::vector<Vec3> loop;
    for (const int particle : opening) loop.push_back(mesh.vertices[particle]);
    const auto [rise, apex] = closingOver(loop, middleOfCloth, limbs);
    const int raised = static_cast<int>(mesh.vertices.size()), count = static_cast<int>(loop.size());
    for (const Vec3& at : loop) mesh.vertices.push_back(at + rise);
    mesh.vertices.push_back(apex);
    for (int i = 0; i < count; ++i) {
        const int next = (i + 1) % count;
        mesh.triangles.push_back({opening[next], opening[i], raised + i});
        mesh.triangles.push_back({opening[next], raised + i, raised + next});
        mesh.triangles.push_back({raised + next, raised + i, raised + count});
    }
}

/// The part with each of its openings closed, behind its own triangles.
TriangleMesh closed(const ClothPart& part, const std::vector<Vec3>& positions,
                    const std::vector<std::vector<Vec3>>& limbs) {
    TriangleMesh mesh{positions, part};
    Vec3 middle;
    for (const auto& triangle : part)
        for (const int corner : triangle) middle += positions[corner] / (3.0 * static_cast<double>(part.size()));
    for (const Opening& opening : openingsOf(part)) close(mesh, opening, middle, limbs);
    return mesh;
}

double areaOf(const TriangleIndices& t, const std::vector<Vec3>& positions) {
    return 0.5 * length(cross(positions[t[1]] - positions[t[0]], positions[t[2]] - positions[t[0]]));
}

/// How often a closed surface winds round what is just before each of its triangles. Asked at both ends of a region
/// that nothing passes through, it is the same all over it; where rounding tells otherwise all are asked.
std::vector<long> windingsBefore(const TriangleMesh& mesh) {
    const collision::WindingNumber winding(mesh);
    const auto before = [&](int triangle) { return std::lround(winding.onTriangle(triangle) - 0.5); }; // behind: 1 more
    std::vector<long> windings(mesh.triangles.size());
    for (const std::vector<int>& region : unpiercedRegions(mesh)) {
        const long first = before(region.front());
        const bool isSame = before(region.back()) == first;
        for (const int triangle : region) windings[triangle] = isSame ? first : before(triangle);
    }
    return windings;
}

} // namespace

double rightSideOutShare(std::span<const TriangleIndices> triangles, const std::vector<Vec3>& positions,
                         const Surroundings& around) {
    constexpr double overlap = 0.02; // cloth lies so near a placket where it is buttoned [m]
    const auto plackets = collision::BodySurface::create({positions, around.plackets}); // refuses to be made of nothing
    const auto liesDouble = [&](const TriangleIndices& t) {
        return plackets && plackets->nearest((positions[t[0]] + positions[t[1]] + positions[t[2]]) / 3, overlap);
    };
    double whole = 0, right = 0;
    for (const ClothPart& part : partsOf(triangles)) {
        const std::vector<bool> turned = turnedAgainstFirst(part);
        ClothPart alike = part;
        for (std::size_t t = 0; t < part.size(); ++t)
            if (turned[t]) std::swap(alike[t][1], alike[t][2]);
        const std::vector<long> before = windingsBefore(closed(alike, positions, around.limbs));
        for (std::size_t t = 0; t < part.size(); ++t) {
            if (liesDouble(part[t])) continue;
            const double area = areaOf(part[t], positions);
            whole += area;
            if (turned[t] ? before[t] < 0 : before[t] >= 0) right += area;
        }
    }
    return whole > 0 ? right / whole : 0;
}

} // namespace toile::simulation
