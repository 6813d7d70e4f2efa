// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/dynamics/Method.h"
#include "core/dynamics/Statics.h"
#include "core/simulation/Garment.h"
#include "core/simulation/MeshInputOf.h"
#include "core/study/validation/Cases.h"
#include "core/study/validation/Pieces.h"
#include "core/study/validation/Sheets.h"

#include <algorithm>
#include <complex>
#include <fmt/format.h>
#include <numeric>

/// Discs of cloth that hang over a smaller support: Cusick's test.
namespace toile::study::validation {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double specimen = 0.15, support = 0.09; // radii [m], BS 5058

/// A draped disc: where its rim is, in order round it.
struct Drape {
    std::vector<Vec3> rim; ///< about the axis of the support, which is level at y = 0 [m]

    /// Drape coefficient: shadow of the hanging ring over the area of the ring [%].
    [[nodiscard]] double coefficient() const {
        double twice = 0;
        for (std::size_t i = 0; i < rim.size(); ++i) {
            const Vec3 &a = rim[i], &b = rim[(i + 1) % rim.size()];
            twice += a.x * b.z - b.x * a.z;
        }
        const double held = pi * support * support;
        return 100 * (std::abs(twice) / 2 - held) / (pi * specimen * specimen - held);
    }
    /// Of the part of the rim's height that goes round so many times [–].
    [[nodiscard]] std::complex<double> wave(int times) const {
        std::complex<double> sum = 0;
        for (const Vec3& x : rim) sum += x.y * std::polar(1.0, times * std::atan2(x.z, x.x));
        return sum;
    }
    /// How often the rim passes its mean height on its way up.
    [[nodiscard]] int folds() const {
        double mean = 0;
        for (const Vec3& x : rim) mean += x.y / static_cast<double>(rim.size());
        int count = 0;
        for (std::size_t i = 0; i < rim.size(); ++i) count += rim[i].y < mean && rim[(i + 1) % rim.size()].y >= mean;
        return count;
    }
};

struct Disc {
    Fabric fabric;
    double spacing = 0.01; ///< [m]
    double grain = 0;      ///< warp from the disc's own y [rad]
    bool ring = false;     ///< only what hangs, hinged to the edge of the support: no step of the grid holds it
    unsigned seed = 7;     ///< of the noise of 0.1 mm it starts with
};

constexpr int corners = 96; // of what stands for a circle

std::vector<Vec2> circle(double radius, int sense) {
    std::vector<Vec2> points;
    for (int k = 0; k < corners; ++k) {
        const double turn = sense * 2 * pi * k / corners;
        points.push_back({radius * std::cos(turn), radius * std::sin(turn)});
    }
    return points;
}

Drape drapeOf(Findings& found, const Disc& disc) {
    pattern::Pattern pattern;
    Fabric cloth = disc.fabric;
    cloth.id = material::FabricId("cloth");
    pattern.fabrics.push_back(std::move(cloth));
    pattern::Piece piece = polygonPiece("disc", circle(specimen, 1), disc.spacing);
    if (disc.ring) {
        pattern::Contour hole = polygonPiece("hole", circle(support, -1), disc.spacing).outline;
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
        const double noise = 1e-4 * (static_cast<double>(random()) / std::mt19937::max() - 0.5);
        state.positions.push_back({flat[p].x, radius < support ? 0 : noise, -flat[p].y});
        if (radius < support + 1e-6) model.pinned.push_back(p);
        if (radius > specimen * std::cos(pi / corners) - 1e-6) rim.push_back({std::atan2(flat[p].y, flat[p].x), p});
    }
    cloth::doubleBendingAtClampedRows(model);
    const auto xpbd = dynamics::makeIntegrator(dynamics::Method::xpbd, model, {.damping = 3});
    for (int frame = 0; frame < 120 && !found.stopped(); ++frame) found.ran(xpbd->step(state, 1.0 / 60, downward));
    const auto rest = dynamics::solveStatic(model, state, downward, {}, {.maximumIterations = 1000});
    if (found.ran(rest) && !rest->newton.converged) found.stop("The drape did not come to rest.");
    std::ranges::sort(rim);
    Drape drape;
    for (const auto& [angle, p] : rim) drape.rim.push_back(state.positions[p]);
    return drape;
}

/// A weave of 0.2 kg/m² with a bending length of 20 mm, the median of measured fabrics: 10 mm shows its folds.
Fabric drapingWeave() {
    Fabric fabric = unequalWeave();
    fabric.warpStiffness = fabric.weftStiffness = 800;
    fabric.shearStiffness = 40;
    fabric.warpBending = fabric.weftBending = 16e-6;
    fabric.biasBending = 13e-6;
    return fabric;
}

void v29Cusick(Findings& found) {
    const Fabric fabric = drapingWeave();
    const Drape coarse = drapeOf(found, {fabric, 0.01}), fine = drapeOf(found, {fabric, 0.005});
    if (found.stopped()) return;
    found.atMost(fmt::format("drape coefficient {:.1f} % of {} folds at 10 mm, {:.1f} % of {} at 5 mm: difference",
                             coarse.coefficient(), coarse.folds(), fine.coefficient(), fine.folds()),
                 2, std::abs(coarse.coefficient() - fine.coefficient()));
    found.within("the same at 5 mm: folds, 4 to 8", 6, fine.folds(), 2.0 / 6);
    Fabric stiffer = fabric;
    for (double* b : {&stiffer.warpBending, &stiffer.weftBending, &stiffer.biasBending}) *b *= 4;
    found.atMost("its coefficient less that of cloth four times as stiff to bend", 0,
                 coarse.coefficient() - drapeOf(found, {stiffer, 0.01}).coefficient());
    Fabric tighter = fabric;
    tighter.shearStiffness *= 4;
    found.atMost("its coefficient less that of cloth four times as stiff to shear", 0,
                 coarse.coefficient() - drapeOf(found, {tighter, 0.01}).coefficient());
    Fabric board = fabric;
    for (double* b : {&board.warpBending, &board.weftBending, &board.biasBending}) *b *= 1e4;
    found.within("coefficient of a board [%]", 100, drapeOf(found, {board, 0.01}).coefficient(), 0.01);
}

/// Isotropic: C11 = 3G with C12 = C33 = G, B in every direction.
Fabric isotropicCloth() {
    Fabric fabric = unequalWeave();
    fabric.shearStiffness = 75;
    fabric.warpStiffness = fabric.weftStiffness = 200;
    fabric.warpBending = fabric.weftBending = fabric.biasBending = 10e-6;
    return fabric;
}

void v31MeshBias(Findings& found) {
    double least = 100, most = 0;
    std::string each;
    for (const double degrees : {0.0, 22.5, 45.0}) {
        const double coefficient =
            drapeOf(found, {.fabric = isotropicCloth(), .grain = degrees * pi / 180, .ring = true}).coefficient();
        least = std::min(least, coefficient);
        most = std::max(most, coefficient);
        each += fmt::format("{}{:.2f}", each.empty() ? "" : ", ", coefficient);
    }
    found.atMost(fmt::format("isotropic ring, grid turned by 0, 22.5, 45°: coefficients {} %", each), 1, most - least);
}

void v31PlacesOfFolds(Findings& found) {
    // Where the folds lie, as angles of their wave that the four-fold symmetry of a grid cannot tell apart.
    constexpr int runs = 16;
    std::complex<double> sum = 0;
    for (unsigned seed = 1; seed <= runs && !found.stopped(); ++seed) {
        const Drape drape = drapeOf(found, {.fabric = isotropicCloth(), .ring = true, .seed = seed});
        const int folds = std::max(1, drape.folds()), alike = std::lcm(folds, 4) / folds;
        sum += std::polar(1.0, alike * std::arg(drape.wave(folds)));
    }
    // Of phases that lie at random it exceeds 0.53 once in a hundred times (Rayleigh).
    found.atMost(fmt::format("isotropic ring: how alike the places of the folds are in {} runs", runs), 0.53,
                 std::abs(sum) / runs);
}

} // namespace

std::vector<Case> drapeCases() {
    return {{"V29", "drape", "Cusick drape", v29Cusick},
            {"V31", "drape", "mesh bias of a drape", v31MeshBias},
            {"V31", "drape", "places of folds", v31PlacesOfFolds,
             "All runs fold at the same places of the grid. On an isotropic ring nothing else prefers a place, so the "
             "least bias of the mesh decides; how much it drapes does not depend on it."}};
}

} // namespace toile::study::validation
