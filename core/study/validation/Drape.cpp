// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/validation/Cases.h"
#include "core/study/validation/DrapedDisc.h"
#include "core/study/validation/Sheets.h"

#include <algorithm>
#include <fmt/format.h>
#include <numbers>
#include <numeric>

/// Cusick's test.
namespace toile::study::validation {
namespace {

constexpr double pi = std::numbers::pi;

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

} // namespace

std::vector<Case> drapeCases() {
    return {{"V29", "drape", "Cusick drape", v29Cusick},
            {"V31", "drape", "mesh bias of a drape", v31MeshBias},
            {"V31", "drape", "places of folds", v31PlacesOfFolds,
             "Rings that are all but level fold at the same places of the grid: nothing else prefers a place, so the "
             "least bias of the mesh decides; how much they drape does not depend on it."}};
}

} // namespace toile::study::validation
