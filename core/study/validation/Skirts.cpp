// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/validation/Cases.h"
#include "core/study/validation/DrapedDisc.h"
#include "core/study/validation/Sheets.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

/// Skirts cut as rings.
namespace toile::study::validation {
namespace {

constexpr double pi = std::numbers::pi;

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

std::vector<Case> skirtCases() {
    return {
        {"V33", "skirts", "circle skirt in woven cloth", v33CircleSkirt,
         "At 20 mm, the bending length of this cloth, a fold across one diagonal of a cell shortens that diagonal's "
         "chord, which its springs take for shear, and resist: the bias is drawn up along the fold."}};
}

} // namespace toile::study::validation
