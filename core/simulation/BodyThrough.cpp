// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/BodyThrough.h"

#include "core/collision/Intersections.h"
#include "core/geometry/Segment.h"

#include <cmath>
#include <limits>
#include <map>

namespace toile::simulation {
namespace {

/// Cosines between the normals of cloth and skin where they meet. All round a cylinder that sticks through a plane
/// their mean is 0, and that of their size 2/π at most, however it slants; where cloth lies along the skin, they are
/// near 1 or −1, in the fork of the legs both. Few pairs are no loop.
struct Slant {
    double sum = 0, size = 0;
    int pairs = 0;

    /// Triangles without area, as merged seams leave them, have no normal.
    void add(const Vec3& ofCloth, const Vec3& ofSkin) {
        const double lengths = length(ofCloth) * length(ofSkin);
        if (lengths == 0) return;
        const double cosine = dot(ofCloth, ofSkin) / lengths;
        sum += cosine;
        size += std::abs(cosine);
        ++pairs;
    }
    [[nodiscard]] bool goesAllRound() const { return pairs >= 8 && std::abs(sum) < 0.5 * pairs && size < 0.65 * pairs; }
};

/// As long as twice the triangle's area.
Vec3 areaNormal(const geometry::TriangleMesh& mesh, int triangle) {
    const auto& [a, b, c] = mesh.triangles[triangle];
    return cross(mesh.vertices[b] - mesh.vertices[a], mesh.vertices[c] - mesh.vertices[a]);
}

/// The triangles of all pieces, and of which piece each is.
struct ClothOfPieces {
    geometry::TriangleMesh mesh;
    std::vector<std::size_t> pieces;
};

ClothOfPieces clothOf(const Simulation& simulation) {
    const Garment& garment = simulation.garment();
    ClothOfPieces cloth{{simulation.state().positions, particleTriangles(garment)}, {}};
    for (std::size_t piece = 0; piece < garment.mesh->pieces.size(); ++piece)
        cloth.pieces.insert(cloth.pieces.end(), garment.mesh->pieces[piece].display.size(), piece);
    return cloth;
}

/// The limb whose middle line is nearest. Below the crotch that of the torso goes on between the legs.
std::optional<body::Limb> limbAt(const body::Body& body, const Vec3& place) {
    std::optional<body::Limb> nearest;
    double least = std::numeric_limits<double>::infinity();
    for (const body::LimbAxis& axis : body.axes) {
        if (axis.limb == body::Limb::torso && place.y < body.landmarks.crotch.y) continue;
        for (std::size_t k = 0; k + 1 < axis.points.size(); ++k)
            if (const double far = geometry::distanceToSegment(place, axis.points[k], axis.points[k + 1]);
                far < least) {
                least = far;
                nearest = axis.limb;
            }
    }
    return nearest;
}

} // namespace

std::vector<BodyThrough> bodyThrough(const Simulation& simulation) {
    const collision::BodySurface* surface = simulation.body();
    if (!surface) return {};
    const ClothOfPieces cloth = clothOf(simulation);
    const geometry::TriangleMesh& skin = surface->mesh();
    std::map<std::pair<std::optional<body::Limb>, std::size_t>, Slant> slants;
    for (const auto& [ofCloth, ofSkin] : collision::intersectingTriangles(cloth.mesh, skin)) {
        std::optional<body::Limb> limb;
        if (!surface->hasMoved()) limb = limbAt(**simulation.scene().body, skin.vertices[skin.triangles[ofSkin][0]]);
        slants[{limb, cloth.pieces[ofCloth]}].add(areaNormal(cloth.mesh, ofCloth), areaNormal(skin, ofSkin));
    }
    std::vector<BodyThrough> through;
    for (const auto& [where, slant] : slants)
        if (slant.goesAllRound()) through.push_back({where.first, where.second});
    return through;
}

std::string partOf(const BodyThrough& through) {
    return through.limb ? std::string(nameOf(*through.limb)) : "body";
}

} // namespace toile::simulation
