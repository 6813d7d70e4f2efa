// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/validation/Cases.h"
#include "core/study/validation/DrapedDisc.h"
#include "core/study/validation/Sheets.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <numeric>
#include <optional>

/// Cusick's test, and skirts cut as rings.
namespace toile::study::validation {
namespace {

constexpr double pi = std::numbers::pi;

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

/// Medians of skirts that are laid unevenly in different ways: into how many folds one falls is chance.
struct Skirts {
    double drop = 0;        ///< of the hem [m]
    double grain = 0;       ///< waist to hem along warp and weft [m]
    double bias = 0;        ///< the same at 45° to them [m]
    double longerThere = 0; ///< on the bias than on the grain, of one skirt [m]
    double folds = 0;
};

double medianOf(std::vector<double> values) {
    const auto middle = values.begin() + std::ssize(values) / 2;
    std::ranges::nth_element(values, middle);
    return *middle;
}

Skirts skirtsOf(Findings& found, const Fabric& fabric, double spacing, int runs) {
    std::array<std::vector<double>, 5> all;
    for (int seed = 1; seed <= runs && !found.stopped(); ++seed) {
        const Drape skirt = drapeOf(found, {.fabric = fabric,
                                            .spacing = spacing,
                                            .ring = true,
                                            .seed = static_cast<unsigned>(seed),
                                            .inner = 0.08,
                                            .outer = 0.3});
        double grain = 0, bias = 0;
        for (int quarter = 0; quarter < 4; ++quarter) {
            grain += skirt.lengthTowards(quarter * pi / 2) / 4;
            bias += skirt.lengthTowards((quarter + 0.5) * pi / 2) / 4;
        }
        const std::array values{-skirt.meanHeight(), grain, bias, bias - grain, static_cast<double>(skirt.folds())};
        for (std::size_t i = 0; i < all.size(); ++i) all[i].push_back(values[i]);
    }
    return {medianOf(all[0]), medianOf(all[1]), medianOf(all[2]), medianOf(all[3]), medianOf(all[4])};
}

/// A ring of woven cloth that gives way to shear, hinged to a waist of radius 80 mm, 220 mm long. Folds tilt the lines
/// from waist to hem by more than the bias gives, so their lengths are compared, not where they end.
void v33CircleSkirt(Findings& found) {
    Fabric fabric = drapingWeave();
    fabric.shearStiffness = 10;
    std::optional<Skirts> coarser;
    for (const auto& [millimetres, runs] : {std::pair{20, 9}, {10, 9}, {5, 1}}) { // there they hardly differ
        const Skirts skirts = skirtsOf(found, fabric, 1e-3 * millimetres, runs);
        if (found.stopped()) return;
        const std::string name =
            fmt::format("circle skirt at {} mm{}", millimetres, runs > 1 ? fmt::format(", median of {}", runs) : "");
        found.atMost(fmt::format("{}: waist to hem {:.2f} mm on the bias, {:.2f} mm on the grain: shorter there [mm]",
                                 name, 1000 * skirts.bias, 1000 * skirts.grain),
                     0, -1000 * skirts.longerThere);
        if (coarser) {
            found.within(fmt::format("{}: mean drop of the hem [m], as on the coarser mesh", name), coarser->drop,
                         skirts.drop, 0.03);
            found.atMost(fmt::format("{}: {:g} folds; more or fewer than on the coarser mesh", name, skirts.folds), 1,
                         std::abs(skirts.folds - coarser->folds));
        }
        coarser = skirts;
    }
}

} // namespace

std::vector<Case> drapeCases() {
    return {
        {"V29", "drape", "Cusick drape", v29Cusick},
        {"V33", "drape", "circle skirt in woven cloth", v33CircleSkirt,
         "At 20 mm, the bending length of this cloth, a fold across one diagonal of a cell shortens that diagonal's "
         "chord, which its springs take for shear, and resist: the bias is drawn up along the fold."},
        {"V31", "drape", "mesh bias of a drape", v31MeshBias},
        {"V31", "drape", "places of folds", v31PlacesOfFolds,
         "Rings that are all but level fold at the same places of the grid: nothing else prefers a place, so the "
         "least bias of the mesh decides; how much they drape does not depend on it."}};
}

} // namespace toile::study::validation
