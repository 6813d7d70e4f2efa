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
#include <optional>

/// Discs of cloth that hang over a smaller support: Cusick's test.
namespace toile::study::validation {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double specimen = 0.15, support = 0.09; // radii [m], BS 5058

/// A draped disc.
struct Drape {
    std::vector<Vec3> rim;  ///< in order round the axis of the support, which is level at y = 0 [m]
    std::vector<Vec2> flat; ///< where each particle was before [m]
    std::vector<Vec3> positions;

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
    [[nodiscard]] double meanHeight() const {
        double mean = 0;
        for (const Vec3& x : rim) mean += x.y / static_cast<double>(rim.size());
        return mean;
    }
    /// Along the cloth from the support to the rim, by the particles that lay in this direction [m]: the sum of arcs,
    /// as curved as three particles in a row say. Chords would be too short by more than the weight of the cloth
    /// stretches.
    [[nodiscard]] double lengthTowards(double angle) const {
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
    /// How often the rim passes its mean height on its way up.
    [[nodiscard]] int folds() const {
        const double mean = meanHeight();
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
    unsigned seed = 7;     ///< of the noise it starts with
    double noise = 1e-4;   ///< how uneven it is laid [m]
    double inner = support, outer = specimen; ///< radii [m]
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
    Drape drape{.rim = {}, .flat = flat, .positions = state.positions};
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

/// How alike the places are where rings fold that are laid so uneven: from 0, by chance, to 1, all in one place.
double likenessOfPlaces(Findings& found, int runs, double noise) {
    // The places as angles of the folds' wave that the four-fold symmetry of a grid cannot tell apart.
    std::complex<double> sum = 0;
    for (int seed = 1; seed <= runs && !found.stopped(); ++seed) {
        const Drape drape = drapeOf(
            found, {.fabric = isotropicCloth(), .ring = true, .seed = static_cast<unsigned>(seed), .noise = noise});
        const int folds = std::max(1, drape.folds()), alike = std::lcm(folds, 4) / folds;
        sum += std::polar(1.0, alike * std::arg(drape.wave(folds)));
    }
    return std::abs(sum) / runs;
}

void v31PlacesOfFolds(Findings& found) {
    // Of phases that lie at random it exceeds 0.53 once in a hundred times (Rayleigh).
    constexpr int runs = 16;
    for (const double millimetres : {0.1, 1.0})
        found.atMost(fmt::format("isotropic ring, uneven by {:g} mm: how alike the places of the folds are in {} runs",
                                 millimetres, runs),
                     0.53, likenessOfPlaces(found, runs, 1e-3 * millimetres));
}

/// A ring of woven cloth that gives way to shear, hinged to a waist of radius 80 mm, 220 mm long. Folds tilt the lines
/// from waist to hem by more than the bias gives, so their lengths are compared, not where they end.
void v33CircleSkirt(Findings& found) {
    Fabric fabric = drapingWeave();
    fabric.shearStiffness = 10;
    std::optional<Drape> coarser;
    for (const int millimetres : {20, 10, 5}) {
        const Drape skirt = drapeOf(
            found, {.fabric = fabric, .spacing = 1e-3 * millimetres, .ring = true, .inner = 0.08, .outer = 0.3});
        if (found.stopped()) return;
        double bias = 0, grain = 0;
        for (int quarter = 0; quarter < 4; ++quarter) {
            grain += skirt.lengthTowards(quarter * pi / 2) / 4;
            bias += skirt.lengthTowards((quarter + 0.5) * pi / 2) / 4;
        }
        const std::string name = fmt::format("circle skirt at {} mm", millimetres);
        found.atMost(fmt::format("{}: waist to hem {:.2f} mm on the grain less {:.2f} mm on the bias [mm]", name,
                                 1000 * grain, 1000 * bias),
                     0, 1000 * (grain - bias));
        if (coarser) {
            found.within(fmt::format("{}: mean drop of the hem [m], as on the coarser mesh", name),
                         -coarser->meanHeight(), -skirt.meanHeight(), 0.03);
            found.atMost(fmt::format("{}: {} folds; more or fewer than on the coarser mesh", name, skirt.folds()), 1,
                         std::abs(skirt.folds() - coarser->folds()));
        }
        coarser = skirt;
    }
}

} // namespace

std::vector<Case> drapeCases() {
    return {{"V29", "drape", "Cusick drape", v29Cusick},
            {"V33", "drape", "circle skirt in woven cloth", v33CircleSkirt,
             "20 mm is the bending length of this cloth: half of it shows its folds, and from there on their number "
             "stays."},
            {"V31", "drape", "mesh bias of a drape", v31MeshBias},
            {"V31", "drape", "places of folds", v31PlacesOfFolds,
             "Rings that are all but level fold at the same places of the grid: nothing else prefers a place, so the "
             "least bias of the mesh decides; how much they drape does not depend on it."}};
}

} // namespace toile::study::validation
