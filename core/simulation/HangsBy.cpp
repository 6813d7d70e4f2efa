// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/HangsBy.h"

#include "core/geometry/Segment.h"
#include "core/simulation/Inspect.h"
#include "core/simulation/Openings.h"

#include <algorithm>
#include <array>
#include <limits>

namespace toile::simulation {
namespace {

constexpr double bandWidth = 0.04;    ///< about what a waistband is wide [m]
constexpr std::size_t fewestRims = 2; ///< of a garment: what it hangs by, and a hem

double heightOf(const Opening& rim, std::span<const Vec3> positions) {
    double sum = 0;
    for (const int particle : rim) sum += positions[particle].y;
    return sum / static_cast<double>(rim.size());
}

double distanceFrom(const Opening& rim, std::span<const Vec3> positions, const Vec3& place) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < rim.size(); ++i)
        least = std::min(least,
                         geometry::distanceToSegment(place, positions[rim[i]], positions[rim[(i + 1) % rim.size()]]));
    return least;
}

/// The largest stiffness of a spring, or of what acts like one, at each particle [N/m].
std::vector<double> stiffestAt(const cloth::ClothModel& model) {
    std::vector<double> stiffest(model.mass.size(), 0);
    const auto take = [&](int particle, double stiffness) {
        stiffest[particle] = std::max(stiffest[particle], stiffness);
    };
    for (const cloth::Spring& spring : model.structural) {
        take(spring.a, spring.stiffness);
        take(spring.b, spring.stiffness);
    }
    for (const cloth::MembraneTriangle& t : model.triangles) {
        const auto& r = t.inverseRest;
        const std::array<Vec2, 3> gradients{Vec2{-r[0] - r[2], -r[1] - r[3]}, Vec2{r[0], r[1]}, Vec2{r[2], r[3]}};
        for (int i = 0; i < 3; ++i)
            take(t.particles[i], t.area * std::max(t.stiffness.c11 * gradients[i].x * gradients[i].x,
                                                   t.stiffness.c22 * gradients[i].y * gradients[i].y));
    }
    for (const cloth::MembraneCell& cell : model.cells)
        for (const int corner : cell.particles)
            take(corner, std::max(cell.stiffness.c11 * cell.height / cell.width,
                                  cell.stiffness.c22 * cell.width / cell.height));
    return stiffest;
}

} // namespace

bool hangsOnItsWaistband(const Simulation& simulation) {
    const Scene& scene = simulation.scene();
    return scene.body && !(*scene.body)->axes.empty() && !hasNeckOpening(drapeOf(simulation), **scene.body);
}

std::vector<int> nodesItHangsBy(const Simulation& coarse, const Simulation& fine) {
    if (!hangsOnItsWaistband(coarse)) return {};
    const std::span<const Vec3> positions = coarse.state().positions;
    const std::vector<Opening> rims = openingsOf(particleTriangles(coarse.garment()));
    if (rims.size() < fewestRims) return {};
    const auto upper = std::ranges::max_element(rims, {}, [&](const Opening& rim) { return heightOf(rim, positions); });
    std::vector<int> nodes;
    const std::vector<Vec3> places = fine.nodePositions();
    for (std::size_t node = 0; node < places.size(); ++node)
        if (distanceFrom(*upper, positions, places[node]) < bandWidth) nodes.push_back(static_cast<int>(node));
    return nodes;
}

bool hangsInFreeFolds(const Simulation& simulation) {
    const Drape drape = drapeOf(simulation);
    const auto isOfOneLeg = [](const OpeningReport& rim) {
        return rim.limbs.size() == 1 &&
               (rim.name == nameOf(body::Limb::leftLeg) || rim.name == nameOf(body::Limb::rightLeg));
    };
    return std::ranges::none_of(openingReports(openingsOf(drape.triangles), drape, **simulation.scene().body),
                                isOfOneLeg);
}

std::vector<double> inertiaOf(const Garment& garment, std::span<const int> nodes, double h) {
    const cloth::ClothModel& model = garment.model;
    const std::vector<double> stiffest = stiffestAt(model);
    std::vector<double> inertia(model.mass.size(), 1);
    for (const int node : nodes) {
        const int particle = garment.particles.particleOf[node];
        // Two ends of inverse mass w take no more than 1/(2 w h²).
        if (const double mass = model.mass[particle]; mass > 0)
            inertia[particle] = std::max(1.0, 2 * stiffest[particle] * h * h / mass);
    }
    return inertia;
}

} // namespace toile::simulation
