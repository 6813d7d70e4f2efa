// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/MeetingPieces.h"

#include "core/collision/Intersections.h"
#include "core/pattern/PatternPlacement.h"

#include <algorithm>
#include <cmath>

namespace toile::simulation {
namespace {

struct Surface {
    geometry::TriangleMesh mesh;
    geometry::Box3 box;
};

std::vector<Surface> surfacesOf(const meshing::GarmentMesh& mesh, std::span<const Vec3> nodes) {
    std::vector<Surface> surfaces;
    std::size_t first = 0;
    for (const meshing::PieceMesh& piece : mesh.pieces) {
        const auto own = nodes.subspan(first, piece.nodes.size());
        const geometry::TriangleMesh placed{{own.begin(), own.end()}, piece.display};
        surfaces.push_back({placed, geometry::boundsOf(placed.vertices)});
        first += own.size();
    }
    return surfaces;
}

bool boxesMeet(const geometry::Box3& a, const geometry::Box3& b) {
    return a.low.x <= b.high.x && b.low.x <= a.high.x && a.low.y <= b.high.y && b.low.y <= a.high.y &&
           a.low.z <= b.high.z && b.low.z <= a.high.z;
}

/// Whether two triangles are next to each other: with a corner or a side in common, but not lying on each other.
bool areNeighbours(const std::array<Vec3, 3>& a, const std::array<Vec3, 3>& b) {
    constexpr double samePlace = 1e-6; // [m]
    const auto common = std::ranges::count_if(a, [&](const Vec3& p) {
        return std::ranges::any_of(b, [&](const Vec3& q) { return geometry::distance(p, q) < samePlace; });
    });
    return common == 1 || common == 2;
}

constexpr double clearance = 0.005; // [m]

/// Nearer than the clearance.
bool lieInOnePlane(const pattern::Placement& a, const pattern::Placement& b) {
    constexpr double slope = 1e-3; // a millimetre in a metre
    const Vec3& normal = a.transform.axisZ;
    const double height = dot(b.transform.origin - a.transform.origin, normal);
    return !a.curl && !b.curl && length(cross(normal, b.transform.axisZ)) < slope &&
           std::abs(height) < 0.99 * clearance;
}

bool meet(const geometry::TriangleMesh& a, const geometry::TriangleMesh& b) {
    const auto cornersOf = [](const geometry::TriangleMesh& mesh, int triangle) {
        const auto& [p, q, r] = mesh.triangles[triangle];
        return std::array{mesh.vertices[p], mesh.vertices[q], mesh.vertices[r]};
    };
    return !std::ranges::all_of(collision::intersectingTriangles(a, b), [&](const std::pair<int, int>& pair) {
        return areNeighbours(cornersOf(a, pair.first), cornersOf(b, pair.second));
    });
}

} // namespace

std::vector<PiecePair> meetingPieces(const meshing::GarmentMesh& mesh, std::span<const Vec3> nodes) {
    const std::vector<Surface> pieces = surfacesOf(mesh, nodes);
    std::vector<PiecePair> meeting;
    for (std::size_t a = 0; a < pieces.size(); ++a)
        for (std::size_t b = a + 1; b < pieces.size(); ++b)
            if (boxesMeet(pieces[a].box, pieces[b].box) && meet(pieces[a].mesh, pieces[b].mesh))
                meeting.push_back({static_cast<int>(a), static_cast<int>(b)});
    return meeting;
}

pattern::Pattern offEachOther(const pattern::Pattern& pattern, std::span<const PiecePair> meeting) {
    pattern::Pattern apart = pattern;
    const auto placementOf = [&](int piece) { return apart.pieces[piece]->placement.value_or(pattern::Placement{}); };
    for (int piece = 0; piece < static_cast<int>(apart.pieces.size()); ++piece) {
        const auto liesOnAnEarlierOne = [&](const PiecePair& pair) {
            return pair[1] == piece && lieInOnePlane(placementOf(pair[0]), placementOf(piece));
        };
        while (std::ranges::any_of(meeting, liesOnAnEarlierOne)) {
            pattern::Piece moved = *apart.pieces[piece];
            moved.placement = pattern::movedOutward(placementOf(piece), clearance);
            apart.pieces[piece] = std::move(moved);
        }
    }
    return apart;
}

} // namespace toile::simulation
