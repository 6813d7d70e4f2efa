// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/validation/DrapedDisc.h"

#include "core/dynamics/Method.h"
#include "core/dynamics/Statics.h"
#include "core/simulation/Garment.h"
#include "core/simulation/MeshInputOf.h"
#include "core/study/validation/Pieces.h"
#include "core/study/validation/Sheets.h"

#include <algorithm>
#include <numbers>
#include <random>
#include <utility>

namespace toile::study::validation {
namespace {

constexpr double pi = std::numbers::pi;
constexpr int corners = 96; // of what stands for a circle

std::vector<Vec2> circle(double radius, int sense) {
    std::vector<Vec2> points;
    for (int k = 0; k < corners; ++k) {
        const double turn = sense * 2 * pi * k / corners;
        points.push_back({radius * std::cos(turn), radius * std::sin(turn)});
    }
    return points;
}

} // namespace

double Drape::coefficient() const {
    double twice = 0;
    for (std::size_t i = 0; i < rim.size(); ++i) {
        const Vec3 &a = rim[i], &b = rim[(i + 1) % rim.size()];
        twice += a.x * b.z - b.x * a.z;
    }
    const double held = pi * inner * inner;
    return 100 * (std::abs(twice) / 2 - held) / (pi * outer * outer - held);
}

std::complex<double> Drape::wave(int times) const {
    std::complex<double> sum = 0;
    for (const Vec3& x : rim) sum += x.y * std::polar(1.0, times * std::atan2(x.z, x.x));
    return sum;
}

double Drape::meanHeight() const {
    double mean = 0;
    for (const Vec3& x : rim) mean += x.y / static_cast<double>(rim.size());
    return mean;
}

double Drape::lengthTowards(double angle) const {
    std::vector<std::pair<double, int>> line;
    for (int p = 0; p < std::ssize(flat); ++p) {
        const double along = flat[p].x * std::cos(angle) + flat[p].y * std::sin(angle);
        const double beside = flat[p].y * std::cos(angle) - flat[p].x * std::sin(angle);
        if (along > 0 && std::abs(beside) < 1e-6) line.push_back({along, p});
    }
    std::ranges::sort(line);
    const auto at = [&](std::size_t i) { return positions[line[i].second]; };
    std::vector<double> curvature(line.size());
    for (std::size_t i = 1; i + 1 < line.size(); ++i) {
        const Vec3 before = at(i) - at(i - 1), behind = at(i + 1) - at(i);
        curvature[i] = 2 * length(cross(before, behind)) /
                       (length(before) * length(behind) * geometry::distance(at(i - 1), at(i + 1)));
    }
    double sum = 0;
    for (std::size_t i = 1; i < line.size(); ++i) {
        const double chord = geometry::distance(at(i - 1), at(i)), bent = 0.5 * (curvature[i - 1] + curvature[i]);
        sum += chord * (1 + bent * bent * chord * chord / 24);
    }
    return sum;
}

int Drape::folds() const {
    const double mean = meanHeight();
    int count = 0;
    for (std::size_t i = 0; i < rim.size(); ++i) count += rim[i].y < mean && rim[(i + 1) % rim.size()].y >= mean;
    return count;
}

Fabric drapingWeave() {
    Fabric fabric = unequalWeave();
    fabric.warpStiffness = fabric.weftStiffness = 800;
    fabric.shearStiffness = 40;
    fabric.warpBending = fabric.weftBending = 16e-6;
    fabric.biasBending = 13e-6;
    return fabric;
}

Drape drapeOf(Findings& found, const Disc& disc) {
    pattern::Pattern pattern;
    Fabric cloth = disc.fabric;
    cloth.id = material::FabricId("cloth");
    pattern.fabrics.push_back(std::move(cloth));
    pattern::Piece piece = polygonPiece("disc", circle(disc.outer, 1), disc.spacing);
    if (disc.ring) {
        pattern::Contour hole = polygonPiece("hole", circle(disc.inner, -1), disc.spacing).outline;
        for (int k = 0; k < corners; ++k) {
            hole.vertices[k].id = pattern::VertexId("h" + std::to_string(k));
            hole.edges[k].id = pattern::EdgeId("i" + std::to_string(k));
        }
        piece.holes.push_back(std::move(hole));
    }
    piece.grain = disc.grain;
    pattern.pieces.push_back(std::move(piece));
    const auto input = simulation::meshInputOf(pattern);
    if (!found.ran(input)) return {};
    auto mesh = meshing::meshGarment(*input);
    if (!found.ran(mesh)) return {};
    const std::vector<Vec2> flat = mesh->pieces.front().nodes;
    auto garment = simulation::makeGarment(pattern, Shared<meshing::GarmentMesh>(std::move(*mesh)), {});
    if (!found.ran(garment)) return {};
    ClothModel& model = garment->model;
    std::mt19937 random(disc.seed);
    ParticleState state;
    std::vector<std::pair<double, int>> rim;
    for (int p = 0; p < model.particleCount(); ++p) {
        const double radius = length(flat[p]);
        const double noise = disc.noise * (static_cast<double>(random()) / std::mt19937::max() - 0.5);
        state.positions.push_back({flat[p].x, radius < disc.inner ? 0 : noise, -flat[p].y});
        if (radius < disc.inner + 1e-6) model.pinned.push_back(p);
        if (radius > disc.outer * std::cos(pi / corners) - 1e-6) rim.push_back({std::atan2(flat[p].y, flat[p].x), p});
    }
    cloth::doubleBendingAtClampedRows(model);
    const auto xpbd = dynamics::makeIntegrator(dynamics::Method::xpbd, model, {.damping = 3});
    for (int frame = 0; frame < 120 && !found.stopped(); ++frame) found.ran(xpbd->step(state, 1.0 / 60, downward));
    const auto rest = dynamics::solveStatic(model, state, downward, {}, {.maximumIterations = 1000});
    if (found.ran(rest) && !rest->newton.converged) found.stop("The drape did not come to rest.");
    std::ranges::sort(rim);
    Drape drape{.inner = disc.inner, .outer = disc.outer, .rim = {}, .flat = flat, .positions = state.positions};
    for (const auto& [angle, p] : rim) drape.rim.push_back(state.positions[p]);
    return drape;
}

} // namespace toile::study::validation
